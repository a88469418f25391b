// Whether the machine's words still say what the scene says: what is lost when places, matrices and
// depths become words.
//
// Key, measured figure and the limit above which there is a warning:
//   object_words   pixels of a step of the 16-bit object words, at the observer's target: 1
//   view_matrix    the error, in pixels, that a view's matrix words make at the control points in
//                  its volume, in X, Y or depth: 1/4; on a surface that grazes the light more is
//                  not covered by a bias of one or two texels
//   shadow_matrix  the same for the matrix from observer to light, in texels, at the control points
//                  that both views show: 1/4
//   depth_order    a step of a view's Z codes at its target, in pixels (texels): 4
//   bias           in texels of the light, at its target: 4
// In double precision: no bit of a frame depends on it.
#pragma once

#include "tools/scene/scene.hpp"

namespace umbra78::tools {

// Needs check_matrices(), and at least a patch.
void warn_of_words(const LoadedScene&, Warnings&);

}  // namespace umbra78::tools
