// Worst errors of subdivision and shading, by the production code on adversarial words.
#include "raster/leaf_grid.hpp"
#include "raster/shading.hpp"
#include "tests/proofs/search.hpp"

#include <cmath>
#include <vector>

namespace umbra78::proofs {
namespace {

// 3 16^3 f(i / 16) of a curve with ends f and corrections g: f + c t + b t^2 + a t^3 with
// 3 a = 4 (g1 - g0), b = 4 g0.
Wide curve(Wide f0, Wide f1, Wide g0, Wide g1, int i) {
    const Wide a = 4 * (g1 - g0), b = 12 * g0, c = 3 * (f1 - f0) - a - b, t = i;
    return 3 * 4096 * f0 + c * t * 256 + b * t * t * 16 + a * t * t * t;
}

// The exact surface at a leaf's corner, times (3 16^3)^2.
Wide surface(const raster::Component& s, int i, int j) {
    const auto along_u = [&](const auto& f, const auto& g, std::size_t v) {
        return curve(f[2 * v], f[2 * v + 1], g[2 * v], g[2 * v + 1], i);
    };
    return curve(along_u(s.f, s.gu, 0), along_u(s.f, s.gu, 1), along_u(s.gv, s.guv, 0),
                 along_u(s.gv, s.guv, 1), j);
}

// The halvings after which corner i of 0 .. 16 is made.
int level_of(int i) {
    int level = 4;
    while (level > 0 && i % 2 == 0) i /= 2, --level;
    return level;
}

// The worst after k halvings is that of the corners that k halvings make.
struct Levels {
    double worst[9] = {};
};

Levels errors_of(const raster::Component& s) {
    std::array<raster::Component, 1> block{s};
    std::array<raster::CornerGrid<std::int64_t>, 1> grid;
    raster::expand<std::int64_t>(block, grid);
    Levels levels;
    for (int j = 0; j <= 16; ++j)
        for (int i = 0; i <= 16; ++i) {
            const int in_v = level_of(j), k = in_v > 0 ? 4 + in_v : level_of(i);
            const Wide unit = Wide{12288} * 12288;
            const double e = std::abs(ratio(
                grid[0][std::size_t(j)][std::size_t(i)] * unit - surface(s, i, j), unit));
            if (e > levels.worst[k]) levels.worst[k] = e;
        }
    return levels;
}

Given words_of(const raster::Component& s) {
    Given in;
    for (const auto* field : {&s.f, &s.gu, &s.gv, &s.guv}) in.insert(in.end(), field->begin(),
                                                                     field->end());
    return in;
}

// A curve f0, f1, g0, g1 with a great error of either sign at one of its places i / 16.
struct Curve {
    std::array<std::int64_t, 4> word{};
    double error = 0;
};

double curve_error(const std::array<std::int64_t, 4>& c, int i) {
    raster::Component s;
    s.f = {c[0], c[1], 0, 0}, s.gu = {c[2], c[3], 0, 0};
    std::array<raster::Component, 1> block{s};
    std::array<raster::CornerGrid<std::int64_t>, 1> grid;
    raster::expand<std::int64_t>(block, grid);
    return ratio(grid[0][0][std::size_t(i)] * Wide{12288} - curve(c[0], c[1], c[2], c[3], i),
                 12288);
}

// Only the words' low bits matter, for a curve that is a multiple of 2^12 has no error.
Curve worst_curve(Words& words, int i, int sign, int tries) {
    Curve best;
    for (int k = 0; k < tries; ++k) {
        Curve next;
        for (std::int64_t& v : next.word) v = static_cast<std::int64_t>(words.bits() % 4096);
        next.error = curve_error(next.word, i);
        if (sign * next.error >= sign * best.error) best = next;
    }
    for (int k = 0; k < tries; ++k) {
        Curve next = best;
        next.word[words.bits() % 4] += words.number(-64, 64);
        next.error = curve_error(next.word, i);
        if (sign * next.error >= sign * best.error) best = next;
    }
    return best;
}

// A surface whose rows v = 0 and 1 are such curves, and their corrections curves of the other sign:
// adding a number to a curve's ends changes no error of it, so four numbers are left to climb with.
raster::Component with_curves(const Curve& f, const Curve& g,
                              const std::array<std::int64_t, 4>& add) {
    raster::Component s;
    for (std::size_t v = 0; v < 2; ++v) {
        for (std::size_t u = 0; u < 2; ++u) {
            s.f[2 * v + u] = f.word[u] + add[v];
            s.gu[2 * v + u] = f.word[2 + u];
            s.gv[2 * v + u] = g.word[u] + add[2 + v];
            s.guv[2 * v + u] = g.word[2 + u];
        }
    }
    return s;
}

void halvings(Words& words) {
    Worst* worst[9] = {};
    for (int k = 1; k <= 8; ++k) worst[k] = new Worst("halving_" + std::to_string(k));
    for (int i = 1; i < 16; i += 2)
        for (const int sign : {1, -1})
            for (int start = 0; start < 3; ++start) {
                const Curve f = worst_curve(words, i, sign, 3000);
                const Curve g = worst_curve(words, i, -sign, 3000);
                std::array<std::int64_t, 4> best{};
                double most[9] = {};
                for (int step = 0; step < 1200; ++step) {
                    std::array<std::int64_t, 4> next = best;
                    next[words.bits() % 4] = static_cast<std::int64_t>(words.bits() % 4096);
                    const raster::Component s = with_curves(f, g, next);
                    const Levels e = errors_of(s);
                    for (int k = 1; k <= 8; ++k) worst[k]->add(e.worst[k], words_of(s));
                    const int k = 5 + step % 4;
                    if (e.worst[k] < most[k]) continue;
                    most[k] = e.worst[k];
                    best = next;
                }
            }
    for (int k = 1; k <= 8; ++k) delete worst[k];
}

// A correction through up to 24 halvings, each to one of three places.
void corrections(Words& words) {
    Worst worst("correction");
    for (int k = 0; k < 200'000; ++k) {
        const std::int64_t a = words.word(20), b = words.word(20);
        std::int64_t g0 = a, g1 = b;
        long double e0 = static_cast<long double>(a), e1 = static_cast<long double>(b);
        for (int level = 0; level < 24; ++level) {
            const raster::Halves h = raster::halve(0, 0, g0, g1);
            const long double mid = (e0 + e1) / 8;
            const bool low = words.bits() % 2 == 0;
            g0 = low ? h.g0 : h.g_mid, g1 = low ? h.g_mid : h.g1;
            e0 = low ? e0 / 4 : mid, e1 = low ? mid : e1 / 4;
            for (const long double e : {static_cast<long double>(g0) - e0,
                                        static_cast<long double>(g1) - e1})
                worst.add(static_cast<double>(e), {a, b, level + 1});
        }
    }
}

// The same curve at any place, for words of 20 bits exact to 2^-40.
long double real_curve(long double f0, long double f1, long double g0, long double g1,
                       long double t) {
    const long double a = 4 * (g1 - g0) / 3, b = 4 * g0;
    return f0 + t * (f1 - f0 - a - b + t * (b + t * a));
}

// Blocks that are split 24 times each way, in any order, to any half.
void deepest(Words& words) {
    Worst worst("deepest");
    for (int k = 0; k < 4000; ++k) {
        raster::Component first;
        for (auto* field : {&first.f, &first.gu, &first.gv, &first.guv})
            for (std::int64_t& v : *field) v = words.word(20);
        raster::Component s = first;
        long double u = 0, v = 0, width = 1, height = 1;
        int left_u = 24, left_v = 24;
        while (left_u + left_v > 0) {
            raster::Component low, high;
            const bool upper = words.bits() % 2 == 0;
            const bool in_u = left_v == 0 || (left_u > 0 && words.bits() % 2 == 0);
            if (in_u) {
                raster::split_u(s, low, high), --left_u, width /= 2;
                if (upper) u += width;
            } else {
                raster::split_v(s, low, high), --left_v, height /= 2;
                if (upper) v += height;
            }
            s = upper ? high : low;
            for (std::size_t c = 0; c < 4; ++c) {
                const long double x = u + (c % 2 != 0 ? width : 0), y = v + (c > 1 ? height : 0);
                const auto row = [&](const auto& f, const auto& g, std::size_t at) {
                    return real_curve(static_cast<long double>(f[at]),
                                      static_cast<long double>(f[at + 1]),
                                      static_cast<long double>(g[at]),
                                      static_cast<long double>(g[at + 1]), x);
                };
                const long double exact =
                    real_curve(row(first.f, first.gu, 0), row(first.f, first.gu, 2),
                               row(first.gv, first.guv, 0), row(first.gv, first.guv, 2), y);
                worst.add(static_cast<double>(static_cast<long double>(s.f[c]) - exact),
                          words_of(first));
            }
        }
    }
}

// --- shading -------------------------------------------------------------------------------------

raster::UnitVector unit(Words& words) {
    return raster::unit_vector({words.word(31), words.word(31), words.word(31)});
}

void vectors(Words& words) {
    Worst length("unit_vector"), cosine("cosine");
    for (int k = 0; k < 300'000; ++k) {
        const raster::WideVector v = raster::scaled_to(
            {words.word(30), words.word(30), words.word(31) | (1 << 29)}, 30);
        const raster::UnitVector u = raster::unit_vector(v);
        const long double exact = std::sqrt(static_cast<long double>(raster::dot(v, v)));
        if (exact < (1 << 29)) continue;
        for (std::size_t i = 0; i < 3; ++i)
            length.add(static_cast<double>(static_cast<long double>(u[i]) -
                                           static_cast<long double>(v[i]) * 16384 / exact),
                       {v[0], v[1], v[2]});
        // A leaf's normal: a corner's, 1024 times, and some of another's within 60 degrees.
        const raster::UnitVector n = unit(words), d = unit(words), o = unit(words);
        if (raster::dot(raster::wide(n), raster::wide(o)) < (1 << 27)) continue;
        const int t = words.number(0, 1024);
        const raster::WideVector m{(1024 - t) * n[0] + t * o[0], (1024 - t) * n[1] + t * o[1],
                                   (1024 - t) * n[2] + t * o[2]};
        const long double l = std::sqrt(static_cast<long double>(raster::dot(m, m)));
        if (l < 14529495) continue;
        const raster::Cosines c = raster::cosines(m, d, d, raster::ShadingRule::phong);
        cosine.add(static_cast<double>(
                       static_cast<long double>(c.n_dot_l) -
                       static_cast<long double>(raster::dot(m, raster::wide(d))) / l),
                   {m[0], m[1], m[2], d[0], d[1], d[2]});
    }
}

// The squares are made here as shading.cpp makes them; shade() of a surface with a highlight alone
// holds them equal, as far as a level shows them.
bool highlights() {
    std::vector<std::int64_t> square(16385);
    for (std::size_t h = 0; h <= 16384; ++h) square[h] = static_cast<std::int64_t>(h);
    raster::ShadingSpec spec(0, {}, {});
    raster::Material material{};
    Verdict same("highlight");
    for (int k = 1; k <= 9; ++k) {
        Worst worst("highlight_" + std::to_string(k));
        for (std::size_t h = 0; h <= 16384; ++h) {
            square[h] = fixed::round_shift(square[h] * square[h], 14, fixed::Rounding::half_up);
            const long double exact =
                16384 * std::pow(static_cast<long double>(h) / 16384, std::ldexp(1.0L, k));
            worst.add(static_cast<double>(static_cast<long double>(square[h]) - exact),
                      {static_cast<Wide>(h)});
            material.specular = 255;
            material.diffuse = 0;
            material.shininess = k;
            const raster::Cosines c{1, 0, -static_cast<std::int64_t>(h)};
            const raster::Shades s = raster::shade(std::span(&c, 1), spec, material, 0);
            same.equal(s[0].intensity, (255 * square[h] + (1 << 13)) >> 14,
                       Given{static_cast<Wide>(h), k});
        }
    }
    return same.tell();
}

void levels() {
    Worst worst("level");
    raster::Material material{};
    for (int d = 0; d < 256; ++d)
        for (int ambient = 0; ambient <= 256; ++ambient) {
            const raster::ShadingSpec spec(ambient, {}, {});
            material.diffuse = d;
            const raster::Shades s = raster::shade({}, spec, material, 0);
            worst.add(ratio(s[0].intensity * 256 - d * ambient, 256), {d, ambient});
        }
}

}  // namespace

bool surface_errors() {
    Words words;
    halvings(words);
    corrections(words);
    deepest(words);
    vectors(words);
    levels();
    return highlights();
}

}  // namespace umbra78::proofs
