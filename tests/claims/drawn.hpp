// A scene as text, drawn by the machine, and its exact truth.
#pragma once

#include "tools/render/render_job.hpp"
#include "tools/truth/scene_truth.hpp"

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace umbra78::claims {

inline std::unique_ptr<tools::SceneTruth> truth_of(const std::string& text) {
    auto truth = tools::trace(tools::parse_scene(text, "claim", {}));
    if (!truth) throw std::runtime_error("the claim's scene has no closed form");
    return std::make_unique<tools::SceneTruth>(std::move(*truth));
}

// It stays where it is: the job reads the scene's spans.
struct Drawn {
    explicit Drawn(const std::string& text)
        : scene(tools::parse_scene(text, "claim", {})), job(scene.view(), scene.settings) {
        job.render();
        visible = job.visible();
    }
    Drawn(const Drawn&) = delete;
    Drawn& operator=(const Drawn&) = delete;

    tools::MachineMask mask(tools::Plane plane = tools::Plane::mask) const {
        return {job.bytes(plane), visible};
    }

    tools::LoadedScene scene;
    tools::RenderJob job;
    std::vector<std::uint8_t> visible;
};

}  // namespace umbra78::claims
