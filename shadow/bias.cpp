// The bias converted exactly, as rational numbers, and rounded once.
#include "shadow/bias.hpp"

#include <algorithm>

namespace umbra78::shadow {
namespace {

using hw::Rational;

Rational q16(std::int64_t v) { return Rational(v, std::int64_t{1} << 16); }

// A word with `fraction` bits, within min .. max. What does not fit 64 bits is positive here.
std::int64_t word(const Rational& value, int fraction, std::int64_t min, std::int64_t max) {
    std::int64_t w = 0;
    if (!value.round_scaled(fraction, fixed::Rounding::half_even, w)) return max;
    return std::clamp(w, min, max);
}

}  // namespace

BiasUnits bias_units(const raster::View& light, const hw::MachineSpec& spec) {
    const Rational range = q16(light.far_depth) - q16(light.near_depth);
    const Rational codes = Rational(std::int64_t{1} << spec.z_bits);
    BiasUnits u;
    u.texels_per_world = Rational(spec.half_px()) / q16(light.extent);
    u.quanta_per_world = codes / range;
    if (raster::has_eye(light)) {
        const Rational d = q16(light.distance);
        u.quanta_per_world =
            codes * q16(light.far_depth) * q16(light.near_depth) / (range * d * d);
    }
    return u;
}

bool bias_in_quanta(std::int64_t bias_q16, BiasUnit unit, const BiasUnits& units,
                    std::int64_t& quanta_q16) {
    Rational quanta = q16(bias_q16);
    if (unit == BiasUnit::world) quanta = quanta * units.quanta_per_world;
    if (unit == BiasUnit::texels)
        quanta = quanta * units.quanta_per_world / units.texels_per_world;
    return quanta.round_scaled(16, fixed::Rounding::half_even, quanta_q16);
}

LightScale light_scale(const raster::View& light, const hw::MachineSpec& spec,
                       std::int64_t bias_quanta_q16) {
    LightScale scale;
    if (!raster::has_eye(light)) {
        const BiasUnits u = bias_units(light, spec);
        scale.quanta_q16 = word(u.quanta_per_world / u.texels_per_world, 16, 1, max_texel_quanta);
        return scale;
    }
    const Rational far = q16(light.far_depth), range = far - q16(light.near_depth);
    const Rational codes = Rational(std::int64_t{1} << spec.z_bits);
    scale.reach_q8 = word(codes * far / range - Rational(spec.depth_offset()) -
                              q16(bias_quanta_q16),
                          8, -max_reach, max_reach);
    scale.focal_q8 =
        word(Rational(spec.half_px()) * q16(light.distance) / q16(light.extent), 8, 1, max_reach);
    return scale;
}

LightAxes light_axes(const raster::View& light) {
    const auto words = [](const raster::Axis& a, std::int32_t sign) {
        std::array<std::int32_t, 3> w{};
        for (std::size_t k = 0; k < 3; ++k)
            w[k] = sign * static_cast<std::int32_t>(fixed::round_shift(
                              a[k], raster::axis_fraction - 14, fixed::Rounding::half_up));
        return w;
    };
    return {{words(light.axes.right, 1), words(light.axes.up, -1), words(light.axes.back, -1)}};
}

}  // namespace umbra78::shadow
