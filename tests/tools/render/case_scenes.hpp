// Scenes that a user would write, and what the program prints of their frames.
#pragma once

#include "tools/render/frame_warnings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

namespace umbra78::tools::test {

inline constexpr const char* perspective_observer =
    "[observer]\nprojection = \"perspective\"\nazimuth = 20\nelevation = 25\ndistance = 8\n";
inline constexpr const char* near_lamp =
    "[light]\nkind = \"point\"\nposition = [-1.5, 2.2, 0.8]\n";
inline constexpr const char* table_with_two_balls =
    "[[plane]]\norigin = [-3, 0, 3]\nu = [6, 0, 0]\nv = [0, 0, -6]\n"
    "[[sphere]]\ncentre = [-0.6, 0.6, 0]\nradius = 0.6\n"
    "[[sphere]]\ncentre = [0.9, 0.5, -0.6]\nradius = 0.5\n";

inline std::string first_natural_scene() {
    return std::string(perspective_observer) + near_lamp + table_with_two_balls;
}

// A frame with its truth and its warnings. It stays where it is: the job reads the scene's spans.
struct DrawnCase {
    LoadedScene scene;
    std::unique_ptr<RenderJob> job;
    std::optional<SceneTruth> truth;
    std::optional<ShadowReport> report;
    Warnings warnings;

    explicit DrawnCase(const std::string& text, const std::vector<std::string>& set = {})
        : scene(parse_scene(text, "a.toml", set)) {
        job = std::make_unique<RenderJob>(scene.view(), scene.settings);
        job->render();
        truth = trace(scene);
        if (truth) {
            const std::vector<std::uint8_t> visible = job->visible();
            const Buffer depths = job->buffer(Plane::observer_z);
            report = tools::report(*truth, {job->bytes(Plane::filtered), visible},
                                   widened(light_texel_band(*truth), *truth, scene.settings),
                                   &depths);
        }
        warnings = frame_warnings(scene, *job, report);
    }
    DrawnCase(const DrawnCase&) = delete;

    std::vector<std::string> keys() const {
        std::vector<std::string> all;
        for (const Warning& w : warnings) all.push_back(w.key);
        return all;
    }
    // The measured figure; fails, and is 0, where there is no such warning.
    double measured(const std::string& key) const {
        for (const Warning& w : warnings)
            if (w.key == key) return w.measured;
        ADD_FAILURE() << "no warning " << key;
        return 0;
    }
    std::string line(const std::string& key) const {
        for (const Warning& w : warnings)
            if (w.key == key) return w.line;
        return "";
    }
    std::vector<std::string> hashes() const {
        std::vector<std::string> all;
        for (const PlaneOf& plane : job->planes()) all.push_back(hash_of(job->buffer(plane)));
        return all;
    }
};

}  // namespace umbra78::tools::test
