// The translucent composite: a shadow takes light away from the finished picture.
//
//   out = round(level - share mask density / (255 256))      rounded half up
//
// `share` is the part of the level that the shadow's light gives, so that the ambient term stays:
// the translucency that Williams compares a shadow's to (1978, p. 272). level, share and mask are
// 0..255, share <= level; density is Q0.8, from 0 (invisible) to 256 (nothing of the share is
// left). A highlight in shadow is darkened, not absent, while the density is below 256: in this a
// picture of the post-process differs from one of the correct form (the same page).
#pragma once

#include "fixed/trap.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace umbra78::shadow {

// What a shadow darkens. `whole` takes the ambient light away, too, although no shadow can: a line
// then shows where a surface turns away from the light and is dark already.
enum class Composite : std::uint8_t {
    direct,  // the share of the shadow's own light
    whole,   // all of the picture
};

constexpr std::uint8_t composite(std::uint8_t level, std::uint8_t share, std::uint8_t mask,
                                 int density_q8) {
    constexpr std::uint32_t whole = 255 * 256;
    const auto taken = share * static_cast<std::uint32_t>(mask * density_q8);
    return static_cast<std::uint8_t>((level * whole - taken + whole / 2) / whole);
}

// A picture, pixel by pixel; `out` may be one of the others. Planes of different sizes, and a
// density out of its range, trap. Several lights are composited one after the other.
inline void composite(std::span<const std::uint8_t> level, std::span<const std::uint8_t> share,
                      std::span<const std::uint8_t> mask, int density_q8,
                      std::span<std::uint8_t> out) {
    fixed::require(level.size() == out.size() && share.size() == out.size() &&
                       mask.size() == out.size(),
                   "composite: picture, share, mask and result have different sizes");
    fixed::require(density_q8 >= 0 && density_q8 <= 256, "composite: density is 0..256");
    for (std::size_t k = 0; k < out.size(); ++k)
        out[k] = composite(level[k], share[k], mask[k], density_q8);
}

}  // namespace umbra78::shadow
