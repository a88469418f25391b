// How much bias a surface needs, computed from its slopes alone.
//
// The light map holds the depth of a texel's centre for the whole texel. A lit point of a plane is
// up to T/2 from that centre in X and in Y, so it is up to T (|zu| + |zv|)/2 deeper than the map,
// where T is the texel and zu, zv are the plane's slopes in the light's space. Two depths are
// rounded to the quantum q, with an error of half a quantum each. With a dither of d texels the
// point may be looked up in a texel whose centre is up to T (1 + d)/2 away: one texel of dither
// doubles the term.
//
//   nearest    bias >= T (1 + d)(|zu| + |zv|)/2 + q
//   bilinear   bias >= T d (|zu| + |zv|)/2 + q        a plane is interpolated exactly
//
// Percentage lookup has k where nearest lookup has 1: a tap's texel is up to T k/2 away, jittered
// up to T (k + 1)/2. A window's mean depth is that of its middle, up to T/2 away, jittered up to T.
//
// The bound leaves out curvature, the fraction bits of X and Y, the rounding of the matrix, and
// leaf sampling.
#pragma once

#include "shadow/frame/settings.hpp"

#include <cstdint>
#include <span>

namespace umbra78::tools::study {

// In quanta. `slope` is Traced::slope; the bound is infinite where that is, except with bilinear
// lookup and no dither.
double bias_bound(double slope, const shadow::Settings&);

// The least bias, in quanta, that is at least the bound of all but `share` of the pixels that are
// lit in truth (lit[at] != 0) and not left out. NaN if there are no such pixels.
double bias_bound_for(double share, std::span<const double> slope,
                      std::span<const std::uint8_t> lit, std::span<const std::uint8_t> leave_out,
                      const shadow::Settings&);

}  // namespace umbra78::tools::study
