// The block rule: whether a block is left out, split once more, or drawn as 16 x 16 leaves.
//
// In: bounds of a block's X, Y and Z in raster units. Out: a BlockAction.
// Raster units: X and Y 2^-13 pixel (7 fraction bits and 6 guard bits), Z 2^-guard quantum. A
// block is drawn when two conditions hold:
//   - No leaf of it is larger than a pixel in X or Y, its corrections included. Then a leaf's
//     centre lies within half a pixel of every point that the leaf covers, so no pixel is missed.
//   - No leaf bends away from its corners by more than 32 units. Then the edges of neighbours that
//     were split to different depths lie within the slack that sampling.hpp allows.
// The rule is that of hw/MACHINE.md, section 6; its bounds in perspective are projection.hpp's.
#pragma once

#include "hw/transform_unit.hpp"
#include "raster/block.hpp"

#include <array>
#include <cstdint>

namespace umbra78::raster {

inline constexpr int raster_fraction = 13;
inline constexpr std::int64_t pixel_units = std::int64_t{1} << raster_fraction;

// A block's slopes in u and v together: 15.5 pixels, so 0.97 a leaf. The rest of the pixel is for
// the rounding of the leaves' corners.
inline constexpr std::int64_t max_slope = 31 * pixel_units / 2;
// 32 units a leaf; a block's correction is 4^4 times its leaf's.
inline constexpr std::int64_t max_bend = 32 << 8;
// A block with bounds past this is split: its 32-bit corners and their halving need the rest.
inline constexpr std::int64_t unbounded = std::int64_t{1} << 29;

// Guard bits of Z; fewer where a wide Z would not fit 32-bit corners.
constexpr int depth_guard(const hw::MachineSpec& spec) {
    return spec.z_bits <= 20 ? 6 : 26 - spec.z_bits;
}

using ScreenBounds = std::array<Bounds, 3>;  // x, y, z in raster units

// The slope or bend of a quotient whose bound is too large to compute (projection.hpp).
inline constexpr std::int64_t huge_bound = std::int64_t{1} << 58;

// Whether that is so in both directions. Then it is not known which is the greater, and splitting
// by it could go 24 times one way, into 2^24 slivers, before it went the other way once.
constexpr bool unbounded_both_ways(const ScreenBounds& b) {
    bool u = false, v = false;
    for (const Bounds& c : b) {
        u = u || c.slope_u >= huge_bound || c.bend_u >= huge_bound;
        v = v || c.slope_v >= huge_bound || c.bend_v >= huge_bound;
    }
    return u && v;
}

// outside: the block is not in the cube, nor within 1/64 pixel (X, Y) or a quantum (Z) of it.
enum class BlockAction : std::uint8_t { outside, split_u, split_v, draw };

// What lies beyond one of these in X, Y or Z, of either sign, is outside.
constexpr std::array<std::int64_t, 3> cube_limits(const hw::MachineSpec& spec) {
    const std::int64_t edge = spec.half_px() * pixel_units + pixel_units / 64;
    return {edge, edge, (spec.depth_offset() + 1) << depth_guard(spec)};
}

constexpr BlockAction block_action(const ScreenBounds& b, const hw::MachineSpec& spec) {
    const std::array<std::int64_t, 3> limit = cube_limits(spec);
    bool small = true;
    // What is split is the direction with the greatest slope or scaled bend: 16 times the greatest
    // bend allowed is 2^17, 16 pixels. Unsigned, because a bend in perspective may reach 3 2^58.
    std::uint64_t in_u = 0, in_v = 0;
    const auto word = [](std::int64_t v) { return static_cast<std::uint64_t>(v); };
    for (std::size_t k = 0; k < 3; ++k) {
        if (b[k].max < -limit[k] || b[k].min > limit[k]) return BlockAction::outside;
        if (b[k].max >= unbounded || b[k].min <= -unbounded) small = false;
        if (b[k].bend_u > max_bend || b[k].bend_v > max_bend) small = false;
        in_u = std::max(in_u, 16 * word(b[k].bend_u));
        in_v = std::max(in_v, 16 * word(b[k].bend_v));
        if (k == 2) break;
        if (b[k].slope_u + b[k].slope_v > max_slope) small = false;
        in_u = std::max(in_u, word(b[k].slope_u));
        in_v = std::max(in_v, word(b[k].slope_v));
    }
    if (small) return BlockAction::draw;
    return in_u >= in_v ? BlockAction::split_u : BlockAction::split_v;
}

}  // namespace umbra78::raster
