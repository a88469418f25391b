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

}  // namespace umbra78::shadow::cost
