// The low-pass filter: 1 2 1 / 2 4 2 / 1 2 1 over 16, on the result of the shadow test.
//
// Depths must never be filtered before the comparison; the mask may be (Williams 1978, p. 273).
// A neighbour that is background or beyond the frame counts as the pixel itself, so a shadow does
// not fade toward a silhouette. The sum is rounded half up.
#pragma once

#include "hw/frame_store.hpp"
#include "shadow/lines.hpp"

#include <cstdint>
#include <span>

namespace umbra78::shadow {

// One pass over a frame. `observer` says what is background, which comes out 0. Both spans have a
// byte a pixel and must not overlap: a pixel's neighbours are read after it is written. Lines that
// are not in `lines` are left as they are in `out`: between lit lines a lit line stays lit.
template <class Depth>
void low_pass(std::span<const std::uint8_t> mask, const hw::ReadOnlyStore<Depth>& observer,
              Depth background, std::span<std::uint8_t> out, const LineSet& lines);
template <class Depth>
void low_pass(std::span<const std::uint8_t> mask, const hw::ReadOnlyStore<Depth>& observer,
              Depth background, std::span<std::uint8_t> out) {
    low_pass<Depth>(mask, observer, background, out, LineSet::of_frame(observer.xy_bits));
}

// The kernel, in sixteenths: the weight of the pixel at (dx, dy) from the centre, each -1 .. 1.
constexpr int low_pass_weight(int dx, int dy) { return (2 - dx * dx) * (2 - dy * dy); }

}  // namespace umbra78::shadow
