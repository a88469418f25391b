// How much bias a surface needs, from its slopes alone.
//
// The light map holds the depth of a texel's centre for the whole texel, so a lit point of a plane
// that is up to T/2 away from the centre in X and in Y stands up to T (|zu| + |zv|)/2 behind the
// map, T the texel, zu and zv the plane's slopes in the light's space; and two depths are rounded
// to the quantum q, half a quantum each. With dither of size d the point may be looked up in a
// texel whose centre is up to T (1 + d)/2 away: one texel of jitter doubles the term.
//
//   nearest    bias >= T (1 + d)(|zu| + |zv|)/2 + q
//   bilinear   bias >= T d (|zu| + |zv|)/2 + q        a plane is interpolated exactly
//
// Not in it: curvature, the fraction bits of X and Y, the matrix's words, leaf sampling.
#pragma once

#include "shadow/frame/settings.hpp"

#include <cstdint>
#include <span>

namespace umbra78::tools::study {

// In quanta. `slope` as in Traced; infinite where the surface is seen edge on.
double bias_bound(double slope, const shadow::Settings&);

// The least bias in quanta whose bound holds for all but `share` of the pixels that are lit in
// truth (lit[at] != 0) and not left out: what the bound says of a rate of false shadow. NaN where
// there are no such pixels.
double bias_bound_for(double share, std::span<const double> slope,
                      std::span<const std::uint8_t> lit, std::span<const std::uint8_t> leave_out,
                      const shadow::Settings&);

}  // namespace umbra78::tools::study
