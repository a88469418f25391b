// The translucent composite: the mask darkens the finished picture.
//
//   out = round(I (255 256 - mask density) / (255 256))      rounded half up
//
// I and mask are 0..255; density is Q0.8, 0 (invisible) to 256 (black). A highlight in shadow is
// darkened, not absent: in this a picture of the post-process differs from one of the correct form
// (Williams 1978, p. 272).
#pragma once

#include "fixed/trap.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace umbra78::shadow {

constexpr std::uint8_t composite(std::uint8_t intensity, std::uint8_t mask, int density_q8) {
    constexpr std::uint32_t whole = 255 * 256;
    const auto left = whole - static_cast<std::uint32_t>(mask * density_q8);
    return static_cast<std::uint8_t>((intensity * left + whole / 2) / whole);
}

// A picture, pixel by pixel; `out` may be one of the others. Planes of different sizes, and a
// density out of its range, trap.
inline void composite(std::span<const std::uint8_t> intensity, std::span<const std::uint8_t> mask,
                      int density_q8, std::span<std::uint8_t> out) {
    fixed::require(intensity.size() == out.size() && mask.size() == out.size(),
                   "composite: picture, mask and result have different sizes");
    fixed::require(density_q8 >= 0 && density_q8 <= 256, "composite: density is 0..256");
    for (std::size_t k = 0; k < out.size(); ++k)
        out[k] = composite(intensity[k], mask[k], density_q8);
}

}  // namespace umbra78::shadow
