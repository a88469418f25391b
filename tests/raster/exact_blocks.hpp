// Blocks once more, from the text of hw/MACHINE.md (sections 6, 7 and 14): components, splits,
// bounds, the block rule and the bounds of quotients, in 128-bit integers and by division alone.
// It shares no arithmetic with raster/, so equality with it finds any bit that differs.
#pragma once

#include "raster/projection.hpp"
#include "tests/raster/exact_surface.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <ostream>

namespace umbra78::raster::test {

using Four = std::array<Int128, 4>;

inline Int128 power(int n) { return Int128{1} << n; }
inline Int128 magnitude(Int128 v) { return v < 0 ? -v : v; }
inline Int128 floor_of(Int128 a, Int128 b) {  // a / b, b > 0
    const Int128 q = a / b;
    return q * b > a ? q - 1 : q;
}
inline Int128 ceiling_of(Int128 a, Int128 b) { return -floor_of(-a, b); }
inline Int128 half_up_of(Int128 a, Int128 b) { return floor_of(2 * a + b, 2 * b); }
inline int bits_of(Int128 a) {
    int n = 0;
    for (; a > 0; a /= 2) ++n;
    return n;
}

struct ExactComponent {
    Four f{}, gu{}, gv{}, guv{};
};

inline ExactComponent exact_component(const std::array<Int128, 16>& control) {
    const auto p = [&](int i, int j) { return control[static_cast<std::size_t>(4 * j + i)]; };
    const auto d_i = [&](int i, int j) { return p(i, j) - 2 * p(i + 1, j) + p(i + 2, j); };
    const auto d_j = [&](int i, int j) { return p(i, j) - 2 * p(i, j + 1) + p(i, j + 2); };
    ExactComponent c;
    for (int v = 0; v < 2; ++v) {
        for (int u = 0; u < 2; ++u) {
            const auto k = static_cast<std::size_t>(2 * v + u);
            c.f[k] = p(3 * u, 3 * v);
            c.gu[k] = half_up_of(3 * d_i(u, 3 * v), 4);
            c.gv[k] = half_up_of(3 * d_j(3 * u, v), 4);
            c.guv[k] = half_up_of(9 * (d_i(u, v) - 2 * d_i(u, v + 1) + d_i(u, v + 2)), 16);
        }
    }
    return c;
}

inline ExactComponent exact_component(const Component& c) {
    ExactComponent e;
    for (std::size_t k = 0; k < 4; ++k) {
        e.f[k] = c.f[k];
        e.gu[k] = c.gu[k];
        e.gv[k] = c.gv[k];
        e.guv[k] = c.guv[k];
    }
    return e;
}

inline bool equal(const ExactComponent& e, const Component& c) {
    const ExactComponent o = exact_component(c);
    return e.f == o.f && e.gu == o.gu && e.gv == o.gv && e.guv == o.guv;
}

// The lower and the upper half.
inline std::array<ExactComponent, 2> exact_split(const ExactComponent& c, bool along_u) {
    std::array<ExactComponent, 2> half;
    const auto pair = [&](Four ExactComponent::* f, Four ExactComponent::* g, std::size_t a,
                          std::size_t b) {
        const Int128 fa = (c.*f)[a], fb = (c.*f)[b], ga = (c.*g)[a], gb = (c.*g)[b];
        (half[0].*f)[a] = fa;
        (half[1].*f)[b] = fb;
        (half[0].*f)[b] = (half[1].*f)[a] = half_up_of(fa + fb - ga - gb, 2);
        (half[0].*g)[a] = half_up_of(ga, 4);
        (half[1].*g)[b] = half_up_of(gb, 4);
        (half[0].*g)[b] = (half[1].*g)[a] = half_up_of(ga + gb, 8);
    };
    for (std::size_t k = 0; k < 2; ++k) {
        const std::size_t a = along_u ? 2 * k : k, b = along_u ? 2 * k + 1 : k + 2;
        pair(&ExactComponent::f, along_u ? &ExactComponent::gu : &ExactComponent::gv, a, b);
        pair(along_u ? &ExactComponent::gv : &ExactComponent::gu, &ExactComponent::guv, a, b);
    }
    return half;
}

struct ExactBounds {
    Int128 least, greatest, slope_u, slope_v, bend_u, bend_v;
};

inline ExactBounds exact_bounds(const ExactComponent& c) {
    const auto m = [](const Four& a) {
        return std::max({magnitude(a[0]), magnitude(a[1]), magnitude(a[2]), magnitude(a[3])});
    };
    const auto steps = [](const Four& a, std::size_t first, std::size_t second, std::size_t by) {
        return std::max(magnitude(a[first + by] - a[first]), magnitude(a[second + by] - a[second]));
    };
    const Int128 r = m(c.gu) + m(c.gv) + m(c.guv);
    return {std::min({c.f[0], c.f[1], c.f[2], c.f[3]}) - r,
            std::max({c.f[0], c.f[1], c.f[2], c.f[3]}) + r,
            steps(c.f, 0, 2, 1) + 4 * m(c.gu) + steps(c.gv, 0, 2, 1) + 4 * m(c.guv),
            steps(c.f, 0, 1, 2) + 4 * m(c.gv) + steps(c.gu, 0, 1, 2) + 4 * m(c.guv),
            m(c.gu) + m(c.guv), m(c.gv) + m(c.guv)};
}

inline ExactBounds exact_bounds(const Bounds& b) {
    return {b.min, b.max, b.slope_u, b.slope_v, b.bend_u, b.bend_v};
}

inline bool equal(const ExactBounds& e, const Bounds& b) {
    return e.least == b.min && e.greatest == b.max && e.slope_u == b.slope_u &&
           e.slope_v == b.slope_v && e.bend_u == b.bend_u && e.bend_v == b.bend_v;
}

inline int guard_of(const hw::MachineSpec& m) { return m.z_bits > 20 ? 26 - m.z_bits : 6; }
inline int depth_out(const hw::MachineSpec& m) { return m.z_bits - m.xy_bits + guard_of(m); }

using ExactScreen = std::array<ExactBounds, 3>;

inline BlockAction exact_rule(const ExactScreen& b, const hw::MachineSpec& m) {
    const Int128 side = power(m.xy_bits - 1) * 8192 + 128;
    const Int128 deep = (power(m.z_bits - 1) + 1) * power(guard_of(m));
    for (std::size_t k = 0; k < 3; ++k) {
        const Int128 l = k == 2 ? deep : side;
        if (b[k].greatest < -l || b[k].least > l) return BlockAction::outside;
    }
    bool draw = true;
    Int128 a_u = 0, a_v = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        draw = draw && b[k].least > -power(29) && b[k].greatest < power(29) &&
               b[k].bend_u <= 8192 && b[k].bend_v <= 8192;
        draw = draw && (k == 2 || b[k].slope_u + b[k].slope_v <= 126976);
        a_u = std::max({a_u, 16 * b[k].bend_u, k == 2 ? Int128{0} : b[k].slope_u});
        a_v = std::max({a_v, 16 * b[k].bend_v, k == 2 ? Int128{0} : b[k].slope_v});
    }
    return draw ? BlockAction::draw : a_u >= a_v ? BlockAction::split_u : BlockAction::split_v;
}

// Whether a slope or bend is 2^58 in u, and one in v.
inline bool exact_says_nothing(const ExactScreen& b) {
    bool u = false, v = false;
    for (const ExactBounds& c : b) {
        u = u || std::max(c.slope_u, c.bend_u) >= power(58);
        v = v || std::max(c.slope_v, c.bend_v) >= power(58);
    }
    return u && v;
}

inline ExactComponent less_multiple(const ExactComponent& x, Int128 c, const ExactComponent& w) {
    ExactComponent r;
    for (auto field : {&ExactComponent::f, &ExactComponent::gu, &ExactComponent::gv,
                       &ExactComponent::guv})
        for (std::size_t k = 0; k < 4; ++k) (r.*field)[k] = (x.*field)[k] - c * (w.*field)[k];
    return r;
}

inline ExactBounds exact_quotient(const ExactComponent& x, const ExactComponent& w, int out) {
    const ExactBounds bw = exact_bounds(w);
    const int d = std::max(0, bits_of(bw.least) - 24);
    const Int128 divisor = floor_of(bw.least, power(d));
    const auto sc = [&](Int128 v) { return floor_of(v, power(d)) + 1; };
    const auto up = [&](Int128 v) {
        return std::min(out < 0 ? ceiling_of(v, power(-out)) : v * power(out), power(58));
    };
    const auto over = [&](Int128 v) { return floor_of(up(sc(v)), divisor) + 1; };
    const Int128 c = std::clamp<Int128>(floor_of(x.f[0], w.f[0]), -4096, 4096);
    const ExactBounds b = exact_bounds(less_multiple(x, c, w));
    const Int128 reach = over(std::max(-b.least, b.greatest));
    const auto times = [&](Int128 v) {
        return reach >= power(26) || sc(v) >= power(31) ? power(58)
                                                        : floor_of(reach * sc(v), divisor) + 1;
    };
    const auto bend = [&](Int128 b_bend, Int128 w_bend, Int128 slope, Int128 w_slope) {
        const Int128 mixed = slope >= power(28) || sc(w_slope) >= power(30)
                                 ? power(58)
                                 : floor_of(slope * sc(w_slope), 4 * divisor) + 1;
        return over(b_bend) + times(w_bend) + mixed;
    };
    const Int128 low = out < 0 ? floor_of(c, power(-out)) : c * power(out);
    const Int128 high = out < 0 ? ceiling_of(c, power(-out)) : c * power(out);
    const Int128 slope_u = over(b.slope_u) + times(bw.slope_u);
    const Int128 slope_v = over(b.slope_v) + times(bw.slope_v);
    return {low - reach, high + reach, slope_u, slope_v,
            bend(b.bend_u, bw.bend_u, slope_u, bw.slope_u),
            bend(b.bend_v, bw.bend_v, slope_v, bw.slope_v)};
}

inline Visibility exact_projected(const std::array<ExactComponent, 4>& c,
                                  const hw::MachineSpec& m, ExactScreen& out) {
    const ExactBounds w = exact_bounds(c[3]);
    if (w.greatest <= 0) return Visibility::outside;
    bool far = false, beyond = false;
    const Int128 side = power(m.xy_bits - 1) + 1;
    for (std::size_t k = 0; k < 3; ++k) {
        if (w.least > 0) far = far || magnitude(floor_of(c[k].f[0], c[3].f[0])) > 4096;
        beyond = beyond || exact_bounds(less_multiple(c[k], side, c[3])).least > 0 ||
                 exact_bounds(less_multiple(c[k], -side, c[3])).greatest < 0;
    }
    if ((w.least <= 0 || far) && beyond) return Visibility::outside;
    if (w.least <= 0) return Visibility::unknown;
    out = {exact_quotient(c[0], c[3], 13), exact_quotient(c[1], c[3], 13),
           exact_quotient(c[2], c[3], depth_out(m))};
    return Visibility::bounded;
}

}  // namespace umbra78::raster::test
