// A bicubic patch's exact value at (i / n, j / n), in 128-bit integers: the numerator over n^6.
// De Casteljau's algorithm with the weights i and n - i; shares nothing with Catmull's form.
#pragma once

#include "raster/block.hpp"
#include "tests/fixed/boundary.hpp"

#include <array>
#include <cstdint>

namespace umbra78::raster::test {

using fixed::test::Int128;
using fixed::test::Random;

using Control = std::array<std::int64_t, 16>;

inline Int128 casteljau(std::array<Int128, 4> p, int i, int n) {
    for (std::size_t left = 3; left > 0; --left)
        for (std::size_t k = 0; k < left; ++k) p[k] = (n - i) * p[k] + i * p[k + 1];
    return p[0];
}

inline Int128 exact_value(const Control& p, int i, int j, int n) {
    std::array<Int128, 4> row{};
    for (std::size_t v = 0; v < 4; ++v)
        row[v] = casteljau({p[4 * v], p[4 * v + 1], p[4 * v + 2], p[4 * v + 3]}, i, n);
    return casteljau(row, j, n);
}

inline Int128 sixth_power(int n) {
    const Int128 cube = Int128{n} * n * n;
    return cube * cube;
}

// The value as a double: good to 2^-50 of the control points' size.
inline double value(const Control& p, int i, int j, int n) {
    return static_cast<double>(exact_value(p, i, j, n)) / static_cast<double>(sixth_power(n));
}

inline Control random_control(Random& random, std::int64_t size) {
    Control p{};
    for (std::int64_t& c : p) c = random.between(-size, size);
    return p;
}

}  // namespace umbra78::raster::test
