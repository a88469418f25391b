// Independent models of the lookup, in 128-bit integers. The comparison: every texel of the map
// takes part, with a tent of two texels' width as its weight. The addresses: section 17's list.
//
// Nothing is shared with shadow/light_place.hpp but the meaning: there a point's four texels are
// found by shifts and masks, here by their weights and by divisions.
#pragma once

#include "shadow/compare.hpp"
#include "tests/fixed/boundary.hpp"

#include <cstdint>
#include <utility>
#include <vector>

namespace umbra78::shadow::test {

using fixed::test::Int128;

inline Int128 floor_divide(Int128 a, Int128 b) { return a / b - (a % b != 0 && a < 0 ? 1 : 0); }

template <class Depth>
bool slow_in_shadow(const LightMap<Depth>& map, const hw::Point& p, const hw::DitherWords& d) {
    if (p.status != hw::DivideStatus::ok) return false;
    const Int128 one = Int128{1} << map.spec.fraction_bits;
    const Int128 half = map.spec.half_px(), size = 2 * half;
    const Int128 x = Int128{p.x} + d.x, y = Int128{p.y} + d.y;
    const Int128 code = Int128{p.z} + (Int128{1} << (map.spec.z_bits - 1));
    const Int128 none = (Int128{1} << map.spec.z_bits) - 1;  // also what lies beyond the edge
    if (x < -half * one || x >= half * one || y < -half * one || y >= half * one) return false;
    if (code < 0 || code >= none) return false;
    const auto texel = [&](Int128 i, Int128 j) -> Int128 {
        const bool beyond = i < 0 || j < 0 || i >= size || j >= size;
        return beyond ? none : Int128{map.store.depth[static_cast<std::size_t>(j * size + i)]};
    };
    const bool nearest =
        code > texel(floor_divide(x, one) + half, floor_divide(y, one) + half);
    if (map.lookup == Lookup::nearest || one == 1) return nearest;

    // Twice the distance to texel i's centre, and what is left of the tent's 2 one.
    const auto weight = [&](Int128 at, Int128 i) {
        const Int128 away = 2 * at - (2 * (i - half) + 1) * one;
        const Int128 left = 2 * one - (away < 0 ? -away : away);
        return left > 0 ? left : Int128{0};
    };
    // The four texels are the nearest centres at or before the point, and the next.
    const Int128 i0 = floor_divide(2 * x - one, 2 * one) + half;
    const Int128 j0 = floor_divide(2 * y - one, 2 * one) + half;
    if (map.background == Background::fall_back)
        for (Int128 j = j0; j <= j0 + 1; ++j)
            for (Int128 i = i0; i <= i0 + 1; ++i)
                if (texel(i, j) == none) return nearest;
    Int128 sum = 0, weights = 0;
    for (Int128 j = -1; j <= size; ++j)
        for (Int128 i = -1; i <= size; ++i) {
            const Int128 w = weight(x, i) * weight(y, j);
            weights += w;
            if (w != 0) sum += w * texel(i, j);
        }
    return code * weights > sum;
}

// The texels that the comparison reads, (x, y) in order: none outside the light's volume, the one
// that the point lies in, or those of the four nearest centres that are on the map.
inline std::vector<std::pair<int, int>> slow_texels(const hw::MachineSpec& m, Lookup lookup,
                                                    const hw::Point& p,
                                                    const hw::DitherWords& d) {
    std::vector<std::pair<int, int>> texels;
    const Int128 one = Int128{1} << m.fraction_bits, half = Int128{1} << (m.xy_bits - 1);
    const Int128 x = Int128{p.x} + d.x + half * one, y = Int128{p.y} + d.y + half * one;
    const Int128 code = Int128{p.z} + (Int128{1} << (m.z_bits - 1));
    if (p.status != hw::DivideStatus::ok || x < 0 || y < 0 || x >= 2 * half * one ||
        y >= 2 * half * one || code < 0 || code > (Int128{1} << m.z_bits) - 2)
        return texels;
    if (lookup == Lookup::nearest || m.fraction_bits == 0)
        return {{static_cast<int>(x / one), static_cast<int>(y / one)}};
    for (int j = 0; j < 2; ++j)
        for (int i = 0; i < 2; ++i) {
            const auto tx = static_cast<int>(floor_divide(2 * x - one, 2 * one)) + i;
            const auto ty = static_cast<int>(floor_divide(2 * y - one, 2 * one)) + j;
            if (tx >= 0 && ty >= 0 && tx < 2 * half && ty < 2 * half) texels.push_back({tx, ty});
        }
    return texels;
}

}  // namespace umbra78::shadow::test
