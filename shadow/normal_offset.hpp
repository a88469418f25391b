// The normal offset: a pixel's point, moved along its surface's normal before it is compared
// (hw/MACHINE.md, section 24).
//
//   u, v    the results of two neighbours less the pixel's, brought to one measure, the light's
//           texel at the pixel, and upright where the light's rays are not parallel
//   n       = u x v, on the side that the observer sees
//   move    = offset n / |n|, brought back to the measures of X, Y and Z
//
// In: results of the transform unit: X and Y with F fraction bits, Z in quanta; the offset in
// texels, Q.8. Out: results again. In between texels are words of 26 bits with 12 fraction bits.
// Products are of at most 52 bits, and the normal has 25 and its length 25.
#pragma once

#include "fixed/root.hpp"
#include "shadow/receiver.hpp"

#include <bit>
#include <cstdint>

namespace umbra78::shadow {

inline constexpr int move_fraction = 12, move_bits = 26, normal_bits = 24;
inline constexpr std::int64_t max_texel_quanta = (std::int64_t{1} << 40) - 1;
inline constexpr std::int64_t max_reach = std::int64_t{1} << 53;

// At a pixel: what a texel is worth in Z, quanta in Q.16; the ray's slopes, Q.16.
struct TexelAt {
    std::int64_t quanta, tilt_x = 0, tilt_y = 0;
};

// What a texel of a light's map is worth in its Z. In perspective that grows toward the eye:
// (reach - Z) / focal, with focal the eye's distance from where it is a texel to a texel.
struct LightScale {
    std::int64_t quanta_q16 = 1 << 16;           // of an orthographic light
    std::int64_t reach_q8 = 0, focal_q8 = 0;  // quanta, texels; focal 0: orthographic
    constexpr bool operator==(const LightScale&) const = default;

    constexpr std::int64_t texel_quanta(std::int64_t z) const {
        if (focal_q8 == 0) return quanta_q16;
        return std::clamp<std::int64_t>(
            fixed::divide(reach_q8 - z * 256, focal_q8, 16, 41).value, 1, max_texel_quanta);
    }
    // The ray's slope at X or Y, Q.16.
    constexpr std::int64_t tilt(std::int64_t v, int fraction_bits) const {
        return focal_q8 == 0 ? 0 : fixed::divide(v, focal_q8, 24 - fraction_bits, move_bits).value;
    }
    constexpr TexelAt at(const hw::Point& p, int fraction_bits) const {
        return {texel_quanta(p.z), tilt(p.x, fraction_bits), tilt(p.y, fraction_bits)};
    }
};

// A pixel's results moved by an offset, of either sign, along a normal of any length below 2^63 in
// texels.
constexpr hw::Point moved_along(const hw::Point& at, std::array<std::int64_t, 3> n,
                                std::int64_t offset_q8, const TexelAt& texel, int fraction_bits) {
    using fixed::round_shift;
    constexpr auto half_up = fixed::Rounding::half_up;
    const std::uint64_t most =
        std::max({fixed::magnitude(n[0]), fixed::magnitude(n[1]), fixed::magnitude(n[2])});
    if (at.status != hw::DivideStatus::ok || most == 0) return at;
    const int down = static_cast<int>(std::bit_width(most)) - normal_bits;
    std::uint64_t square = 0;
    for (std::int64_t& k : n) {
        k = down > 0 ? round_shift(k, down, half_up) : k * (std::int64_t{1} << -down);
        square += static_cast<std::uint64_t>(k * k);
    }
    const auto length = static_cast<std::int64_t>(fixed::isqrt(square));
    const std::int64_t offset = offset_q8 * (1 << (move_fraction - 8));
    const auto move = [&](std::int64_t k) {
        return fixed::divide(offset * k, length, 0, 40).value;
    };
    const std::int64_t x = move(n[0]), y = move(n[1]), w = move(n[2]);
    const auto sideways = [&](std::int64_t along, std::int64_t tilt) {
        return round_shift(along * 65536 - tilt * w, 16 + move_fraction - fraction_bits, half_up);
    };
    return {at.x + sideways(x, texel.tilt_x), at.y + sideways(y, texel.tilt_y),
            at.z + round_shift(texel.quanta * w, 16 + move_fraction, half_up), at.status};
}

// Along the normal of the surface that two neighbours show. `turn` is 1 where they follow one
// another as right and below do, else -1.
constexpr hw::Point moved_along_normal(const hw::Point& at, const hw::Point& beside,
                                       const hw::Point& below, int turn, std::int64_t offset_q8,
                                       const LightScale& light, int fraction_bits) {
    using fixed::round_shift;
    constexpr auto half_up = fixed::Rounding::half_up;
    const NeighbourSteps steps = neighbour_steps(at, beside, below);
    if (!steps.known) return at;
    const TexelAt texel = light.at(at, fraction_bits);
    const std::int64_t up = std::int64_t{1} << (move_fraction - fraction_bits);
    bool fits = true;
    const auto upright = [&](const std::array<std::int64_t, 3>& step) {
        const std::int64_t w = fixed::divide(step[2], texel.quanta, 16 + move_fraction, 31).value;
        if (!fixed::fits(w, move_bits)) {
            fits = false;
            return std::array<std::int64_t, 3>{};
        }
        const std::array<std::int64_t, 3> s{
            up * step[0] + round_shift(texel.tilt_x * w, 16, half_up),
            up * step[1] + round_shift(texel.tilt_y * w, 16, half_up), w};
        fits = fits && fixed::fits(s[0], move_bits) && fixed::fits(s[1], move_bits);
        return s;
    };
    const std::array u = upright(steps.u), v = upright(steps.v);
    if (!fits) return at;
    const std::array<std::int64_t, 3> n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                                        u[0] * v[1] - u[1] * v[0]};
    return moved_along(at, n, -turn * offset_q8, texel, fraction_bits);
}

}  // namespace umbra78::shadow
