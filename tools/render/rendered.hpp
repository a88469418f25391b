// A scene drawn and measured: what `umbra78 render --json` prints, and what the module for Python
// gives.
#pragma once

#include "tools/render/render_job.hpp"
#include "tools/render/report.hpp"
#include "tools/render/thread_pool.hpp"
#include "tools/scene/scene_file.hpp"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>
#include <vector>

namespace umbra78::tools {

struct RenderOptions {
    bool truth = true;      // the errors against exact geometry
    std::string error_map;  // the file that it is for; "": none is made
    int threads = 1;        // that draw the frame; 0: one for each processor
};

// Its job points into its scene, so it stays where it is made.
struct Rendered {
    LoadedScene scene;
    ThreadPool pool;
    RenderJob job;
    // By light; empty: none was asked for; nothing where there is none.
    std::vector<std::optional<SceneTruth>> truths;
    std::vector<std::optional<ShadowReport>> errors;
    std::vector<ShadowReport> on_ground;  // by light, of its pixels alone; empty without a ground
    std::vector<std::uint8_t> map;  // the error map, if it is asked for
    Warnings warnings;
    std::uint64_t patches, triangles;

    // Throws SceneError.
    Rendered(LoadedScene, const RenderOptions&);
    Rendered(const Rendered&) = delete;
    Rendered& operator=(const Rendered&) = delete;

    // The first light's.
    std::optional<ShadowReport> error() const {
        return errors.empty() ? std::nullopt : errors.front();
    }
    // Where there is none, nothing is compared and there is no bias.
    bool has_map() const { return shadow::map_layers(job.settings()) > 0; }

private:
    void draw_stream();
    void compare(const RenderOptions&, std::size_t light);
};

// Why a scene that is not of spheres and planes alone has no truth.
const char* no_truth_because(const LoadedScene&);

// The most memory that the program has had so far.
std::uint64_t peak_bytes();

// Sizes, hashes, errors, bias, the machine's cycles, the host's times, settings, warnings.
nlohmann::ordered_json to_json(const Rendered&);

}  // namespace umbra78::tools
