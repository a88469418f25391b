// Cubic B-splines as Bezier curves, exactly.
//
// The Bezier points of a span are values of the spline's blossom at its two knots (L. Ramshaw,
// Blossoms are polar forms, CAGD 6, 1989), so each is a mean of four control points whose weights
// are rational in the knots: for knots that are a unit apart
//   (1 4 1 0)/6   (0 4 2 0)/6   (0 2 4 0)/6   (0 1 4 1)/6
#pragma once

#include "fixed/rational.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace umbra78::tools {

// A span that is not empty, between knots `last` and `last` + 1: Bezier point k is the sum of
// weight[k][m] times control point last - 3 + m.
struct BezierSpan {
    std::size_t last;
    std::array<std::array<fixed::Rational, 4>, 4> weight;
};

// All spans of a cubic spline with knots.size() - 4 control points. The knots do not decrease, and
// there are at least 8. Knots are counted in their greatest common divisor; false if one is then
// beyond 2^16 from the first, so that sums of weighted points would not fit.
bool bezier_spans(std::span<const std::int64_t> knots, std::vector<BezierSpan>& spans);

}  // namespace umbra78::tools
