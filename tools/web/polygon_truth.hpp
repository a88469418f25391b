// Truth where there is no closed form: of patches and meshes, by the polygons that they are diced
// into, exactly.
//
// The alias-free shadow map (form = irregular, shadow/rivals/scan_out.md) is exact on the very
// polygons; of the rivals it takes the least time on scenes of many facets. What differs from the
// smooth surfaces is the dicing's, about a pixel at silhouettes.
#pragma once

#include "tools/scene/scene.hpp"
#include "tools/truth/scene_truth.hpp"

#include <optional>
#include <string>

namespace umbra78::tools::web {

// Why there is none, in plain words; "" if there is one.
std::string why_no_polygon_truth(const LoadedScene&);

// Its truth says what is visible and what is lit, and no more: no places, depths or edges.
// Where no direct light falls the mask changes nothing: unlit_side.
std::optional<SceneTruth> polygon_truth(const LoadedScene&);

}  // namespace umbra78::tools::web
