#include "tools/web/polygon_truth.hpp"

#include "raster/dice.hpp"
#include "tools/render/render_job.hpp"
#include "tools/scene/checks.hpp"

#include <cstddef>
#include <span>

namespace umbra78::tools::web {
namespace {

// A patch is diced into 2^levels x 2^levels cells of two facets: as finely as a second or two
// allow.
constexpr std::size_t most_facets = 200'000;

int dice_levels(std::size_t patches) {
    int levels = raster::max_dice_levels;
    while (levels > 0 && (patches << (2 * levels + 1)) > most_facets) --levels;
    return levels;
}

// Truth is the same whatever the scene's machine is: of its settings the picture's size alone.
shadow::Settings exact_settings(const LoadedScene& of) {
    shadow::Settings s;
    s.form = shadow::Form::irregular;
    s.machine.xy_bits = of.settings.machine.xy_bits;
    s.dice_levels = dice_levels(of.patches.size());
    return s;
}

}  // namespace

std::string why_no_polygon_truth(const LoadedScene& scene) {
    if (scene.stream) return "a stream's surfaces are not held";
    if (!scene.lights.front().parts.empty())
        return "exact truth of polygons is of a light at a point or at infinity, and this light "
               "has an area or sectors";
    shadow::FrameMatrices matrices;
    const shadow::FrameStatus status =
        shadow::load_matrices(scene.view(), exact_settings(scene), matrices);
    return status == shadow::FrameStatus::ok ? "" : explain(status);
}

std::optional<SceneTruth> polygon_truth(const LoadedScene& scene) {
    if (!why_no_polygon_truth(scene).empty()) return std::nullopt;
    RenderJob job(scene.view(), exact_settings(scene));
    job.draw_light();
    job.draw_observer();
    job.cast_shadows();
    SceneTruth made{};
    made.closed_form = false;
    made.truth.size = scene.settings.machine.size_px();
    made.truth.visible = job.visible();
    const std::span<const std::uint8_t> mask = job.bytes(Plane::mask);
    made.truth.lit.resize(mask.size());
    made.unlit_side.assign(mask.size(), 1);
    for (std::size_t at = 0; at < mask.size(); ++at) made.truth.lit[at] = mask[at] == 0;
    for (std::size_t c = 0; c < (job.coloured() ? 3u : 1u); ++c) {
        const std::span<const std::uint8_t> direct = job.bytes({Plane::direct, 0, c});
        for (std::size_t at = 0; at < direct.size(); ++at)
            if (direct[at] != 0) made.unlit_side[at] = 0;
    }
    return made;
}

}  // namespace umbra78::tools::web
