// The Z code that the observer's frame store would hold of a plane at a pixel, for rivals that
// compare what the store has: one function for what is seen, for sides of volumes and for caps, so
// that a cap has the code of its facet.
//
// The scale is the observer's view's (hw/MACHINE.md, section 4): with depths measured as its near
// and far are,
//
//   code = half_up(2^bits (depth - near) / (far - near))                      orthographic
//   code = half_up(2^bits far (depth - near) / ((far - near) depth))          perspective
//
// from the exact depth of the plane at the pixel's centre, and held within 0 and the deepest code
// that is not the background's. In both projections that is affine in the pixel's coordinates, so
// the quotient's divisor is one for a plane.
//
// Bits. A plane's value at a pixel has planes.hpp's offset_bits and 3 more; times a depth, far and
// a code. The greatest is of a perspective view, 2^bits far near word_den (m - e).
#pragma once

#include "shadow/rivals/planes.hpp"

namespace umbra78::shadow::rivals {

// A word is word_num / word_den of the unit in which near and far are given.
struct DepthScale {
    std::int64_t near = 0, far = 1, word_num = 1, word_den = 1;
    int bits = 16;

    std::uint32_t background() const { return (std::uint32_t{1} << bits) - 1; }
    std::uint32_t deepest() const { return background() - 1; }
};

// Of an observer's view.
DepthScale depth_scale(const raster::View& observer, const Space& space, int z_bits);

inline constexpr int depth_bits = 35;  // of near and far, Q.16
inline constexpr int most_code_bits = 24;
static_assert(most_code_bits + 2 * depth_bits + word_bits + offset_bits + 3 + 1 < Sum::bits);

class PlaneCodes {
public:
    PlaneCodes() = default;
    // `plane` is not seen edge-on.
    PlaneCodes(const SeenPlane& plane, const Space& space, const DepthScale& scale);
    // At a pixel at which the plane lies before the eye.
    std::uint32_t at(std::int32_t px, std::int32_t py) const;

private:
    ScreenLine above_{};  // the code and a half, times divisor_
    Sum divisor_{1};      // positive
    std::uint32_t deepest_ = 0;
};

}  // namespace umbra78::shadow::rivals
