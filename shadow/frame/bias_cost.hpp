// What a light's map costs beside its drawing, and a receiver's plane beside the post-process, in
// operations (hw/operations.hpp): section 24's rows of hw/MACHINE.md.
#pragma once

#include "hw/operations.hpp"

namespace umbra78::shadow::cost {

// A sample is compared with the second depth, too, which is then read or written, and moves down.
inline constexpr hw::Operations second_sample{2, 0, 0, 0, 0, 1};
// Both depths read, their midpoint written.
inline constexpr hw::Operations midpoint_texel{1, 0, 0, 0, 0, 3};

// For each visible pixel: differences of four codes, their compares, u and v; D and two rises of
// two products each; two slopes; their products with the way to the sampled place, summed, rounded
// and limited.
inline constexpr hw::Operations receiver_plane{28, 8, 32, 2, 2 * 40, 13};


// The same differences and compares (6), u and v (6); the cross product's differences (3), the
// greatest of its words and the cut to it (8); the length's sum (2); three moves rounded and added
// (6). Products: the cross product's six, three squares, three by the offset, one by the quanta of
// a texel. Quotients: two depths to texels, the length's root, three moves.
inline constexpr hw::Operations receiver_normal{
    31, 13, 6 * 4 + 3 * 4 + 3 * 2 + 6, 6, 2 * 26 + 25 + 3 * 18, 13};
// In a light's perspective: the texel's quanta and two slopes of its ray are quotients; u and v are
// made upright and the move is made oblique, a product each in X and Y.
inline constexpr hw::Operations receiver_tilt{11, 6, 6 * 4, 3, 40 + 2 * 26, 0};

}  // namespace umbra78::shadow::cost
