// The bias converted exactly, as rational numbers, and rounded once.
#include "shadow/bias.hpp"

namespace umbra78::shadow {
namespace {

using hw::Rational;

Rational q16(std::int64_t v) { return Rational(v, std::int64_t{1} << 16); }

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

}  // namespace umbra78::shadow
