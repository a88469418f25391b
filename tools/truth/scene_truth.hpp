// A loaded scene's truth, and how far a drawn mask is from it.
//
// The exact shadow of spheres and planes follows from formulas, its closed form. That of free
// patches (a [[patch]] of the scene file) does not: tools/truth/patch_truth.hpp traces it with
// Embree, and a program built without Embree has no truth for such a scene.
#pragma once

#include "tools/scene/scene_file.hpp"
#include "tools/truth/coverage.hpp"
#include "tools/truth/edge_bands.hpp"
#include "tools/truth/edge_distance.hpp"
#include "tools/truth/metrics.hpp"

#include <optional>

namespace umbra78::tools {

struct SceneTruth {
    TruthScene scene;
    TruthView observer, light_view;  // the machine's, with its near and far
    TruthLight light;
    Truth truth;
    // 1: a plane or a free patch is seen from its unlit side. The shading makes it dark, whatever
    // the mask says.
    std::vector<std::uint8_t> unlit_side;
    bool closed_form = true;        // otherwise `scene` holds the spheres and planes only
    double tessellation_error = 0;  // PatchTruth's estimate
};

// Traced at the settings' resolution. Truth sees whatever lies in the observer's window: near and
// far do not cut it, so that what they take from the machine's picture is counted as missing.
// Nothing for a scene with free patches without Embree. `light`: whose shadow. Of a light with an
// area 1024 points are seen or not (points_seen).
std::optional<SceneTruth> trace(const LoadedScene&, std::size_t light = 0);

TruthView truth_view(const raster::View&, int size_px);

// `outside_band` leaves out one light texel mapped back to the observer, and the mask's filter.
struct ShadowReport {
    ShadowError all, outside_band;  // at the threshold; of a graded mask they say little
    GradedError graded;
    EdgeDistance edge{};
    int isolated_pixels = 0;
    int threshold = 128;
    std::optional<double> tessellation_error;  // PatchTruth's, if truth has no closed form
    int unlit_side = 0;                  // pixels seen from a surface's unlit side: not compared
    std::optional<Coverage> coverage{};  // where the observer's Z codes are known
    // There also the pixels that are missing, extra, misplaced, in false shadow or in false light:
    // the error of the picture as a whole.
    int wrong_pixels = 0;
    double wrong_share() const {  // of the pixels that truth sees and the extra ones
        const int seen = coverage ? coverage->seen + coverage->extra : 0;
        return seen > 0 ? double(wrong_pixels) / seen : 0;
    }
};

Band light_texel_band(const SceneTruth&);            // without a filter's reach
Band widened(const Band&, const SceneTruth&, const shadow::Settings&);  // with it

// How far the mask's filters reach: a pixel for each low-pass and one for the dequantizer.
double filter_radius_px(const shadow::Settings&);

// `depths` are the observer's Z codes; without them there is no coverage.
ShadowReport report(const SceneTruth&, const MachineMask&, const Band&,
                    const Buffer* depths = nullptr);

}  // namespace umbra78::tools
