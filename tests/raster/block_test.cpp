// Catmull's split: bit for bit that of hw/MACHINE.md's text, and against de Casteljau's algorithm
// in exact integers; the bounds against dense samples.
#include "tests/raster/exact_blocks.hpp"
#include "tests/support/effort.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace umbra78::raster {
namespace {

using namespace test;

// How far each field may differ from the exact one. Every halving rounds once, by half a unit, and
// passes on its operands' errors (block.hpp's formulas, with absolute values).
struct ErrorBound {
    double f = 0, gu = 0.5, gv = 0.5, guv = 0.5;
    void halve_u() {
        f += gu + 0.5;
        gv += guv + 0.5;
        gu = gu / 4 + 0.5;
        guv = guv / 4 + 0.5;
    }
    void halve_v() {
        std::swap(gu, gv);
        halve_u();
        std::swap(gu, gv);
    }
};

TEST(Block, CornersOfAPatchAreItsEndControlPoints) {
    Control p{};
    for (std::size_t k = 0; k < 16; ++k) p[k] = static_cast<std::int64_t>(100 * k * k);
    const Component c = component_from_bezier(p);
    EXPECT_EQ(c.f, (std::array{p[0], p[3], p[12], p[15]}));
    // 3/4 of the second differences: 100 ((k+2)^2 - 2 (k+1)^2 + k^2) = 200 along u, 3 200 along v.
    EXPECT_EQ(c.gu, (std::array<std::int64_t, 4>{150, 150, 150, 150}));
    EXPECT_EQ(c.gv, (std::array<std::int64_t, 4>{2400, 2400, 2400, 2400}));
    EXPECT_EQ(c.guv, (std::array<std::int64_t, 4>{}));
}

// Random patches, split at random down to 8 halvings each way.
TEST(Block, SplittingStaysWithinItsErrorBound) {
    Random random;
    double worst = 0, worst_share = 0;
    for (int n = 0; n < umbra78::test::effort(20000); ++n) {
        const Control p = random_control(random, std::int64_t{1} << random.between(4, 25));
        Component c = component_from_bezier(p);
        ErrorBound bound;
        int u = 0, v = 0, nu = 1, nv = 1;  // the block is [u, u + 1] / nu x [v, v + 1] / nv
        while (nu < 256 || nv < 256) {
            const bool along_u = nv == 256 || (nu < 256 && random.bits() % 2 == 0);
            const int high = static_cast<int>(random.bits() % 2);
            Component parts[2];
            along_u ? split_u(c, parts[0], parts[1]) : split_v(c, parts[0], parts[1]);
            c = parts[high];
            (along_u ? u : v) = 2 * (along_u ? u : v) + high;
            (along_u ? nu : nv) *= 2;
            along_u ? bound.halve_u() : bound.halve_v();
            for (std::size_t k = 0; k < 4; ++k) {
                const int i = (u + static_cast<int>(k % 2)) * (256 / nu);
                const int j = (v + static_cast<int>(k / 2)) * (256 / nv);
                const Int128 off = c.f[k] * sixth_power(256) - exact_value(p, i, j, 256);
                const double error =
                    std::abs(static_cast<double>(off) / static_cast<double>(sixth_power(256)));
                ASSERT_LE(error, bound.f) << "patch " << n << ", 1/" << nu << " x 1/" << nv;
                worst = std::max(worst, error);
                worst_share = std::max(worst_share, error / bound.f);
            }
        }
    }
    std::cout << "[ measured ] worst error of a corner " << worst << " units, "
              << 100 * worst_share << " % of the bound\n";
}

// Components, halves and bounds are those of hw/MACHINE.md's text, on random descents of 12 splits
// from control words of up to 55 bits, the largest that a view may give.
TEST(Block, IsTheTextsBitForBit) {
    Random random;
    for (int n = 0; n < umbra78::test::effort(5000); ++n) {
        const Control p = random_control(random, std::int64_t{1} << random.between(1, 55));
        std::array<Int128, 16> control{};
        std::copy(p.begin(), p.end(), control.begin());
        Component c = component_from_bezier(p);
        ExactComponent e = exact_component(control);
        for (int level = 0; level <= 12; ++level) {
            ASSERT_TRUE(equal(e, c)) << "patch " << n << ", level " << level;
            ASSERT_TRUE(equal(exact_bounds(e), bounds(c))) << "patch " << n << ", level " << level;
            const bool along_u = random.bits() % 2 == 0;
            Component half[2];
            along_u ? split_u(c, half[0], half[1]) : split_v(c, half[0], half[1]);
            const auto exact_half = exact_split(e, along_u);
            const std::size_t k = random.bits() % 2;
            ASSERT_TRUE(equal(exact_half[1 - k], half[1 - k])) << "patch " << n;
            c = half[k];
            e = exact_half[k];
        }
    }
}

// Control points that are multiples of 2^36 leave nothing to round in five splits each way, so a
// block is the exact surface: its bounds hold for every one of dense samples, without tolerance.
TEST(Block, BoundsHoldForTheExactSurface) {
    Random random;
    constexpr int dense = 16, n = 32 * dense;  // a step of the whole patch is 1/n
    for (int trial = 0; trial < umbra78::test::effort(150); ++trial) {
        Control p = random_control(random, 1 << random.between(1, 15));
        if (trial % 5 == 0)  // flat edges, and a middle that is not
            for (std::size_t k = 0; k < 16; ++k)
                if (k % 4 % 3 == 0 || k / 4 % 3 == 0) p[k] = -7;
        for (std::int64_t& c : p) c *= std::int64_t{1} << 36;
        Component c = component_from_bezier(p);
        int u = 0, v = 0;
        for (int size = 32; size >= 1; size /= 2) {
            const Bounds b = bounds(c);
            const int i0 = u * size * dense, j0 = v * size * dense;
            // Times n^6, as all that follows.
            const auto at = [&](int i, int j) {
                return exact_value(p, i0 + i * size, j0 + j * size, n);
            };
            const auto within = [&](Int128 measured, Int128 limit) {
                ASSERT_TRUE((measured < 0 ? -measured : measured) <= limit * sixth_power(n))
                    << "trial " << trial << ", block of 1/" << 32 / size;
            };
            for (int j = 0; j <= dense; ++j) {
                for (int i = 0; i <= dense; ++i) {
                    const Int128 f = at(i, j);
                    ASSERT_TRUE(f >= b.min * sixth_power(n) && f <= b.max * sixth_power(n))
                        << "trial " << trial << ", block of 1/" << 32 / size;
                    if (i < dense) within((at(i + 1, j) - f) * dense, b.slope_u);
                    if (j < dense) within((at(i, j + 1) - f) * dense, b.slope_v);
                    // An eighth of the mean second derivative over two steps.
                    constexpr int eighth = dense * dense / 8;
                    if (i > 0 && i < dense)
                        within((at(i - 1, j) - 2 * f + at(i + 1, j)) * eighth, b.bend_u);
                    if (j > 0 && j < dense)
                        within((at(i, j - 1) - 2 * f + at(i, j + 1)) * eighth, b.bend_v);
                    if (HasFailure()) return;
                }
            }
            Component low, high, left, right;
            split_u(c, low, high);
            u = 2 * u + static_cast<int>(random.bits() % 2);
            split_v(u % 2 == 0 ? low : high, left, right);
            v = 2 * v + static_cast<int>(random.bits() % 2);
            c = v % 2 == 0 ? left : right;
        }
    }
}

}  // namespace
}  // namespace umbra78::raster
