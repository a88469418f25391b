// A receiver's surface by the normal that the observer's store keeps of it (hw/MACHINE.md, section
// 27), where shadow/receiver.hpp and normal_offset.hpp take it from two neighbours.
//
//   m        = the normal along the light's X, Y and Z, all three in texels
//   D        = m_W + tilt_X m_X + tilt_Y m_Y              the normal along the ray
//   slope_X  = -scale m_X / D                             quanta for a step of X
//
// In: N, of words up to 2^14 and of any length, and the light's axes in Q1.14; results of the
// transform unit. m has 24 bits, D at most 35.
#pragma once

#include "hw/frame_store.hpp"
#include "shadow/normal_offset.hpp"
#include "shadow/shadow_test.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace umbra78::shadow {

// The world's directions in which a light's X, Y and Z grow, Q1.14.
struct LightAxes {
    std::array<std::array<std::int32_t, 3>, 3> axis{};
    constexpr bool operator==(const LightAxes&) const = default;
};

using LightNormal = std::array<std::int64_t, 3>;

constexpr LightNormal in_light(const std::array<std::int32_t, 3>& n, const LightAxes& light) {
    LightNormal m{};
    for (std::size_t k = 0; k < 3; ++k) {
        const auto& a = light.axis[k];
        const std::int64_t sum = std::int64_t{n[0]} * a[0] + std::int64_t{n[1]} * a[1] +
                                 std::int64_t{n[2]} * a[2];
        m[k] = fixed::round_shift(sum, 6, fixed::Rounding::half_up);
    }
    return m;
}

// The plane through a pixel's results with this normal; without one, level.
constexpr ReceiverPlane plane_of_normal(const hw::Point& at, const LightNormal& m,
                                        const LightScale& light, int fraction_bits,
                                        std::int64_t limit) {
    ReceiverPlane plane{at, 0, 0, limit};
    if (at.status != hw::DivideStatus::ok) return plane;
    const TexelAt texel = light.at(at, fraction_bits);
    const std::int64_t d = m[2] + fixed::round_shift(texel.tilt_x * m[0] + texel.tilt_y * m[1], 16,
                                                     fixed::Rounding::half_up);
    if (d == 0) return plane;
    const std::int64_t sign = d < 0 ? -1 : 1;
    const auto slope = [&](std::int64_t along) {
        return fixed::divide(-sign * texel.quanta * along, sign * d,
                             slope_fraction - 16 - fraction_bits, slope_bits)
            .value;
    };
    plane.slope_x = slope(m[0]);
    plane.slope_y = slope(m[1]);
    return plane;
}

// A pixel's normal as the store keeps it, in the light's view; 0 if it has none.
template <class Depth>
LightNormal kept_normal(const hw::FrameStore<const Depth>& observer, std::size_t address,
                        const LightAxes& light) {
    return in_light({observer.normal_at(address, 0), observer.normal_at(address, 1),
                     observer.normal_at(address, 2)},
                    light);
}

}  // namespace umbra78::shadow
