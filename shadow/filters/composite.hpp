// The translucent composite: the mask darkens the finished picture.
//
//   out = round(I (255 256 - mask density) / (255 256))      density Q0.8, rounded half up
//
// A highlight in shadow is darkened, not absent: that is what tells the post-process from the
// correct form (Williams 1978, p. 272).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace umbra78::shadow {

constexpr std::uint8_t composite(std::uint8_t intensity, std::uint8_t mask, int density_q8) {
    constexpr std::uint32_t whole = 255 * 256;
    const auto left = whole - static_cast<std::uint32_t>(mask * density_q8);
    return static_cast<std::uint8_t>((intensity * left + whole / 2) / whole);
}

inline void composite(std::span<const std::uint8_t> intensity, std::span<const std::uint8_t> mask,
                      int density_q8, std::span<std::uint8_t> out) {
    for (std::size_t k = 0; k < out.size(); ++k)
        out[k] = composite(intensity[k], mask[k], density_q8);
}

}  // namespace umbra78::shadow
