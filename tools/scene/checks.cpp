#include "tools/scene/checks.hpp"

#include "tools/scene/table_reader.hpp"
#include "tools/scene/view_fit.hpp"

#include <fmt/format.h>

namespace umbra78::tools {
namespace {

std::string decimal(std::int64_t q16) {
    return fmt::format("{:.6g}", static_cast<double>(q16) / world_one);
}

raster::View fitted_view(raster::View view, Patches patches) {
    view.extent = fitted_extent(view, patches);
    raster::fit_depth(view, raster::depth_range(view, patches));
    return view;
}

void warn_of_light(const LoadedScene& scene, std::vector<std::string>& warnings) {
    const Outside outside = count_outside(scene.light, scene.patches);
    const raster::View whole = fitted_view(scene.light, scene.patches);
    const Outside remaining = count_outside(whole, scene.patches);
    const std::size_t all = scene.patches.size();
    if (outside.window > remaining.window)
        warnings.push_back(fmt::format(
            "{} of {} patches reach out of the light's picture and may cast no shadow; "
            "light.extent = {} holds them, or leave it out",
            outside.window, all, decimal(whole.extent)));
    else if (outside.window > 0)
        warnings.push_back(fmt::format(
            "{} of {} patches lie beside or behind the light and cast no shadow; move light."
            "position out of the scene", outside.window, all));
    if (outside.depth > remaining.depth)
        warnings.push_back(fmt::format(
            "{} of {} patches reach out of the light's near .. far and may cast no shadow; "
            "light.near = {} and light.far = {} hold them, or leave both out",
            outside.depth, all, decimal(whole.near_depth), decimal(whole.far_depth)));
}

void warn_of_observer(const LoadedScene& scene, std::vector<std::string>& warnings) {
    const Outside outside = count_outside(scene.observer, scene.patches);
    const raster::View whole = fitted_view(scene.observer, scene.patches);
    const std::size_t all = scene.patches.size();
    if (outside.depth > count_outside(whole, scene.patches).depth)
        warnings.push_back(fmt::format(
            "{} of {} patches are cut off by the observer's near .. far; observer.near = {} and "
            "observer.far = {} hold them, or leave both out",
            outside.depth, all, decimal(whole.near_depth), decimal(whole.far_depth)));
    else if (outside.window == all)
        warnings.push_back(fmt::format("every patch reaches out of the picture; observer.extent "
                                       "= {} shows the whole scene, or leave it out",
                                       decimal(whole.extent)));
}

}  // namespace

std::string explain(shadow::FrameStatus status) {
    using enum shadow::FrameStatus;
    switch (status) {
        case ok: return "";
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
        case bias_out_of_range: return "the bias is beyond 2^47 quanta; lower it";
    }
    return "the frame cannot be drawn";
}

void check_matrices(const LoadedScene& scene, FirstError& error) {
    shadow::FrameMatrices matrices;
    const auto status = shadow::load_matrices(scene.view(), scene.settings, matrices);
    if (status != shadow::FrameStatus::ok) error.report(scene.name + ": " + explain(status));
}

std::vector<std::string> warnings_of(const LoadedScene& scene) {
    std::vector<std::string> warnings;
    if (scene.patches.empty()) {
        warnings.push_back("nothing is drawn: there is no [[sphere]], [[plane]] or [[patch]]");
    } else {
        warn_of_light(scene, warnings);
        warn_of_observer(scene, warnings);
    }
    for (std::string& warning : warnings) warning.insert(0, scene.name + ": ");
    return warnings;
}

}  // namespace umbra78::tools
