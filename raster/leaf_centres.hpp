// Centre sampling of blocks whose leaves hold one pixel's centre or none. The blocks that the block
// rule draws are such blocks. It gives the samples of sample_centres in the same order, faster.
//
//   find    the leaves whose box, grown by the slack, holds a centre: 16 at once, a row, in 16-bit
//           lanes that the compiler makes vectors of
//   weigh   both triangles of such a leaf, by offsets from its corner 00: p, q, r to the corners
//           10, 11, 01 and d to the pixel. A pixel inside gets its depth from these weights, one
//           outside the grown edges none; one in the slack is left to triangle_depth.
//
// A block with a leaf that holds several centres, or with a corner 2^14 pixels from the frame's
// centre, is left to sample_centres. Tests compare the two sample by sample.
#pragma once

#include "raster/sampling.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace umbra78::raster {
namespace detail {

template <std::size_t Size>
using PixelWords = std::array<std::int16_t, Size>;

// By rows of leaves: bit u of `holds_one` is set if leaf u holds one centre, px[u], py[u].
struct LeafCentres {
    std::array<PixelWords<leaves>, leaves> px, py;
    std::array<std::uint16_t, leaves> holds_one;
};

// Along one axis, for each corner: the first pixel whose centre lies within the slack of it or
// right of that, and the last whose centre lies within it or left of that. Pixels increase with
// places, so a leaf's window runs from the min of its corners' first to the max of their last.
struct CornerWindows {
    std::array<PixelWords<corners>, corners> first, last;
};

// False if a corner is too far out for 16 bits.
inline bool corner_windows(const CornerGrid<std::int32_t>& c, std::int32_t half_px,
                           CornerWindows& w) {
    constexpr std::int32_t reach = 1 << (14 + raster_fraction);
    std::int32_t far = 0;
    for (std::size_t v = 0; v < corners; ++v) {
        const auto corner = [&](std::size_t u) {
            far |= (c[v][u] + reach) & ~(2 * reach - 1);
            w.first[v][u] = static_cast<std::int16_t>(first_pixel(c[v][u] - slack, half_px));
            w.last[v][u] = static_cast<std::int16_t>(last_pixel(c[v][u] + slack, half_px));
        };
        for (std::size_t u = 0; u < leaves; ++u) corner(u);  // whole vectors, and one more
        corner(leaves);
    }
    return far == 0;
}

// std::min and std::max by value: g++ 12 makes no vectors of a choice between references.
constexpr std::int16_t lesser(std::int16_t a, std::int16_t b) { return b < a ? b : a; }
constexpr std::int16_t greater(std::int16_t a, std::int16_t b) { return a < b ? b : a; }

// Bit k in lane k: the bits of the lanes in which a condition holds, or'ed, are one word.
inline constexpr std::array<std::uint16_t, leaves> lane_bit{
    1,      1 << 1, 1 << 2,  1 << 3,  1 << 4,  1 << 5,  1 << 6,  1 << 7,
    1 << 8, 1 << 9, 1 << 10, 1 << 11, 1 << 12, 1 << 13, 1 << 14, 1 << 15};
constexpr std::uint16_t bit_if(bool holds, std::size_t lane) {
    return static_cast<std::uint16_t>((holds ? 0xffff : 0) & lane_bit[lane]);
}

// False if the block is one for sample_centres.
inline bool find_leaf_centres(const Corners& g, std::int32_t half_px,
                              LeafCentres& __restrict found) {
    CornerWindows x, y;
    if (!corner_windows(g[0], half_px, x) || !corner_windows(g[1], half_px, y)) return false;
    const auto size_px = static_cast<std::uint16_t>(2 * half_px);
    std::uint16_t several = 0;
    for (std::size_t v = 0; v < leaves; ++v) {
        const auto min = [v](const auto& c, std::size_t u) {
            return lesser(lesser(c[v][u], c[v][u + 1]), lesser(c[v + 1][u], c[v + 1][u + 1]));
        };
        const auto max = [v](const auto& c, std::size_t u) {
            return greater(greater(c[v][u], c[v][u + 1]), greater(c[v + 1][u], c[v + 1][u + 1]));
        };
        std::uint16_t ones = 0;
        for (std::size_t u = 0; u < leaves; ++u) {  // & and |: no branches in lanes
            const std::int16_t x0 = min(x.first, u), x1 = max(x.last, u);
            const std::int16_t y0 = min(y.first, u), y1 = max(y.last, u);
            const bool one = (x0 == x1) & (y0 == y1) &  // and in the frame
                             (static_cast<std::uint16_t>(x0) < size_px) &
                             (static_cast<std::uint16_t>(y0) < size_px);
            const bool more = (x0 <= x1) & (y0 <= y1) & ((x0 < x1) | (y0 < y1));
            found.px[v][u] = x0;
            found.py[v][u] = y0;
            ones = static_cast<std::uint16_t>(ones | bit_if(one, u));
            several = static_cast<std::uint16_t>(several | bit_if(more, u));
        }
        found.holds_one[v] = ones;
    }
    return several == 0;
}

// A leaf that holds one centre is, with the slack, less than two pixels wide: offsets are below
// 2^14, products 2^28, and sums of edge functions 2^31.
inline constexpr std::int32_t max_offset = 2 << raster_fraction;
static_assert(max_offset - slack <= max_triangle);
static_assert(std::int64_t{6} * max_offset * max_offset <= INT32_MAX);

struct Offset {
    std::int32_t x, y;
};
constexpr std::int32_t cross(Offset a, Offset b) { return a.x * b.y - a.y * b.x; }
constexpr std::int32_t grown(Offset edge) {
    return slack * ((edge.x < 0 ? -edge.x : edge.x) + (edge.y < 0 ? -edge.y : edge.y));
}

// triangle_depth of (a, b, c) at d, from the offsets of b, c and d to a.
inline bool leaf_depth(const Corner& a, const Corner& b, const Corner& c, Offset to_b, Offset to_c,
                       Offset to_d, std::int64_t& z) {
    const std::int32_t turned = cross(to_b, to_c);
    const std::int32_t sign = fixed::floor_shift(turned, 31);  // (v ^ sign) - sign is v or -v
    const std::int32_t area = (turned ^ sign) - sign;
    const std::int32_t wb = (cross(to_d, to_c) ^ sign) - sign;
    const std::int32_t wc = (cross(to_b, to_d) ^ sign) - sign;
    const std::int32_t wa = area - wb - wc;
    const Offset b_to_c{to_c.x - to_b.x, to_c.y - to_b.y};
    if (((wa + grown(b_to_c)) | (wb + grown(to_c)) | (wc + grown(to_b))) < 0) return false;
    if ((wa | wb | wc) < 0 || area == 0)
        return triangle_depth(a, b, c, a.x + to_d.x, a.y + to_d.y, z);
    const std::int64_t rise = std::int64_t{wb} * (std::int64_t{b.z} - a.z) +
                              std::int64_t{wc} * (std::int64_t{c.z} - a.z);
    z = a.z + fixed::round_divide(rise, static_cast<std::uint32_t>(area),
                                  fixed::Rounding::half_up);
    return true;  // no clamp: a mean of the corners' depths is within their range
}

}  // namespace detail

// Hands every sample of the block to `emit`. Returns how many centres were tested.
template <class Emit>
std::uint64_t sample_leaf_centres(const Corners& g, const hw::MachineSpec& spec, Emit&& emit) {
    const std::int32_t half = spec.half_px();
    detail::LeafCentres found;
    if (!detail::find_leaf_centres(g, half, found)) return sample_centres(g, spec, emit);
    std::uint64_t tested = 0;
    for (std::size_t v = 0; v < leaves; ++v) {
        for (unsigned ones = found.holds_one[v]; ones != 0; ones &= ones - 1) {
            const auto u = static_cast<std::size_t>(std::countr_zero(ones));
            const int i = static_cast<int>(u), j = static_cast<int>(v);
            const int px = found.px[v][u], py = found.py[v][u];
            const std::int32_t x = pixel_centre(px, half), y = pixel_centre(py, half);
            const Corner c00 = corner_at(g, i, j), c10 = corner_at(g, i + 1, j);
            const Corner c01 = corner_at(g, i, j + 1), c11 = corner_at(g, i + 1, j + 1);
            const auto from_00 = [&](std::int32_t to_x, std::int32_t to_y) {
                return detail::Offset{to_x - c00.x, to_y - c00.y};
            };
            const detail::Offset p = from_00(c10.x, c10.y), q = from_00(c11.x, c11.y);
            const detail::Offset r = from_00(c01.x, c01.y), d = from_00(x, y);
            std::int64_t z = 0;
            if (detail::leaf_depth(c00, c10, c11, p, q, d, z)) emit(Sample{px, py, x, y, z, i, j});
            if (detail::leaf_depth(c00, c11, c01, q, r, d, z))
                emit(Sample{px, py, x, y, z, i, j, true});
            ++tested;
        }
    }
    return tested;
}

}  // namespace umbra78::raster
