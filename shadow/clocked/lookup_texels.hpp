// Which texels of the light map a point's comparison reads, in the order it reads them.
//
// The addresses without the words: what shadow/compare.hpp looks up, for those who ask how long
// that takes. None outside the light's volume; one; or those of the four neighbours inside the map.
#pragma once

#include "shadow/compare.hpp"

#include <array>
#include <cstddef>

namespace umbra78::shadow {

struct Texel {
    int x, y;
};

struct Texels {
    std::size_t count = 0;
    std::array<Texel, 4> at{};
};

constexpr Texels lookup_texels(const hw::MachineSpec& spec, Lookup lookup, const hw::Point& p,
                               const hw::DitherWords& d) {
    Texels texels;
    const LightPlace place = light_place(spec, p, d);
    if (!place.inside) return texels;
    const bool four = lookup == Lookup::bilinear && spec.fraction_bits > 0;
    const std::int64_t back = four ? std::int64_t{1} << (spec.fraction_bits - 1) : 0;
    const auto x = static_cast<int>(texel_index(spec, place.x - back));
    const auto y = static_cast<int>(texel_index(spec, place.y - back));
    for (int k = 0; k < (four ? 4 : 1); ++k) {
        const Texel t{x + k % 2, y + k / 2};
        if (t.x < 0 || t.y < 0 || t.x >= spec.size_px() || t.y >= spec.size_px()) continue;
        texels.at[texels.count++] = t;
    }
    return texels;
}

}  // namespace umbra78::shadow
