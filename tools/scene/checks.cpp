#include "tools/scene/checks.hpp"

#include "tools/scene/open_surfaces.hpp"
#include "tools/scene/table_reader.hpp"
#include "tools/scene/view_fit.hpp"
#include "tools/scene/view_keys.hpp"
#include "tools/scene/visible_depths.hpp"
#include "tools/scene/word_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace umbra78::tools {
namespace {

std::string decimal(std::int64_t q16) {
    return fmt::format("{:.6g}", static_cast<double>(q16) / world_one);
}

constexpr const char *loses_shadow = "and may cast no shadow", *loses_sight = "and are cut off";

raster::View fitted_view(raster::View view, const Surfaces& surfaces) {
    view.extent = fitted_extent(view, surfaces);
    raster::fit_depth(view, raster::depth_range(view, surfaces));
    return view;
}

// A near plane of four digits before the nearest depth, a far one behind the farthest.
std::string before(double depth, bool perspective) {
    const double near = perspective ? depth * 63 / 64 : depth - 0.01 * std::abs(depth);
    const double unit = std::pow(10, std::floor(std::log10(std::max(std::abs(near), 1e-9))) - 3);
    const double rounded = std::floor(near / unit) * unit;
    return fmt::format("{:.4g}", perspective ? std::max(rounded, std::ldexp(1, -16)) : rounded);
}

std::string behind(double depth) {
    const double far = depth + 0.02 * std::abs(depth);
    const double unit = std::pow(10, std::floor(std::log10(std::max(std::abs(far), 1e-9))) - 3);
    return fmt::format("{:.4g}", std::ceil(far / unit) * unit);
}

// What near and far cut off of what the view's window shows. `loses` says what a cut patch does;
// `fits` says whether near and far as they are fitted cut nothing off.
void warn_of_cut(const LoadedScene& scene, const raster::View& view, const CutDepths& cut,
                 std::uint64_t all, const std::string& name, const std::string& loses, bool fits,
                 Warnings& warnings) {
    const bool perspective = view.projection == raster::Projection::perspective;
    const auto add = [&](const char* key, std::size_t patches, const std::string& what,
                         const std::string& remedy) {
        warnings.push_back({key, static_cast<double>(patches),
                            fmt::format("{} of {} {} {} {}; {}{}", patches, all,
                                        kinds_of_surfaces(scene), what, loses, remedy,
                                        fits ? ", or leave near and far out" : "")});
    };
    if (cut.before > 0) {
        const bool by_far = perspective && view.near_depth == view.far_depth / 1024;
        add("near_plane", cut.before,
            fmt::format("are in the {}'s window from depth {:.4g} on, nearer than near = {}{},",
                        name, cut.nearest, decimal(view.near_depth),
                        by_far ? " (fitted: far / 1024)" : ""),
            fmt::format("set {}.near = {}", name, before(cut.nearest, perspective)));
    }
    if (cut.behind > 0)
        add("far_plane", cut.behind,
            fmt::format("are in the {}'s window to depth {:.4g}, farther than far = {},", name,
                        cut.farthest, decimal(view.far_depth)),
            fmt::format("set {}.far = {}", name, behind(cut.farthest)));
}

void warn_of_depths(const LoadedScene& scene, const raster::View& view, const std::string& name,
                    const std::string& loses, Warnings& warnings) {
    const CutDepths cut = cut_depths(view, scene.surfaces());
    if (!cut.any()) return;
    raster::View whole = view;
    raster::fit_depth(whole, raster::depth_range(view, scene.surfaces()));
    const bool fits = !cut_depths(whole, scene.surfaces()).any();
    warn_of_cut(scene, view, cut, scene.surfaces().count(), name, loses, fits, warnings);
}

// Some window shows every direction: what near and far cut is told of the sector that sees nearest.
void warn_of_sectors(const LoadedScene& scene, const SceneLight& light, const std::string& name,
                     Warnings& warnings) {
    const auto nearest = std::ranges::min_element(light.views(), {}, [&](const raster::View& v) {
        return cut_depths(v, scene.surfaces()).nearest;
    });
    warn_of_depths(scene, *nearest, name, loses_shadow, warnings);
}

void warn_of_light(const LoadedScene& scene, const raster::View& light, const std::string& name,
                   Warnings& warnings) {
    const std::size_t all = scene.surfaces().count();
    const Outside outside = count_outside(light, scene.surfaces());
    const raster::View whole = fitted_view(light, scene.surfaces());
    if (outside.window > count_outside(whole, scene.surfaces()).window)
        warnings.push_back(
            {"light_window", static_cast<double>(outside.window),
             fmt::format("{} of {} {} reach out of the {}'s picture and may cast no shadow; "
                         "{}.extent = {} holds them, or leave it out", outside.window, all,
                         kinds_of_surfaces(scene), name, name, decimal(whole.extent))});
    else if (outside.window > 0)
        warnings.push_back(
            {"light_window", static_cast<double>(outside.window),
             fmt::format("{} of {} {} lie beside or behind the {} and cast no shadow; "
                         "move {}.position out of the scene", outside.window, all,
                         kinds_of_surfaces(scene), name, name)});
    warn_of_depths(scene, light, name, loses_shadow, warnings);
}

// A sheet has no back face where its front faces the light.
void warn_of_open_surfaces(const LoadedScene& scene, Warnings& warnings) {
    if (scene.settings.map_depth != shadow::MapDepth::back ||
        shadow::map_layers(scene.settings) == 0)
        return;
    const std::uint64_t open = open_surfaces(scene.surfaces());
    if (open > 0)
        warnings.push_back(
            {"open_surfaces", static_cast<double>(open),
             fmt::format("{} of {} {} have an open border, and with map_depth = back they cast no "
                         "shadow where their front faces the light; close them, or set "
                         "map_depth = midpoint",
                         open, scene.surfaces().count(), kinds_of_surfaces(scene))});
}

void warn_of_observer(const LoadedScene& scene, Warnings& warnings) {
    const std::size_t before = warnings.size();
    warn_of_depths(scene, scene.observer, "observer", loses_sight, warnings);
    const std::size_t outside = count_outside(scene.observer, scene.surfaces()).window;
    if (warnings.size() == before && outside == scene.surfaces().count())
        warnings.push_back(
            {"observer_window", static_cast<double>(outside),
             fmt::format("every surface reaches out of the picture; observer.extent = {} shows the "
                         "whole scene, or leave it out",
                         decimal(fitted_view(scene.observer, scene.surfaces()).extent))});
}

}  // namespace

std::string explain(shadow::FrameStatus status) {
    using enum shadow::FrameStatus;
    switch (status) {
        case ok: return "";
        case not_built: return "this build leaves out a stage that the settings ask for";
        case spec_out_of_range: return "a width of the machine is out of its range";
        case observer_matrix:
            return "the observer's matrix does not fit the machine's words; bring its extent "
                   "nearer the scene's size";
        case light_matrix:
            return "the light's matrix does not fit the machine's words; bring its extent nearer "
                   "the scene's size";
        case shadow_matrix:
            return "the matrix from observer to light does not fit the machine's words; bring "
                   "their extents nearer each other, or lower the bias";
        case area_when_drawn:
            return "the correct form shades by a light or not, and has no light with an area or a "
                   "ramp; set form = \"post_process\", or kind = \"point\" and no ramp";
        case sectors_refused:
            return "only the post-process on the fixed-point machine sorts into sectors; set "
                   "form = \"post_process\" and arithmetic = \"fixed\", or kind = \"point\"";
        case no_ground:
            return "form = \"ground\" and \"blob\" cast shadows on one plane, and the scene names "
                   "none; write ground = \"on\" into a [[plane]], or set form = "
                   "\"post_process\"";
        case light_in_ground:
            return "a light lies in the plane of the ground, where its shadows have no end; move "
                   "it, or set form = \"post_process\"";
        case rival_of_stream:
            return "a rival of the depth map holds the scene's polygons, and a [stream] is not "
                   "held; set form = \"post_process\"";
        case too_wide_for_rival:
            return "a rival of the depth map has words of 22 bits, and a surface, the eye or a "
                   "lamp lies more than 2^21 pixels from the observer's target; raise "
                   "observer.extent, or set form = \"post_process\"";
        case bias_out_of_range: return "the bias is beyond 2^47 quanta; lower it";
    }
    return "the frame cannot be drawn";
}

void check_matrices(const LoadedScene& scene, FirstError& error) {
    shadow::FrameMatrices matrices;
    const auto status = shadow::load_matrices(scene.view(), scene.settings, matrices);
    if (status != shadow::FrameStatus::ok) error.report(scene.name + ": " + explain(status));
}

Warnings warnings_of(const LoadedScene& scene) {
    Warnings warnings;
    if (scene.stream) return warnings;
    if (scene.surfaces().empty()) {
        warnings.push_back(
            {"empty", 0, "nothing is drawn: the scene has no [[sphere]] or other surface"});
    } else {
        const bool has_map = shadow::map_layers(scene.settings) > 0;
        for (std::size_t l = 0; has_map && l < scene.lights.size(); ++l)
            if (const std::string name = name_of_light(l, scene.lights.size());
                scene.lights[l].sectored)
                warn_of_sectors(scene, scene.lights[l], name, warnings);
            else
                warn_of_light(scene, scene.lights[l].view, name, warnings);
        warn_of_open_surfaces(scene, warnings);
        warn_of_observer(scene, warnings);
        warn_of_words(scene, warnings);
    }
    for (Warning& warning : warnings) warning.line.insert(0, scene.name + ": ");
    return warnings;
}

Warnings warnings_of_stream(const LoadedScene& scene, const StreamSeen& seen) {
    Warnings warnings;
    const std::uint64_t all = seen.primitives;
    if (all == 0)
        warnings.push_back({"empty", 0, "nothing is drawn: the stream has no primitives"});
    else
        warn_of_words(scene, warnings);
    for (std::size_t l = 0; l < seen.lights.size(); ++l) {
        const auto& [outside, cut] = seen.lights[l];
        const std::string name = name_of_light(l, scene.lights.size());
        if (outside.window > 0 && !scene.lights[l].sectored)
            warnings.push_back(
                {"light_window", static_cast<double>(outside.window),
                 fmt::format("{} of {} primitives reach out of the {}'s picture {}; raise "
                             "{}.extent", outside.window, all, name, loses_shadow, name)});
        warn_of_cut(scene, scene.lights[l].view, cut, all, name, loses_shadow, false, warnings);
    }
    const auto& [outside, cut] = seen.observer;
    warn_of_cut(scene, scene.observer, cut, all, "observer", loses_sight, false,
                warnings);
    if (all > 0 && outside.window == all && !cut.any())
        warnings.push_back({"observer_window", static_cast<double>(all),
                            "every surface reaches out of the picture; raise "
                            "observer.extent"});
    for (Warning& warning : warnings) warning.line.insert(0, scene.name + ": ");
    return warnings;
}

std::vector<std::string> lines_of(const Warnings& warnings) {
    std::vector<std::string> lines;
    for (const Warning& warning : warnings) lines.push_back(warning.line);
    return lines;
}

}  // namespace umbra78::tools
