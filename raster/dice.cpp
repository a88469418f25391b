#include "raster/dice.hpp"

#include "fixed/rounding.hpp"
#include "fixed/trap.hpp"

#include <algorithm>

namespace umbra78::raster {
namespace {

using fixed::Rounding;
using Controls = std::array<WideVector, 16>;

// A control word and its weights: 31 + 6 levels bits, the sum of all weights being k^6.
static_assert(31 + 6 * max_dice_levels + 1 < 63);

Controls controls_of(const Patch& patch) {
    Controls p;
    for (std::size_t k = 0; k < 16; ++k)
        p[k] = {patch.control[k].x, patch.control[k].y, patch.control[k].z};
    return p;
}

// The greatest component of a second difference from `at` on, in steps of `step`.
std::int64_t second(const Controls& p, std::size_t at, std::size_t step) {
    std::int64_t max = 0;
    for (std::size_t c = 0; c < 3; ++c)
        for (const std::size_t from : {at, at + step})
            max = std::max(max, std::abs(p[from][c] - 2 * p[from + step][c] +
                                         p[from + 2 * step][c]));
    return max;
}

// The same of the mixed differences of all squares of the net.
std::int64_t mixed(const Controls& p) {
    std::int64_t max = 0;
    for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t c = 0, k = 4 * j + i; c < 3; ++c)
                max = std::max(max, std::abs(p[k][c] - p[k + 1][c] - p[k + 4][c] + p[k + 5][c]));
    return max;
}

// The least level at which departure / 4^level <= 8 tolerance.
int level_of(std::int64_t departure, int most, std::int64_t tolerance) {
    int level = 0;
    while (level < most && departure > (8 * tolerance << 2 * level)) ++level;
    return level;
}

// Bernstein's weights at i of k cells, times k^3, and their slopes' (of three differences), k^2.
struct Weights {
    std::array<std::int64_t, 4> at;
    std::array<std::int64_t, 3> slope;

    Weights(std::int64_t i, std::int64_t k)
        : at{(k - i) * (k - i) * (k - i), 3 * i * (k - i) * (k - i), 3 * i * i * (k - i),
             i * i * i},
          slope{(k - i) * (k - i), 2 * i * (k - i), i * i} {}
};

// Points, or differences of points, summed with their weights.
template <class Weight>
WideVector sum(const std::array<WideVector, 4>& p, const Weight& w) {
    WideVector s{};
    for (std::size_t a = 0; a < w.size(); ++a)
        for (std::size_t c = 0; c < 3; ++c) s[c] += w[a] * p[a][c];
    return s;
}

std::array<WideVector, 4> differences(const std::array<WideVector, 4>& p) {
    std::array<WideVector, 4> d{};
    for (std::size_t a = 0; a < 3; ++a)
        for (std::size_t c = 0; c < 3; ++c) d[a][c] = p[a + 1][c] - p[a][c];
    return d;
}

// The net summed along u at number i of k: four points of a curve in v, and of the tangents in u.
struct Column {
    std::array<WideVector, 4> points, along_u;

    Column(const Controls& p, std::int64_t i, std::int64_t k) {
        const Weights u(i, k);
        for (std::size_t b = 0; b < 4; ++b) {
            const std::array row{p[4 * b], p[4 * b + 1], p[4 * b + 2], p[4 * b + 3]};
            points[b] = sum(row, u.at);
            along_u[b] = sum(differences(row), u.slope);
        }
    }
    WideVector point(const Weights& v) const { return sum(points, v.at); }
    WideVector tangent_u(const Weights& v) const { return sum(along_u, v.at); }
    WideVector tangent_v(const Weights& v) const { return sum(differences(points), v.slope); }
};

// Where an edge is a point its tangent is 0, and that of the next row or column within is taken.
UnitVector normal(const Controls& p, const Column& column, std::int64_t i, std::int64_t j,
                  std::int64_t k) {
    const auto inward = [&](std::int64_t n) { return n == 0 ? 1 : k - 1; };
    const Weights v(j, k);
    WideVector tu = column.tangent_u(v), tv = column.tangent_v(v);
    if (is_zero(tu)) tu = column.tangent_u(Weights(inward(j), k));
    if (is_zero(tv)) tv = Column(p, inward(i), k).tangent_v(v);
    return unit_vector(cross(scaled_to(tu, 30), scaled_to(tv, 30)));
}

}  // namespace

DiceLevels dice_levels(const Patch& patch, int most, std::int64_t tolerance) {
    fixed::require(most >= 0 && most <= max_dice_levels, "dice: levels outside 0..5");
    const Controls p = controls_of(patch);
    std::int64_t uu = 0, vv = 0;
    for (std::size_t k = 0; k < 4; ++k) {
        uu = std::max(uu, second(p, 4 * k, 1));
        vv = std::max(vv, second(p, k, 4));
    }
    const auto level = [&](std::int64_t departure) { return level_of(departure, most, tolerance); };
    return {level(6 * uu + 18 * mixed(p) + 6 * vv),
            {level(6 * second(p, 0, 1)), level(6 * second(p, 12, 1)), level(6 * second(p, 0, 4)),
             level(6 * second(p, 3, 4))}};
}

Mesh dice(const Patch& patch, const DiceLevels& levels, bool normals, DiceMemory& memory) {
    const Controls p = controls_of(patch);
    const auto k = std::uint32_t{1} << levels.patch;
    const std::uint32_t side = k + 1;
    const auto word = [&](std::int64_t v) {
        return static_cast<std::int32_t>(
            fixed::round_shift(v, 6 * levels.patch, Rounding::half_even));
    };
    for (std::uint32_t i = 0; i <= k; ++i) {
        const Column column(p, i, k);
        for (std::uint32_t j = 0; j <= k; ++j) {
            const WideVector s = column.point(Weights(j, k));
            const std::uint32_t at = j * side + i;
            memory.vertices[at] = {word(s[0]), word(s[1]), word(s[2])};
            if (normals) memory.normals[at] = normal(p, column, i, j, k);
        }
    }
    // A vertex of an edge moves down to the next that its edge keeps.
    const auto kept = [&](std::uint32_t n, int edge) {
        return n & ~((k >> levels.edge[static_cast<std::size_t>(edge)]) - 1);
    };
    const auto vertex = [&](std::uint32_t i, std::uint32_t j) {
        if (j == 0 || j == k) i = kept(i, j == 0 ? 0 : 1);
        if (i == 0 || i == k) j = kept(j, i == 0 ? 2 : 3);
        return j * side + i;
    };
    std::size_t count = 0;
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        if (a == b || b == c || c == a) return;
        Facet& facet = memory.facets[count++];
        facet.vertex = {a, b, c};
        facet.normal = normals ? facet.vertex
                               : std::array{Facet::flat, Facet::flat, Facet::flat};
        facet.material = patch.material;
    };
    for (std::uint32_t j = 0; j < k; ++j) {
        for (std::uint32_t i = 0; i < k; ++i) {
            const std::uint32_t c00 = vertex(i, j), c10 = vertex(i + 1, j);
            const std::uint32_t c01 = vertex(i, j + 1), c11 = vertex(i + 1, j + 1);
            add(c00, c10, c11);
            add(c00, c11, c01);
        }
    }
    const std::size_t vertices = std::size_t{side} * side;
    return {std::span(memory.vertices).first(vertices),
            std::span(memory.normals).first(normals ? vertices : 0),
            std::span(memory.facets).first(count)};
}

}  // namespace umbra78::raster
