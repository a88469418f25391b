#include "tools/render/frame_warnings.hpp"

#include "tools/io/console.hpp"
#include "tools/scene/view_fit.hpp"
#include "tools/scene/view_keys.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace umbra78::tools {
namespace {

void warn_of_blocks(std::uint64_t dropped, const std::string& view, const std::string& loses,
                    Warnings& warnings) {
    if (dropped == 0) return;
    warnings.push_back(
        {"dropped_blocks", static_cast<double>(dropped),
         fmt::format("{} blocks of the {}'s view were dropped, and {}: they are too large for its "
                     "window or reach its eye; raise {}.extent or {}.near", dropped, view, loses,
                     view, view)});
}

// Of a shadow that is drawn on the ground.
void warn_of_flat_blocks(std::uint64_t dropped, const std::string& light, Warnings& warnings) {
    if (dropped == 0) return;
    warnings.push_back({"dropped_blocks", static_cast<double>(dropped),
                        fmt::format("{} blocks of the {}'s shadow were dropped: they reach as high "
                                    "as the light, or their shadow reaches the observer's eye; "
                                    "move the light or the observer", dropped, light)});
}

void warn_of_coverage(const Coverage& c, bool is_warned, Warnings& warnings) {
    const auto add = [&](const char* key, int pixels, const std::string& what) {
        if (pixels == 0) return;
        warnings.push_back({key, static_cast<double>(pixels),
                            fmt::format("{} pixels {}; {}", pixels, what,
                                        is_warned ? "see the warnings above"
                                                  : "see them with --error FILE.png")});
    };
    add("missing", c.missing,
        fmt::format("are missing in the picture, of {} that exact truth sees", c.seen));
    add("extra", c.extra, fmt::format("show a surface that exact truth does not see, of {} drawn",
                                      c.drawn));
    add("misplaced", c.misplaced,
        fmt::format("show another depth than exact truth sees there, of {} drawn", c.drawn));
}

}  // namespace

Warnings frame_warnings(const LoadedScene& scene, const RenderJob& job,
                        const std::optional<ShadowReport>& report) {
    Warnings warnings = scene.warnings;
    const std::size_t of_scene = warnings.size();
    warn_of_blocks(job.counts().observer.unresolved, "observer", "are not in the picture",
                   warnings);
    std::size_t next = 0;  // of the lights' depth maps
    for (std::size_t l = 0; l < scene.lights.size(); ++l) {
        std::uint64_t dropped = 0;
        for (std::size_t k = 0; k < scene.lights[l].views().size(); ++k)
            dropped += job.counts().lights[next++].map.unresolved;
        const std::string name = name_of_light(l, scene.lights.size());
        if (shadow::map_layers(scene.settings) > 0)
            warn_of_blocks(dropped, name, "cast no shadow", warnings);
        else
            warn_of_flat_blocks(dropped, name, warnings);
    }
    const std::vector<std::uint8_t> visible = job.visible();
    const bool nothing = std::count(visible.begin(), visible.end(), 1) == 0;
    const bool drawn = job.counts().observer.patches + job.counts().observer.facets > 0;
    if (scene.stream && drawn && nothing) {
        warnings.push_back({"nothing_visible", 0,
                            "0 pixels show a surface: the stream is beside the picture or smaller "
                            "than a pixel; set observer.extent and observer.target"});
    } else if (!scene.surfaces().empty() && nothing) {
        raster::View whole = scene.observer;
        whole.extent = fitted_extent(whole, scene.surfaces());
        warnings.push_back(
            {"nothing_visible", 0,
             fmt::format("0 pixels show a surface: the scene is beside the picture or smaller than "
                         "a pixel; set observer.extent = {:.6g} (it is {:.6g}), or leave extent "
                         "and target out", std::ldexp(whole.extent, -16),
                         std::ldexp(scene.observer.extent, -16))});
    }
    if (report && report->coverage)
        warn_of_coverage(*report->coverage, !warnings.empty(), warnings);
    for (std::size_t k = of_scene; k < warnings.size(); ++k)
        warnings[k].line.insert(0, scene.name + ": ");
    return warnings;
}

nlohmann::ordered_json to_json(const Warnings& warnings) {
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (const Warning& w : warnings)
        json.push_back({{"key", w.key}, {"measured", w.measured}, {"line", w.line}});
    return json;
}

void print_warnings(const Warnings& warnings) {
    for (const Warning& w : warnings) print_warning(w.line);
}

}  // namespace umbra78::tools
