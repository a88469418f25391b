// Catmull's split against de Casteljau in exact integers, and the bounds against dense samples.
#include "tests/raster/exact_surface.hpp"
#include "tests/support/effort.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace umbra78::raster {
namespace {

using namespace test;

// How far each field may stand from the exact one. Every halving rounds once, by half a unit, and
// hands on its operands' errors (block.hpp's formulas, with absolute values).
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
    EXPECT_LT(worst, 8) << "a tenth of a quantum is 6.4 units";
}

// On every block of a random descent: the exact surface stays within least .. greatest, moves no
// faster than the slopes and bends no more than the bends; the splits' own error aside.
TEST(Block, BoundsHoldForDenseSamples) {
    Random random;
    constexpr int dense = 16, n = 32 * dense;  // a step of the whole patch is 1/n
    for (int trial = 0; trial < umbra78::test::effort(300); ++trial) {
        const Control p = random_control(random, std::int64_t{1} << random.between(8, 25));
        Component c = component_from_bezier(p);
        ErrorBound error;
        int u = 0, v = 0, size = 32;
        while (size > 1) {
            Component low, high, left, right;
            split_u(c, low, high);
            u = 2 * u + static_cast<int>(random.bits() % 2);
            split_v(u % 2 == 0 ? low : high, left, right);
            v = 2 * v + static_cast<int>(random.bits() % 2);
            c = v % 2 == 0 ? left : right;
            size /= 2;
            error.halve_u();
            error.halve_v();
            const Bounds b = bounds(c);
            const double tolerance = 8 * (error.f + error.gu + error.gv + error.guv);
            const int step = size, i0 = u * size * dense, j0 = v * size * dense;
            const auto at = [&](int i, int j) { return value(p, i0 + i * step, j0 + j * step, n); };
            const auto within = [&](double measured, std::int64_t limit) {
                EXPECT_LE(std::abs(measured), static_cast<double>(limit) + tolerance)
                    << "trial " << trial << ", block of 1/" << 32 / size;
            };
            for (int j = 0; j <= dense; ++j) {
                for (int i = 0; i <= dense; ++i) {
                    const double f = at(i, j);
                    ASSERT_GE(f, static_cast<double>(b.min) - tolerance);
                    ASSERT_LE(f, static_cast<double>(b.max) + tolerance);
                    if (i < dense) within((at(i + 1, j) - f) * dense, b.slope_u);
                    if (j < dense) within((at(i, j + 1) - f) * dense, b.slope_v);
                    // An eighth of the mean second derivative over two steps.
                    constexpr double eighth = dense * dense / 8.0;
                    if (i > 0 && i < dense)
                        within((at(i - 1, j) - 2 * f + at(i + 1, j)) * eighth, b.bend_u);
                    if (j > 0 && j < dense)
                        within((at(i, j - 1) - 2 * f + at(i, j + 1)) * eighth, b.bend_v);
                }
            }
            if (HasFailure()) return;
        }
    }
}

}  // namespace
}  // namespace umbra78::raster
