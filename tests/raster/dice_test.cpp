// Dicing: vertices against the exact sum, borders of the same words, levels within their
// tolerance, and no crack between patches of different levels.
#include "fixed/rational.hpp"
#include "raster/dice.hpp"
#include "tests/support/drawing.hpp"
#include "tests/support/effort.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <random>
#include <vector>

namespace umbra78::raster {
namespace {

using fixed::Rational;
using umbra78::test::effort;

class Words {
public:
    explicit Words(std::uint64_t seed) : bits_(seed) {}
    std::int32_t within(std::int64_t reach) {
        return static_cast<std::int32_t>(
            static_cast<std::int64_t>(bits_() % static_cast<std::uint64_t>(2 * reach + 1)) - reach);
    }
    Patch patch(std::int64_t reach) {
        Patch p;
        for (World& w : p.control) w = {within(reach), within(reach), within(reach)};
        return p;
    }

private:
    std::mt19937_64 bits_;
};

DiceLevels uniform(int level) { return {level, {level, level, level, level}}; }

// By de Casteljau's algorithm in rationals: another way to the same point.
std::int64_t exact_word(const Patch& p, std::int32_t World::*axis, int i, int j, int k) {
    const auto at = [](std::array<Rational, 4>& c, int a) -> Rational& {
        return c[static_cast<std::size_t>(a)];
    };
    const auto curve = [&](std::array<Rational, 4> c, int n) {
        for (int last = 3; last > 0; --last)
            for (int a = 0; a < last; ++a)
                at(c, a) = at(c, a) + (at(c, a + 1) - at(c, a)) * Rational(n, k);
        return c[0];
    };
    std::array<Rational, 4> rows;
    for (std::size_t b = 0; b < 4; ++b)
        rows[b] = curve({Rational(p.control[4 * b].*axis), Rational(p.control[4 * b + 1].*axis),
                         Rational(p.control[4 * b + 2].*axis),
                         Rational(p.control[4 * b + 3].*axis)}, i);
    std::int64_t word = 0;
    EXPECT_TRUE(curve(rows, j).round_scaled(0, fixed::Rounding::half_even, word));
    return word;
}

TEST(Dice, VerticesAreTheExactSumsRoundedOnce) {
    Words words(51);
    const auto memory = std::make_unique<DiceMemory>();
    for (int n = 0; n < effort(40); ++n) {
        const Patch p = words.patch(n % 3 == 0 ? max_world : 1 << 18);
        const int level = n % 6, k = 1 << level;
        const Mesh mesh = dice(p, uniform(level), false, *memory);
        ASSERT_EQ(mesh.vertices.size(), static_cast<std::size_t>((k + 1) * (k + 1)));
        ASSERT_EQ(mesh.facets.size(), static_cast<std::size_t>(2 * k * k));
        for (int j = 0; j <= k; j += 1 + k / 5) {
            for (int i = 0; i <= k; i += 1 + k / 7) {
                const World& v = mesh.vertices[static_cast<std::size_t>(j * (k + 1) + i)];
                EXPECT_EQ(v.x, exact_word(p, &World::x, i, j, k)) << n;
                EXPECT_EQ(v.y, exact_word(p, &World::y, i, j, k)) << n;
                EXPECT_EQ(v.z, exact_word(p, &World::z, i, j, k)) << n;
            }
        }
        EXPECT_EQ(mesh.vertices.front(), p.control[0]);
        EXPECT_EQ(mesh.vertices.back(), p.control[15]);
    }
}

TEST(Dice, BordersAreTheSameWordsFromEitherSide) {
    Words words(52);
    const auto memory = std::make_unique<DiceMemory>();
    for (int n = 0; n < effort(60); ++n) {
        const Patch left = words.patch(1 << 20);
        Patch right = words.patch(1 << 20);
        for (std::size_t j = 0; j < 4; ++j)  // left's side u = 1 is right's side v = 0, reversed
            right.control[j] = left.control[4 * (3 - j) + 3];
        const int level = n % 6;
        const auto k = std::size_t{1} << level;
        const Mesh a = dice(left, uniform(level), false, *memory);
        std::vector<World> border;
        for (std::size_t j = 0; j <= k; ++j) border.push_back(a.vertices[j * (k + 1) + k]);
        const Mesh b = dice(right, uniform(level), false, *memory);
        for (std::size_t i = 0; i <= k; ++i) EXPECT_EQ(b.vertices[i], border[k - i]) << n;
    }
}

TEST(Dice, TakesAsFewLevelsAsItsToleranceAllows) {
    const Patch flat = plane_patch(umbra78::test::plane({-1, 0, -1}, {2, 0, 0}, {0, 0.3, 2}));
    EXPECT_EQ(dice_levels(flat, 5, 8).patch, 0);
    std::array<Patch, patches_per_sphere> sphere;
    sphere_patches(umbra78::test::sphere(0, 0, 0, 1), sphere);
    const auto memory = std::make_unique<DiceMemory>();
    int finest = 0;
    for (const std::int64_t tolerance : {3000, 300, 30, 3}) {
        for (const Patch& patch : sphere) {
            const DiceLevels levels = dice_levels(patch, 5, tolerance);
            finest = std::max(finest, levels.patch);
            for (const int edge : levels.edge) EXPECT_LE(edge, levels.patch);
            if (levels.patch == 5) continue;
            // The middles of all facets' sides lie within the tolerance of the sphere, by which its
            // patches are meant here; those differ from it by 4e-6 of the radius.
            const Mesh mesh = dice(patch, levels, false, *memory);
            for (const Facet& f : mesh.facets) {
                for (std::size_t c = 0; c < 3; ++c) {
                    const World &p = mesh.vertices[f.vertex[c]],
                                &q = mesh.vertices[f.vertex[(c + 1) % 3]];
                    const double x = (double(p.x) + q.x) / 2, y = (double(p.y) + q.y) / 2,
                                 z = (double(p.z) + q.z) / 2;
                    EXPECT_LE(std::abs(std::sqrt(x * x + y * y + z * z) - 65536),
                              1.8 * static_cast<double>(tolerance) + 2);
                }
            }
        }
    }
    EXPECT_EQ(finest, 5);
    EXPECT_EQ(dice_levels(sphere[9], 3, 0).patch, 3);
}

// Two halves of a sheet, one curved and so of more levels, over their shared straight border; and a
// sphere, whose patches at the poles have others than those at the equator.
TEST(Dice, PatchesOfDifferentLevelsLeaveNoCrack) {
    Words words(53);
    const hw::MachineSpec spec{.xy_bits = 7};
    int differing = 0;
    for (int n = 0; n < effort(60); ++n) {
        const std::int64_t bulge = words.within(1 << 16);
        std::vector<Patch> sheet{
            plane_patch(umbra78::test::plane({-1.5, -1.5, 0}, {1.5, 0, 0}, {0, 3, 0})),
            plane_patch(umbra78::test::plane({0, -1.5, 0}, {1.5, 0, 0}, {0, 3, 0}))};
        for (const std::size_t k : {5u, 6u, 9u, 10u, 7u, 11u})
            sheet[1].control[k].z += static_cast<std::int32_t>(bulge);
        // The shared border is curved where n is odd, more than the left patch within.
        if (n % 2 == 1)
            for (const std::size_t j : {1u, 2u}) {
                const std::int32_t off = words.within(1 << 15);
                sheet[0].control[4 * j + 3].x += off;
                sheet[1].control[4 * j].x += off;
            }
        const View view = umbra78::test::orthographic(0, 0, 1.4);
        umbra78::test::Drawing<> drawing(spec);
        drawing.form = PatchForm::diced;
        drawing.dice_levels = 4;
        drawing.dice_tolerance = 40;
        drawing.draw(sheet, view, Sampling::centre);
        const DiceLevels a = dice_levels(sheet[0], 4, 40), b = dice_levels(sheet[1], 4, 40);
        EXPECT_EQ(a.edge[3], b.edge[2]);
        differing += a.patch != b.patch && b.edge[2] < b.patch ? 1 : 0;
        for (std::size_t k = 0; k < drawing.depth().size(); ++k)
            ASSERT_NE(drawing.depth()[k], spec.background()) << n << ": a hole at " << k;
    }
    EXPECT_GT(differing, effort(20));
}

// Where a border has fewer levels than its patch, vertices fall together: what is left of a facet
// then is a line, and no facet.
TEST(Dice, MakesNoFacetOfTwoCorners) {
    Words words(71);
    const auto memory = std::make_unique<DiceMemory>();
    for (int n = 0; n < 200; ++n) {
        DiceLevels levels{3, {}};
        for (int& edge : levels.edge) edge = static_cast<int>(words.within(1) + 2);
        for (const Facet& f : dice(words.patch(1 << 16), levels, false, *memory).facets) {
            ASSERT_NE(f.vertex[0], f.vertex[1]);
            ASSERT_NE(f.vertex[1], f.vertex[2]);
            ASSERT_NE(f.vertex[2], f.vertex[0]);
        }
    }
}

TEST(Dice, DrawsWhatSubdivisionDraws) {
    umbra78::test::Patches patches;
    umbra78::test::add_sphere(patches, umbra78::test::sphere(-0.5, 0.4, 0, 1.1));
    umbra78::test::add_sphere(patches, umbra78::test::sphere(0.9, -0.7, 0.4, 0.8));
    const View view = umbra78::test::orthographic(20, 30, 2);
    const View light = umbra78::test::orthographic(-60, 40, 2);
    umbra78::test::Drawing<> exact, diced, front;
    exact.draw(patches, view, Sampling::centre, &light);
    diced.form = front.form = PatchForm::diced;
    diced.dice_tolerance = front.dice_tolerance = (2 << 16) >> 10;
    front.facing = Facing::front;
    const DrawCounts counts = diced.draw(patches, view, Sampling::centre, &light);
    EXPECT_EQ(counts.diced_patches, patches.size());
    EXPECT_EQ(counts.subdivided(), 0u);
    EXPECT_GT(counts.facets, 1000u);
    EXPECT_EQ(counts.blocks, 0u);
    const DrawCounts fronts = front.draw(patches, view, Sampling::centre, &light);
    EXPECT_GT(fronts.turned_triangles, counts.facets / 3);
    EXPECT_EQ(front.depth(), diced.depth());  // closed surfaces hide their backs
    EXPECT_EQ(front.intensity(), diced.intensity());
    int both = 0, apart = 0, off = 0;
    for (std::size_t k = 0; k < exact.depth().size(); ++k) {
        const bool a = exact.depth()[k] != 65535, b = diced.depth()[k] != 65535;
        apart += a != b ? 1 : 0;
        if (!a || !b) continue;
        ++both;
        off += std::abs(exact.intensity()[k] - diced.intensity()[k]) > 3 ? 1 : 0;
    }
    EXPECT_GT(both, 80000);
    EXPECT_LT(apart, 700);  // of some 1600 along the outlines
    EXPECT_LT(off, both / 50);
}

}  // namespace
}  // namespace umbra78::raster
