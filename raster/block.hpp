// A block: a part of a patch, held as Catmull's subdivision holds it.
//
// A block keeps, for each component (X, Y, Z, ...) and at each corner, a value f and three
// corrections gu, gv, guv. On a curve f(t) = a t^3 + b t^2 + c t + d the correction is
// g = (3 a t + b) / 4, an eighth of the second derivative. The curve is halved by (Catmull 1974,
// pp. 15, 22, 27, with the first division by four done beforehand):
//
//   f_mid = (f0 + f1 - g0 - g1) / 2      g_mid = (g0 + g1) / 8      g0, g1 <- g0 / 4, g1 / 4
//
// Every division rounds half up: adds and shifts, no multiply. On [0, 1] the correction bounds
// the curve: |f(t) - chord| <= max |g| and |f'(t)| <= |f1 - f0| + 4 max |g|.
// A corner's index is 2 v + u. Values are 64-bit words in any unit: with control words of at most
// 2^63 / max_growth nothing overflows.
#pragma once

#include "fixed/rounding.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

namespace umbra78::raster {

// floor((v + 2^(n-1)) / 2^n), the only rounding of the subdivider.
template <class Int>
constexpr Int half_up(Int v, int n) {
    return fixed::floor_shift(v + (Int{1} << (n - 1)), n);
}

struct Component {
    std::array<std::int64_t, 4> f{}, gu{}, gv{}, guv{};
};

// The greatest that anything in this file becomes, in units of the greatest control word: nine
// second differences (4) of second differences (4).
inline constexpr std::int64_t max_growth = 9 * 4 * 4;

// The corners and corrections of a bicubic Bezier patch; control[4 j + i], i along u. With
// second differences D0 = P0 - 2 P1 + P2 and D1 = P1 - 2 P2 + P3 the correction is 3/4 D, and the
// mixed one 9/16 of both directions' D.
constexpr Component component_from_bezier(const std::array<std::int64_t, 16>& p) {
    const auto value = [&](int end, int i0, int stride) {
        return p[static_cast<std::size_t>(i0 + 3 * end * stride)];
    };
    const auto second = [&](int end, int i0, int stride) {
        const auto at = [&](int i) { return p[static_cast<std::size_t>(i0 + i * stride)]; };
        return at(end) - 2 * at(end + 1) + at(end + 2);
    };
    Component c;
    for (int v = 0; v < 2; ++v) {
        for (int u = 0; u < 2; ++u) {
            const auto k = static_cast<std::size_t>(2 * v + u);
            c.f[k] = value(u, 12 * v, 1);
            c.gu[k] = half_up(3 * second(u, 12 * v, 1), 2);
            c.gv[k] = half_up(3 * second(v, 3 * u, 4), 2);
            const std::int64_t twice =
                second(v, u, 4) - 2 * second(v, u + 1, 4) + second(v, u + 2, 4);
            c.guv[k] = half_up(9 * twice, 4);
        }
    }
    return c;
}

// The halves of one curve with ends f0, f1 and corrections g0, g1.
struct Halves {
    std::int64_t f_mid, g_mid, g0, g1;
};
constexpr Halves halve(std::int64_t f0, std::int64_t f1, std::int64_t g0, std::int64_t g1) {
    return {half_up(f0 + f1 - g0 - g1, 1), half_up(g0 + g1, 3), half_up(g0, 2), half_up(g1, 2)};
}

namespace detail {
using Field = std::array<std::int64_t, 4> Component::*;

// Halves the edge between corners a and b for one value and its correction along that edge.
constexpr void split_pair(const Component& c, Component& low, Component& high, Field f, Field g,
                          std::size_t a, std::size_t b) {
    const Halves h = halve((c.*f)[a], (c.*f)[b], (c.*g)[a], (c.*g)[b]);
    (low.*f)[a] = (c.*f)[a];
    (low.*g)[a] = h.g0;
    (low.*f)[b] = (high.*f)[a] = h.f_mid;
    (low.*g)[b] = (high.*g)[a] = h.g_mid;
    (high.*f)[b] = (c.*f)[b];
    (high.*g)[b] = h.g1;
}
}  // namespace detail

// A split in u halves (f, gu) and (gv, guv) on both edges v = 0 and v = 1; one in v likewise.
constexpr void split_u(const Component& c, Component& low, Component& high) {
    for (std::size_t a : {std::size_t{0}, std::size_t{2}}) {
        detail::split_pair(c, low, high, &Component::f, &Component::gu, a, a + 1);
        detail::split_pair(c, low, high, &Component::gv, &Component::guv, a, a + 1);
    }
}

constexpr void split_v(const Component& c, Component& low, Component& high) {
    for (std::size_t a : {std::size_t{0}, std::size_t{1}}) {
        detail::split_pair(c, low, high, &Component::f, &Component::gv, a, a + 2);
        detail::split_pair(c, low, high, &Component::gu, &Component::guv, a, a + 2);
    }
}

constexpr std::int64_t max_magnitude(const std::array<std::int64_t, 4>& a) {
    std::int64_t m = 0;
    for (const std::int64_t v : a) m = std::max(m, v < 0 ? -v : v);
    return m;
}

// Bounds of a component over the whole block. They hold for the exact surface that the corners and
// corrections define; corners that are computed by halving differ from it by their rounding.
struct Bounds {
    std::int64_t min, max;          // of f
    std::int64_t slope_u, slope_v;  // of |df/du|, |df/dv|
    std::int64_t bend_u, bend_v;    // of |gu|, |gv| anywhere in the block
};

constexpr Bounds bounds(const Component& c) {
    const auto& [f, gu, gv, guv] = c;
    const std::int64_t mgu = max_magnitude(gu), mgv = max_magnitude(gv);
    const std::int64_t mguv = max_magnitude(guv);
    const auto step = [](const std::array<std::int64_t, 4>& a, std::size_t i, std::size_t j) {
        return a[i] < a[j] ? a[j] - a[i] : a[i] - a[j];
    };
    const std::int64_t reach = mgu + mgv + mguv;
    return {std::min({f[0], f[1], f[2], f[3]}) - reach,
            std::max({f[0], f[1], f[2], f[3]}) + reach,
            std::max(step(f, 0, 1), step(f, 2, 3)) + 4 * mgu +
                std::max(step(gv, 0, 1), step(gv, 2, 3)) + 4 * mguv,
            std::max(step(f, 0, 2), step(f, 1, 3)) + 4 * mgv +
                std::max(step(gu, 0, 2), step(gu, 1, 3)) + 4 * mguv,
            mgu + mguv, mgv + mguv};
}

}  // namespace umbra78::raster
