// Independent models of the lookup, in 128-bit integers. The comparison: every texel of the map
// takes part, with a tent of two texels' width as its weight. The addresses: section 17's list.
//
// A window: of all places of a grid the one whose middle is nearest to the point, and each jittered
// tap by a search for its texel.
//
// Nothing is shared with shadow/light_place.hpp and window.hpp but the meaning: there a point's
// texels are found by shifts and masks, here by their weights and by divisions.
#pragma once

#include "shadow/compare.hpp"
#include "shadow/frame/settings.hpp"
#include "tests/fixed/boundary.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace umbra78::shadow::test {

using fixed::test::Int128;

inline Int128 floor_divide(Int128 a, Int128 b) { return a / b - (a % b != 0 && a < 0 ? 1 : 0); }

using SlowTexel = std::pair<int, int>;  // x, y; it may lie outside the map

// The texels of a window's taps, row by row. X and Y are those of the point, dithered.
inline std::vector<SlowTexel> slow_taps(const hw::MachineSpec& m, const Window& w, Int128 x,
                                        Int128 y, const hw::TapBytes& noise) {
    const Int128 one = Int128{1} << m.fraction_bits, half = Int128{1} << (m.xy_bits - 1);
    // Of the windows from texel -9 on, the one whose middle is nearest; of two the later one.
    const auto first = [&](Int128 v) {
        int best = 0;
        Int128 least = -1;
        for (int t = -9; t < 2 * half + 9; ++t) {
            const Int128 twice = 2 * (t - half) * one + w.side * one - 2 * v;
            const Int128 away = twice < 0 ? -twice : twice;
            if (least < 0 || away <= least) {
                least = away;
                best = t;
            }
        }
        return best;
    };
    // The texel that holds a place in 512ths of X's unit.
    const auto texel_of = [&](Int128 place) {
        int t = -9;
        while ((t + 1 - half) * 512 * one <= place) ++t;
        return t;
    };
    const auto jittered = [&](Int128 v, int cell, int byte) {
        const Int128 corner = 512 * v - 256 * w.side * one;  // of the window
        return texel_of(corner + 512 * cell * one + (2 * byte + 1) * one);
    };
    const SlowTexel corner = w.jittered ? SlowTexel{} : SlowTexel{first(x), first(y)};
    std::vector<SlowTexel> taps;
    for (int j = 0; j < w.side; ++j)
        for (int i = 0; i < w.side; ++i) {
            const std::size_t t = taps.size();
            taps.push_back(w.jittered ? SlowTexel{jittered(x, i, noise.x[t]),
                                                  jittered(y, j, noise.y[t])}
                                      : SlowTexel{corner.first + i, corner.second + j});
        }
    return taps;
}

template <class Depth>
bool slow_in_shadow(const LightMap<Depth>& map, const hw::Point& p, const hw::DitherWords& d);

// 0 lit .. 255 in shadow.
template <class Depth>
int slow_darkness(const LightMap<Depth>& map, const hw::Point& p, const hw::DitherWords& d,
                  const hw::TapBytes& noise = {}) {
    if (map.lookup == Lookup::nearest || map.lookup == Lookup::bilinear)
        return slow_in_shadow(map, p, d) ? 255 : 0;
    const hw::MachineSpec& m = map.spec;
    const Int128 edge = Int128{1} << (m.xy_bits - 1 + m.fraction_bits);
    const Int128 x = Int128{p.x} + d.x, y = Int128{p.y} + d.y;
    const Int128 code = Int128{p.z} + (Int128{1} << (m.z_bits - 1));
    const Int128 none = (Int128{1} << m.z_bits) - 1;
    if (p.status != hw::DivideStatus::ok || x < -edge || x >= edge || y < -edge || y >= edge ||
        code < 0 || code >= none)
        return 0;
    int darker = 0, taps = 0;
    Int128 sum = 0;
    for (const auto& [i, j] : slow_taps(m, map.window, x, y, noise)) {
        const int size = 1 << m.xy_bits;
        const bool beyond = i < 0 || j < 0 || i >= size || j >= size;
        const Int128 z = beyond ? none : Int128{map.store.depth[static_cast<std::size_t>(
                                             j * size + i)]};
        ++taps;
        sum += z;
        if (code > z) ++darker;
    }
    if (map.lookup == Lookup::filtered_depth) return code * taps > sum ? 255 : 0;
    int level = 0;  // the nearest to 255 darker / taps, of two the greater
    while (taps * (2 * level + 1) <= 510 * darker) ++level;
    return level;
}

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

// The texels that the comparison reads, each with the number of its request: none outside the
// light's volume; the one that the point lies in; those of the four nearest centres, or of a
// window's taps, that are on the map. With four banks 2 x 2 neighbours of a grid are one request.
struct SlowRead {
    SlowTexel texel;
    int request;
    bool operator==(const SlowRead&) const = default;
};

inline std::vector<SlowRead> slow_reads(const Settings& s, const hw::Point& p,
                                        const hw::DitherWords& d, const hw::TapBytes& noise) {
    const hw::MachineSpec& m = s.machine;
    const Int128 one = Int128{1} << m.fraction_bits, half = Int128{1} << (m.xy_bits - 1);
    const Int128 x = Int128{p.x} + d.x + half * one, y = Int128{p.y} + d.y + half * one;
    const Int128 code = Int128{p.z} + (Int128{1} << (m.z_bits - 1));
    if (p.status != hw::DivideStatus::ok || x < 0 || y < 0 || x >= 2 * half * one ||
        y >= 2 * half * one || code < 0 || code > (Int128{1} << m.z_bits) - 2)
        return {};
    std::vector<SlowTexel> taps;
    int side = s.taps;
    bool jittered = s.tap_places == TapPlaces::jittered;
    if (s.lookup == Lookup::percentage || s.lookup == Lookup::filtered_depth) {
        taps = slow_taps(m, {side, jittered}, x - half * one, y - half * one, noise);
    } else {
        side = s.lookup == Lookup::nearest || m.fraction_bits == 0 ? 1 : 2;
        jittered = false;
        const Int128 off = side == 2 ? one : 0;
        for (int t = 0; t < side * side; ++t)
            taps.push_back({static_cast<int>(floor_divide(2 * x - off, 2 * one)) + t % side,
                            static_cast<int>(floor_divide(2 * y - off, 2 * one)) + t / side});
    }
    const bool blocks = s.timing.light_banks == 4 && !jittered;
    std::vector<SlowRead> reads;
    for (int t = 0; t < side * side; ++t) {
        const auto& [i, j] = taps[static_cast<std::size_t>(t)];
        if (i < 0 || j < 0 || i >= 2 * half || j >= 2 * half) continue;
        reads.push_back({{i, j}, blocks ? 10 * (t / side / 2) + t % side / 2 : t});
    }
    std::stable_sort(reads.begin(), reads.end(),
                     [](const auto& a, const auto& b) { return a.request < b.request; });
    return reads;
}

}  // namespace umbra78::shadow::test
