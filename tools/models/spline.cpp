#include "tools/models/spline.hpp"

#include <numeric>

namespace umbra78::tools {
namespace {

using fixed::Rational;
using Weights = std::array<Rational, 4>;

Weights mean(const Weights& a, const Weights& b, const Rational& part_of_b) {
    Weights sum;
    for (std::size_t m = 0; m < 4; ++m) sum[m] = a[m] + (b[m] - a[m]) * part_of_b;
    return sum;
}

// The blossom of span `last` at three parameters: de Boor's scheme with one parameter a level.
Weights blossom(std::span<const std::int64_t> knots, std::size_t last,
                const std::array<std::int64_t, 3>& at) {
    std::array<Weights, 4> d;
    for (std::size_t m = 0; m < 4; ++m) d[m][m] = Rational(1);
    for (std::size_t level = 1; level <= 3; ++level) {
        for (std::size_t m = 3; m >= level; --m) {
            const std::int64_t from = knots[last - 3 + m], to = knots[last + 1 + m - level];
            d[m] = mean(d[m - 1], d[m], Rational(at[level - 1] - from, to - from));
        }
    }
    return d[3];
}

}  // namespace

bool bezier_spans(std::span<const std::int64_t> knots, std::vector<BezierSpan>& spans) {
    std::int64_t divisor = 0;
    for (const std::int64_t knot : knots) divisor = std::gcd(divisor, knot - knots[0]);
    std::vector<std::int64_t> counted;
    for (const std::int64_t knot : knots)
        counted.push_back(divisor == 0 ? 0 : (knot - knots[0]) / divisor);
    if (counted.back() > 1 << 16) return false;
    for (std::size_t last = 3; last + 4 < counted.size(); ++last) {
        const std::int64_t a = counted[last], b = counted[last + 1];
        if (a == b) continue;
        const auto at = [&](std::int64_t x, std::int64_t y, std::int64_t z) {
            return blossom(counted, last, {x, y, z});
        };
        spans.push_back({last, {at(a, a, a), at(a, a, b), at(a, b, b), at(b, b, b)}});
    }
    return true;
}

}  // namespace umbra78::tools
