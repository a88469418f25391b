// The bias in its three units: light-map Z quanta, light-map texels, world units.
//
// A texel is the light map's pixel at the light's target; world units are measured along the
// light's direction there. With t pixels a world unit and q quanta a world unit at the target,
//   quanta = texels q / t = world q.
// In a perspective light q = 2^z_bits far near / ((far - near) distance^2).
#pragma once

#include "raster/view.hpp"
#include "shadow/kept_normal.hpp"

#include <cstdint>

namespace umbra78::shadow {

struct BiasUnits {
    hw::Rational quanta_per_world, texels_per_world;
};

// `light` has extent > 0 and far > near, and in perspective distance > 0; else a division by zero
// traps.
BiasUnits bias_units(const raster::View& light, const hw::MachineSpec& spec);

// A bias as it is set: a number in one of the three units, Q.16.
enum class BiasUnit : std::uint8_t { quanta, texels, world };

// That bias in quanta, Q.16, rounded half even; false if it does not fit.
bool bias_in_quanta(std::int64_t bias_q16, BiasUnit unit, const BiasUnits& units,
                    std::int64_t& quanta_q16);

// The words of a light's measures, whose depths have the bias taken off.
LightScale light_scale(const raster::View& light, const hw::MachineSpec& spec,
                       std::int64_t bias_quanta_q16);

// The words of its axes, rounded half up from Q2.30.
LightAxes light_axes(const raster::View& light);

}  // namespace umbra78::shadow
