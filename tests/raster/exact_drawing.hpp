// Drawing once more, from the text of hw/MACHINE.md (sections 3, 5, 7 and 9): object words,
// sampling, Z codes and shading. Slow, in 128-bit integers: every leaf asks every pixel.
#pragma once

#include "fixed/root.hpp"
#include "raster/draw.hpp"
#include "tests/raster/exact_blocks.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace umbra78::raster::test {

using ExactVector = std::array<Int128, 3>;

inline std::array<ExactVector, 16> exact_object_words(const Patch& patch, int fraction) {
    std::array<ExactVector, 16> out{};
    for (std::size_t k = 0; k < 16; ++k) {
        const World& w = patch.control[k];
        const Int128 one = power(16 - fraction);
        out[k] = {half_up_of(w.x, one), half_up_of(w.y, one), half_up_of(w.z, one)};
    }
    return out;
}

// A row's accumulator; `one` is 2^14.
inline Int128 exact_sum(const MatrixWords& m, std::size_t row, const ExactVector& v) {
    const auto& c = m.word[row];
    return c[0] * v[0] + c[1] * v[1] + c[2] * v[2] + c[3] * power(14);
}

inline Int128 half_up_scaled(Int128 v, int down) {  // v / 2^down
    return down > 0 ? half_up_of(v, power(down)) : v * power(-down);
}

// ---- shading, section 9

inline Int128 exact_dot(const ExactVector& a, const ExactVector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Int128 exact_root(Int128 a) {
    return fixed::isqrt(static_cast<std::uint64_t>(a));
}
inline ExactVector cut_to_30(ExactVector v) {
    const int w = bits_of(std::max({magnitude(v[0]), magnitude(v[1]), magnitude(v[2])}));
    if (w > 30)
        for (Int128& t : v) t = half_up_of(t, power(w - 30));
    return v;
}
inline ExactVector exact_unit14(const ExactVector& any) {
    const ExactVector v = cut_to_30(any);
    const Int128 length = exact_root(exact_dot(v, v));
    if (length == 0) return {};
    return {half_up_of(v[0] * power(14), length), half_up_of(v[1] * power(14), length),
            half_up_of(v[2] * power(14), length)};
}

struct ExactShading {
    std::array<ExactVector, 4> normal, place;
    Int128 ambient;
    Material material;
    Toward light, viewer;
    ShadingRule rule;

    ExactShading(const std::array<ExactComponent, 3>& world, const ShadingSpec& spec,
                 const Material& m)
        : normal{}, place{}, ambient(spec.ambient_q8), material(m), light(spec.sources[0].toward),
          viewer(spec.viewer), rule(spec.rule) {
        for (std::size_t v = 0; v < 2; ++v) {
            for (std::size_t u = 0; u < 2; ++u) {
                const std::size_t k = 2 * v + u;
                ExactVector tu = tangent(world, u == 1, 2 * v, 2 * v + 1, &ExactComponent::gu);
                ExactVector tv = tangent(world, v == 1, u, u + 2, &ExactComponent::gv);
                if (tu == ExactVector{})
                    tu = tangent(world, u == 1, 2 - 2 * v, 3 - 2 * v, &ExactComponent::gu);
                if (tv == ExactVector{})
                    tv = tangent(world, v == 1, 1 - u, 3 - u, &ExactComponent::gv);
                const ExactVector a = cut_to_30(tu), b = cut_to_30(tv);
                normal[k] = exact_unit14({a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                                          a[0] * b[1] - a[1] * b[0]});
                for (std::size_t c = 0; c < 3; ++c) place[k][c] = world[c].f[k];
            }
        }
    }

    static ExactVector tangent(const std::array<ExactComponent, 3>& w, bool at_b, std::size_t a,
                               std::size_t b, Four ExactComponent::* g) {
        ExactVector t{};
        for (std::size_t c = 0; c < 3; ++c) {
            const Int128 ga = (w[c].*g)[a], gb = (w[c].*g)[b];
            t[c] = 3 * (w[c].f[b] - w[c].f[a]) + (at_b ? 4 * ga + 8 * gb : -8 * ga - 4 * gb);
        }
        return t;
    }
    static ExactVector mean(const std::array<ExactVector, 4>& q, int i, int j) {
        const Int128 u = 2 * i + 1, v = 2 * j + 1;
        ExactVector m{};
        for (std::size_t c = 0; c < 3; ++c)
            m[c] = (32 - v) * ((32 - u) * q[0][c] + u * q[1][c]) +
                   v * ((32 - u) * q[2][c] + u * q[3][c]);
        return m;
    }
    ExactVector direction(const Toward& t, int i, int j) const {
        if (!t.to_point) return {t.direction[0], t.direction[1], t.direction[2]};
        const ExactVector q = mean(place, i, j);
        return exact_unit14({1024 * Int128{t.point[0]} - q[0], 1024 * Int128{t.point[1]} - q[1],
                             1024 * Int128{t.point[2]} - q[2]});
    }
    static std::uint8_t level(const Int128& s) {
        return static_cast<std::uint8_t>(std::min<Int128>(255, half_up_of(s, power(22))));
    }
    Shade shade(int i, int j, bool in_shadow) const {
        const ExactVector n = mean(normal, i, j);
        const ExactVector l = direction(light, i, j), v = direction(viewer, i, j);
        const Int128 length = std::max<Int128>(1, exact_root(exact_dot(n, n)));
        Int128 nl = floor_of(exact_dot(n, l), length), nv = floor_of(exact_dot(n, v), length);
        const ExactVector h = exact_unit14({l[0] + v[0], l[1] + v[1], l[2] + v[2]});
        Int128 nh = floor_of(exact_dot(n, h), length);
        if (nv < 0) {
            nl = -nl;
            nv = -nv;
            nh = -nh;
        }
        if (rule == ShadingRule::none) nl = power(14);
        const Int128 unlit = material.diffuse[0] * power(14) * ambient;
        Int128 s = unlit;
        if (nl > 0 && !in_shadow) {
            const bool blinn = rule == ShadingRule::blinn;
            Int128 r = floor_of(2 * nl * nv, power(14)) - floor_of(exact_dot(l, v), power(14));
            if (blinn) r = nh;
            r = std::clamp<Int128>(r, 0, power(14));
            if (rule == ShadingRule::lambert || rule == ShadingRule::none) r = 0;
            for (int k = 0; k < material.shininess + (blinn ? 2 : 0); ++k)
                r = half_up_of(r * r, power(14));
            s += material.diffuse[0] * (256 - ambient) * nl + 256 * material.specular[0] * r;
        }
        return {level(s), {static_cast<std::uint8_t>(level(s) - level(unlit))}};
    }
};

// ---- sampling, section 7

struct ExactSample {
    int px, py, i, j;
    Int128 z;
};

using ExactPoint = std::array<Int128, 3>;
using ExactCorners = std::array<std::array<ExactPoint, 17>, 17>;  // [j][i]

inline Int128 exact_edge(const ExactPoint& p, const ExactPoint& q, const ExactPoint& r) {
    return (q[0] - p[0]) * (r[1] - p[1]) - (r[0] - p[0]) * (q[1] - p[1]);
}

// The triangle's depth at `at`, if that is a sample of it.
inline std::optional<Int128> exact_depth(const ExactPoint& a, const ExactPoint& b,
                                         const ExactPoint& c, const ExactPoint& at) {
    for (std::size_t k = 0; k < 2; ++k)
        if (at[k] < std::min({a[k], b[k], c[k]}) - 128 ||
            at[k] > std::max({a[k], b[k], c[k]}) + 128)
            return std::nullopt;
    const Int128 area = exact_edge(a, b, c);
    if (area == 0) return std::nullopt;
    const Int128 sign = area < 0 ? -1 : 1;
    const Int128 wc = sign * exact_edge(a, b, at), wa = sign * exact_edge(b, c, at);
    const Int128 wb = sign * exact_edge(c, a, at);
    const auto limit = [](const ExactPoint& p, const ExactPoint& q) {
        return -128 * (magnitude(q[0] - p[0]) + magnitude(q[1] - p[1]));
    };
    if (wc < limit(a, b) || wa < limit(b, c) || wb < limit(c, a)) return std::nullopt;
    const Int128 z = a[2] + half_up_of(wb * (b[2] - a[2]) + wc * (c[2] - a[2]), sign * area);
    return std::clamp(z, std::min({a[2], b[2], c[2]}), std::max({a[2], b[2], c[2]}));
}

template <class Emit>
void exact_samples(const ExactCorners& g, const MachineSpec& m, Sampling sampling, Emit&& emit) {
    const int half = 1 << (m.xy_bits - 1), size = 2 * half;
    for (int j = 0; j < 16; ++j) {
        for (int i = 0; i < 16; ++i) {
            const auto u = static_cast<std::size_t>(i), v = static_cast<std::size_t>(j);
            const ExactPoint &p00 = g[v][u], &p10 = g[v][u + 1];
            const ExactPoint &p01 = g[v + 1][u], &p11 = g[v + 1][u + 1];
            if (sampling == Sampling::leaf) {
                ExactPoint mean{};
                for (std::size_t k = 0; k < 3; ++k)
                    mean[k] = half_up_of(p00[k] + p10[k] + p01[k] + p11[k], 4);
                const Int128 px = floor_of(mean[0] + half * 8192, 8192);
                const Int128 py = floor_of(mean[1] + half * 8192, 8192);
                if (px < 0 || py < 0 || px >= size || py >= size) continue;
                emit(ExactSample{static_cast<int>(px), static_cast<int>(py), i, j, mean[2]});
                continue;
            }
            const auto near = [&](std::size_t k, Int128 place) {  // the leaf's box, with room
                return place >= std::min({p00[k], p10[k], p01[k], p11[k]}) - 1024 &&
                       place <= std::max({p00[k], p10[k], p01[k], p11[k]}) + 1024;
            };
            for (int py = 0; py < size; ++py) {
                const Int128 y = (2 * (py - half) + 1) * 4096;
                if (!near(1, y)) continue;
                for (int px = 0; px < size; ++px) {
                    const Int128 x = (2 * (px - half) + 1) * 4096;
                    if (!near(0, x)) continue;
                    const ExactPoint at{x, y, 0};
                    if (const auto z = exact_depth(p00, p10, p11, at))
                        emit(ExactSample{px, py, i, j, *z});
                    if (const auto z = exact_depth(p00, p11, p01, at))
                        emit(ExactSample{px, py, i, j, *z});
                }
            }
        }
    }
}

inline std::optional<std::uint32_t> exact_code(Int128 z, const MachineSpec& m) {
    const Int128 b = power(m.z_bits) - 1;
    const Int128 c = half_up_of(z, power(guard_of(m))) + power(m.z_bits - 1);
    if (c < 0 || c > b) return std::nullopt;
    return static_cast<std::uint32_t>(c == b ? b - 1 : c);
}

}  // namespace umbra78::raster::test
