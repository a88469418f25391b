// Crow's ramp: around a hard shadow the darkness falls off linearly over a fixed width, as if the
// light had an area (Crow 1977, section IV; hw/MACHINE.md, section 23).
//
//   squares = the least dx^2 + dy^2 from a lit pixel to one in shadow
//   darkness = half_up(255 (256 width - isqrt(65536 squares)) / (256 width)),  0 from width on
//
// It knows the picture's plane alone: not how far away what casts the shadow is, which makes a
// penumbra wide or narrow, and not which surface a pixel is of.
// Exact: the least square is found in two passes, down the columns and then along the lines.
// In: a mask, of which 128 and more is in shadow. Out: the larger of mask and ramp; background 0.
#pragma once

#include "hw/frame_store.hpp"

#include <cstdint>
#include <span>

namespace umbra78::shadow {

inline constexpr int max_ramp_px = 32;

// `rows` is scratch of a byte a pixel, and none of the three overlap. 1 <= width <= max_ramp_px.
template <class Depth>
void ramp(std::span<const std::uint8_t> mask, const hw::ReadOnlyStore<Depth>& observer,
          Depth background, int width, std::span<std::uint8_t> rows, std::span<std::uint8_t> out);

// How dark a pixel is whose nearest pixel in shadow has that squared distance.
std::uint8_t ramp_darkness(int squares, int width);

}  // namespace umbra78::shadow
