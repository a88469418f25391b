// The error map: where a frame differs from exact truth, drawn over its picture.
//
//   red     false shadow: lit in truth, shadowed by the mask
//   blue    false light: shadowed in truth, lit by the mask
//   yellow  missing, extra or misplaced: not the surface that truth sees (coverage.hpp)
//   green   the exact edge: pixels in true shadow beside lit ones
//   gray    right: the picture, darkened
// An error hides the edge. Pixels that are not compared (a surface's unlit side) are gray.
#pragma once

#include "tools/render/render_job.hpp"
#include "tools/truth/scene_truth.hpp"

namespace umbra78::tools {

inline constexpr const char* error_map_legend =
    "red false shadow, blue false light, yellow missing, extra or misplaced, green the exact edge";

// Three bytes a pixel, row 0 at the top. The job is rendered; the mask is the filtered one.
std::vector<std::uint8_t> error_map(const SceneTruth&, const RenderJob&);

}  // namespace umbra78::tools
