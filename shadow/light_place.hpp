// Where a point lies in the light map: the rules that every form of the shadow test shares.
//
//   X' = X + dither_X,  Y' = Y + dither_Y,  code = Z + 2^(z_bits - 1)
//   inside the light's volume  <=>  -E <= X' < E,  -E <= Y' < E,  0 <= code <= deepest drawn,
//                                   E = half_px 2^F
//   nearest    t = floor(X' / 2^F) + half_px                          (y alike)
//   bilinear   c = X' - 2^F / 2,  t = floor(c / 2^F) + half_px,  f = c mod 2^F
//              blend = (2^F - fy) ((2^F - fx) z00 + fx z10) + fy ((2^F - fx) z01 + fx z11)
//
// A point outside the volume, or without a quotient, is lit (Williams 1978, p. 272). Z is
// interpolated, and not the result of the comparison, which the filters smooth later.
// In: X and Y in texels from the map's centre with F = fraction_bits (0..12) fraction bits, Z in
// quanta from the middle of its range. Out: texels 0 .. size_px - 1 inside the map; the four of
// bilinear lookup reach from -1 to size_px. `blend` is exact, at most z_bits + 2 F <= 50 bits.
//
// The definition (shadow/compare.hpp), the clocked form (shadow/clocked/lookup.hpp), the memory
// replay and the trace call these functions. The row form (shadow/post_process_rows.cpp) writes
// them again in 32-bit lanes, and the AP-120B has its own numbers; tests hold both to a model.
#pragma once

#include "fixed/rounding.hpp"
#include "hw/machine_spec.hpp"
#include "hw/noise_source.hpp"
#include "hw/transform_unit.hpp"
#include "shadow/shadow_test.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace umbra78::shadow {

// --- the light's volume ---------------------------------------------------------------------

// E above: half the light's view, in the words of X and Y.
constexpr std::int64_t volume_edge(const hw::MachineSpec& spec) {
    return std::int64_t{spec.half_px()} << spec.fraction_bits;
}
// X or Y, dithered.
constexpr bool inside_width(const hw::MachineSpec& spec, std::int64_t v) {
    return v >= -volume_edge(spec) && v < volume_edge(spec);
}
constexpr bool inside_depth(const hw::MachineSpec& spec, std::int64_t code) {
    return code >= 0 && code <= spec.deepest_drawn();
}

struct LightPlace {
    bool inside;           // outside the volume, or without a quotient, a point is lit
    std::int64_t x, y;     // dithered
    std::int64_t code;     // Z as the code to compare
};

// `p` from the transform unit, `d` the pixel's dither words (0 where dither is off).
constexpr LightPlace light_place(const hw::MachineSpec& spec, const hw::Point& p,
                                 const hw::DitherWords& d) {
    const std::int64_t x = p.x + d.x, y = p.y + d.y, code = p.z + spec.depth_offset();
    const bool inside = p.status == hw::DivideStatus::ok && inside_width(spec, x) &&
                        inside_width(spec, y) && inside_depth(spec, code);
    return {inside, x, y, inside ? spec.kept(static_cast<std::uint32_t>(code)) : code};
}

// The same on the face of a cube, to whose edge a place beyond it is moved (hw/sectors.hpp).
constexpr LightPlace face_place(const hw::MachineSpec& spec, hw::Point p,
                                const hw::DitherWords& d) {
    const std::int64_t edge = volume_edge(spec);
    const auto on_face = [&](std::int64_t v) {
        return v < -edge ? -edge : v >= edge ? edge - 1 : v;
    };
    p.x = on_face(p.x + d.x);
    p.y = on_face(p.y + d.y);
    return light_place(spec, p, hw::DitherWords{0, 0});
}

// --- texels and weights ---------------------------------------------------------------------

// Whether the lookup reads four texels: without fraction bits there are no weights.
constexpr bool interpolates(const hw::MachineSpec& spec, Lookup lookup) {
    return hw::built(hw::Feature::bilinear) && lookup == Lookup::bilinear &&
           spec.fraction_bits > 0;
}

struct TexelPlace {
    std::int32_t x, y;    // the texel that the point lies in, or the upper left of four
    std::int32_t fx, fy;  // 0 .. 2^F - 1: how far the point is toward the right and the lower ones
};

// Of a point inside the volume. Texel centres lie half a texel from the texel's edge.
constexpr TexelPlace texel_place(const hw::MachineSpec& spec, bool four, std::int64_t x,
                                 std::int64_t y) {
    const int f = spec.fraction_bits;
    const std::int64_t one = std::int64_t{1} << f, back = four ? one / 2 : 0;
    const auto texel = [&](std::int64_t v) {
        return static_cast<std::int32_t>(fixed::floor_shift(v - back, f)) + spec.half_px();
    };
    const auto fraction = [&](std::int64_t v) {
        return static_cast<std::int32_t>((v - back) & (one - 1));
    };
    return {texel(x), texel(y), fraction(x), fraction(y)};
}

// Texels outside the map count as background.
constexpr bool on_map(const hw::MachineSpec& spec, std::int64_t x, std::int64_t y) {
    return x >= 0 && y >= 0 && x < spec.size_px() && y < spec.size_px();
}

// Z codes of four texels: k is the one at (x + k % 2, y + k / 2).
using FourCodes = std::array<std::uint32_t, 4>;

// Whether one of four is background and bilinear lookup takes the nearest texel alone.
constexpr bool falls_back(const hw::MachineSpec& spec, Background rule, const FourCodes& z) {
    const std::uint32_t none = spec.background();
    return rule == Background::fall_back &&
           (z[0] == none || z[1] == none || z[2] == none || z[3] == none);
}

// Which of four texels the point lies in. Needs a fraction bit.
constexpr std::size_t nearest_of_four(const hw::MachineSpec& spec, std::int32_t fx,
                                      std::int32_t fy) {
    const std::int32_t half = 1 << (spec.fraction_bits - 1);
    return (fx >= half ? 1u : 0u) + (fy >= half ? 2u : 0u);
}

struct Blend {
    std::int64_t upper, lower;  // along x, times 2^F
    std::int64_t z;             // along y, times 2^(2 F)
};

constexpr Blend blend_of(const hw::MachineSpec& spec, std::int32_t fx, std::int32_t fy,
                         const FourCodes& z) {
    const std::int64_t one = std::int64_t{1} << spec.fraction_bits;
    const std::int64_t upper = (one - fx) * z[0] + fx * std::int64_t{z[1]};
    const std::int64_t lower = (one - fx) * z[2] + fx * std::int64_t{z[3]};
    return {upper, lower, (one - fy) * upper + fy * lower};
}

// A code at the scale of Blend::z: the other side of the comparison.
constexpr std::int64_t blend_scale(const hw::MachineSpec& spec, std::int64_t code) {
    return code * (std::int64_t{1} << (2 * spec.fraction_bits));
}

}  // namespace umbra78::shadow
