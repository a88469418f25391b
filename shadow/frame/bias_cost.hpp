// What a light's map costs beside its drawing, and a receiver's plane beside the post-process, in
// operations (hw/operations.hpp): the rows of sections 24 and 27 of hw/MACHINE.md.
#pragma once

#include "hw/operations.hpp"
#include "shadow/shadow_test.hpp"

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

// With kept normals (section 27) three words are read. m's nine products, their sums and roundings
// (9); then of a plane the way to the sampled place as above (13), two products by the quanta of a
// texel, two slopes, two by the way; or of a move the cut, the length and the moves as above (16).
inline constexpr hw::Operations kept_plane{22, 13, 9 + 2 * 6 + 2 * 4, 2, 2 * 40, 3};
inline constexpr hw::Operations kept_normal{25, 16, 9 + 3 * 4 + 3 * 2 + 6, 4, 25 + 3 * 18, 3};
// In perspective the texel's quanta and two slopes of the ray; D has two products and three
// additions more, a move is made oblique.
inline constexpr hw::Operations kept_plane_tilt{4, 2, 2 * 4, 3, 40 + 2 * 26, 0};
inline constexpr hw::Operations kept_normal_tilt{3, 2, 2 * 4, 3, 40 + 2 * 26, 0};

struct ReceiverCost {
    hw::Operations pixel{}, in_perspective{};
};
constexpr ReceiverCost receiver_cost(Receiver receiver, SlopeSource source) {
    const bool kept = source == SlopeSource::normals;
    switch (receiver) {
        case Receiver::plane:
            return kept ? ReceiverCost{kept_plane, kept_plane_tilt} : ReceiverCost{receiver_plane};
        case Receiver::normal:
            return kept ? ReceiverCost{kept_normal, kept_normal_tilt}
                        : ReceiverCost{receiver_normal, receiver_tilt};
        case Receiver::point: break;
    }
    return {};
}

}  // namespace umbra78::shadow::cost
