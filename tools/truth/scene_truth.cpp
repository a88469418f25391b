#include "tools/truth/scene_truth.hpp"

#include "tools/truth/cut_truth.hpp"
#include "tools/truth/patch_truth.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace umbra78::tools {
namespace {

double q16(std::int64_t word) { return std::ldexp(static_cast<double>(word), -16); }

Real3 real(const raster::World& w) { return {q16(w.x), q16(w.y), q16(w.z)}; }

Real3 real(const raster::Axis& axis) {
    const auto q30 = [](std::int32_t word) { return std::ldexp(word, -30); };
    return {q30(axis[0]), q30(axis[1]), q30(axis[2])};
}

TruthScene truth_scene(const LoadedScene& scene) {
    TruthScene made;
    for (const raster::Sphere& s : scene.spheres)
        made.spheres.push_back({real(s.centre), q16(s.radius)});
    for (const raster::Plane& p : scene.planes)
        made.planes.push_back({real(p.origin), real(p.u), real(p.v)});
    return made;
}

// The light stands where its view's eye is, or infinitely far along its view's back.
constexpr int area_points_a_side = 32;

TruthLight truth_light(const SceneLight& of) {
    const raster::View& light = of.view;
    const Real3 back = real(light.axes.back);
    const bool point = light.projection == raster::Projection::perspective;
    TruthLight made{point, back, along(real(light.target), point ? q16(light.distance) : 0, back)};
    if (!of.has_area()) return made;
    made.side_u = times(q16(of.side), real(light.axes.right));
    made.side_v = times(q16(of.side), real(light.axes.up));
    made.points_a_side = area_points_a_side;
    return made;
}

// The observer's view with all that lies before the eye, or in the whole depth of the scene.
TruthView without_cut(const LoadedScene& scene, TruthView view) {
    const raster::DepthRange range = raster::depth_range(scene.observer, scene.surfaces());
    const double beyond = 1 + view.extent;
    view.near_depth = view.perspective ? 0 : std::min(view.near_depth, q16(range.min) - beyond);
    view.far_depth = std::max(view.far_depth, q16(range.max) + beyond);
    return view;
}

// The surfaces by their patches: TruthScene's numbers, then the free patches' and the facets'.
std::optional<PatchTruth> patch_truth(const LoadedScene& scene, const TruthView& view,
                                      const TruthLight& light) {
    auto made = trace_patches(scene.surfaces(), view, light);
    if (!made) return made;
    const auto spheres = static_cast<std::int32_t>(scene.spheres.size());
    const std::int32_t of_spheres = spheres * raster::patches_per_sphere;
    for (std::int32_t& surface : made->truth.surface)
        if (surface != no_surface)
            surface = surface < of_spheres ? surface / raster::patches_per_sphere
                                           : surface - of_spheres + spheres;
    return made;
}

}  // namespace

TruthView truth_view(const raster::View& view, int size_px) {
    return {view.projection == raster::Projection::perspective,
            real(view.target),
            {real(view.axes.right), real(view.axes.up), real(view.axes.back)},
            q16(view.extent),
            q16(view.distance),
            q16(view.near_depth),
            q16(view.far_depth),
            size_px};
}

namespace {

std::optional<SceneTruth> trace(const LoadedScene& scene, std::size_t light, bool cut) {
    const SceneLight& of = scene.lights[light];
    const int size = scene.settings.machine.size_px();
    SceneTruth made{truth_scene(scene), truth_view(scene.observer, size),
                    truth_view(of.view, size), truth_light(of), {}, {}};
    const TruthView seen = cut ? made.observer : without_cut(scene, made.observer);
    if (!scene.has_closed_form()) {
        auto traced = patch_truth(scene, seen, made.light);
        if (!traced) return std::nullopt;
        made.closed_form = false;
        made.tessellation_error = traced->estimated_error;
        made.truth = std::move(traced->truth);
    } else {
        made.truth = trace(made.scene, seen, made.light);
    }
    const auto spheres = static_cast<std::int32_t>(scene.spheres.size());
    made.unlit_side.resize(made.truth.visible.size());
    for (std::size_t at = 0; at < made.unlit_side.size(); ++at)
        made.unlit_side[at] = made.truth.surface[at] >= spheres && made.truth.n_dot_l[at] <= 0;
    return made;
}

}  // namespace

std::optional<SceneTruth> trace(const LoadedScene& scene, std::size_t light) {
    return trace(scene, light, false);
}

std::optional<SceneTruth> trace_within_depths(const LoadedScene& scene) {
    return trace(scene, 0, true);
}

double filter_radius_px(const shadow::Settings& settings) {
    return settings.low_pass_passes + (settings.dequantize_passes > 0 ? 1 : 0);
}

Band light_texel_band(const SceneTruth& truth) {
    Band band = truth.closed_form ? light_texel_band(truth.scene, truth.light, truth.light_view,
                                                     truth.truth, 0)
                                  : seen_texel_band(truth.light_view, truth.truth);
    for (std::size_t at = 0; at < band.size(); ++at) band[at] |= truth.unlit_side[at];
    return band;
}

Band widened(const Band& band, const SceneTruth& truth, const shadow::Settings& settings) {
    return widened(band, truth.truth.size, filter_radius_px(settings));
}

ShadowReport report(const SceneTruth& truth, const MachineMask& mask, const Band& band,
                    const Buffer* depths) {
    ShadowReport made{shadow_error(truth.truth, mask, truth.unlit_side),
                      shadow_error(truth.truth, mask, band),
                      graded_error(truth.truth, mask, truth.unlit_side),
                      edge_distance(truth.truth, mask, truth.unlit_side),
                      isolated_pixels(mask, truth.truth.size),
                      mask.threshold,
                      truth.closed_form ? std::nullopt : std::optional(truth.tessellation_error)};
    for (std::size_t at = 0; at < truth.unlit_side.size(); ++at)
        made.unlit_side += truth.unlit_side[at] && truth.truth.visible[at] && mask.drawn(at);
    if (depths == nullptr) return made;
    const auto covered = coverage_image(truth.truth, *depths, truth.observer);
    const auto error = error_image(truth.truth, mask, truth.unlit_side);
    made.coverage = coverage(truth.truth, *depths, covered);
    for (std::size_t at = 0; at < covered.size(); ++at)
        made.wrong_pixels += covered[at] != Covered::right || error[at] != 0;
    return made;
}

}  // namespace umbra78::tools
