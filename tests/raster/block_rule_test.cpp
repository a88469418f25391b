// The block rule and the bounds of quotients are those of hw/MACHINE.md's text: at every limit and
// one beyond, and for random blocks of any size. And the bounds hold, exactly, for the surface.
#include "raster/block_rule.hpp"
#include "tests/raster/exact_blocks.hpp"
#include "tests/support/drawing.hpp"
#include "tests/support/effort.hpp"

#include <gtest/gtest.h>

namespace umbra78::raster {
namespace {

using namespace test;
using umbra78::test::effort;

BlockAction by_text(const ScreenBounds& b, const hw::MachineSpec& m) {
    return exact_rule({exact_bounds(b[0]), exact_bounds(b[1]), exact_bounds(b[2])}, m);
}

constexpr std::int64_t huge = std::int64_t{1} << 58;

// Each field near one of the rule's limits, now and then far off.
Bounds near_a_limit(Random& random, const hw::MachineSpec& m, bool depth) {
    const std::int64_t side = depth ? (m.depth_offset() + 1) * (1 << guard_of(m))
                                    : m.half_px() * 8192 + 128;
    const auto one_of = [&](std::initializer_list<std::int64_t> values) {
        return *(values.begin() + random.bits() % values.size()) + random.between(-1, 1);
    };
    Bounds b{};
    b.min = one_of({-side, -1000, 0, side, -(1 << 29), -(1 << 28)});
    b.max = one_of({-side, 1000, 0, side, 1 << 29, 1 << 28});
    if (b.min > b.max) std::swap(b.min, b.max);
    for (std::int64_t* s : {&b.slope_u, &b.slope_v})
        *s = one_of({1, 60000, 63488, 126976, 131072, 1 << 30, huge, 2 * huge});
    for (std::int64_t* s : {&b.bend_u, &b.bend_v})
        *s = one_of({1, 4000, 8192, 7936, 1 << 26, huge, 3 * huge - 1});
    if (random.bits() % 2 == 0) b.slope_u = b.slope_v = 1 << 12;  // small in this respect
    if (random.bits() % 2 == 0) b.bend_u = b.bend_v = 1 << 9;
    return b;
}

TEST(BlockRule, IsTheTextsAtEveryLimitAndOneBeyond) {
    Random random;
    std::array<int, 4> seen{};
    for (int n = 0; n < effort(400000); ++n) {
        hw::MachineSpec m;
        m.xy_bits = static_cast<int>(random.between(4, 12));
        m.z_bits = static_cast<int>(random.between(4, 24));
        const ScreenBounds b{near_a_limit(random, m, false), near_a_limit(random, m, false),
                             near_a_limit(random, m, true)};
        const BlockAction expected = by_text(b, m);
        ASSERT_EQ(block_action(b, m), expected) << "case " << n;
        ++seen[static_cast<std::size_t>(expected)];
        ASSERT_EQ(unbounded_both_ways(b),
                  exact_says_nothing({exact_bounds(b[0]), exact_bounds(b[1]), exact_bounds(b[2])}));
    }
    for (const int count : seen) EXPECT_GT(count, 1000);
}

TEST(BlockRule, RasterUnitsFitTheirWordsAtEveryWidth) {
    for (int z = 4; z <= 24; ++z) {
        hw::MachineSpec m;
        m.z_bits = z;
        EXPECT_EQ(depth_guard(m), guard_of(m));
        EXPECT_LE(m.depth_offset() << depth_guard(m), std::int64_t{1} << 25);
    }
}

Component random_component(Random& random, std::int64_t size, std::int64_t bend) {
    Component c;
    for (std::size_t k = 0; k < 4; ++k) {
        c.f[k] = random.between(-size, size);
        c.gu[k] = random.between(-bend, bend);
        c.gv[k] = random.between(-bend, bend);
        c.guv[k] = random.between(-bend, bend);
    }
    return c;
}

// Blocks before, across and behind the eye, near and thousands of frames away, of all sizes.
TEST(ProjectedBounds, AreTheTexts) {
    Random random;
    int bounded = 0, outside = 0, unknown = 0, far = 0;
    for (int n = 0; n < effort(200000); ++n) {
        hw::MachineSpec m;
        m.xy_bits = static_cast<int>(random.between(4, 12));
        m.z_bits = static_cast<int>(random.between(4, 24));
        std::array<Component, 4> c;
        const std::int64_t w = std::int64_t{1} << random.between(1, 42);
        c[3] = random_component(random, w / 4 + 1, w >> random.between(3, 20));
        const std::int64_t before = random.between(-2, 8) * (w / 8);
        for (std::int64_t& f : c[3].f) f += before;
        const bool distant = random.bits() % 4 == 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::int64_t down = random.between(-5, 20);  // below 0: a single unit
            const std::int64_t size = std::max<std::int64_t>(down < 0 ? 0 : w >> down, 1);
            c[k] = random_component(random, std::min(size, std::int64_t{1} << 42),
                                    std::min(size >> random.between(2, 20), std::int64_t{1} << 43));
            const std::int64_t px = distant ? random.between(-5000, 5000)
                                            : random.between(-2 * m.size_px(), 2 * m.size_px());
            if (std::abs(px) * w < std::int64_t{1} << 42)
                for (std::size_t q = 0; q < 4; ++q) c[k].f[q] += px * c[3].f[q];
        }
        const std::array<ExactComponent, 4> e{exact_component(c[0]), exact_component(c[1]),
                                              exact_component(c[2]), exact_component(c[3])};
        ScreenBounds bounds{};
        ExactScreen expected{};
        const Visibility v = projected_bounds(c, m, bounds);
        ASSERT_EQ(v, exact_projected(e, m, expected)) << "case " << n;
        ++(v == Visibility::bounded ? bounded : v == Visibility::outside ? outside : unknown);
        if (v != Visibility::bounded) continue;
        for (std::size_t k = 0; k < 3; ++k)
            ASSERT_TRUE(equal(expected[k], bounds[k])) << "case " << n << ", row " << k;
        far += magnitude(floor_of(c[0].f[0], c[3].f[0])) > 4000 ? 1 : 0;
    }
    EXPECT_GT(bounded, 1000);
    EXPECT_GT(outside, 1000);
    EXPECT_GT(unknown, 1000);
    EXPECT_GT(far, effort(100));
}

// The products that are not made because they could be too large: at each of the limits 2^26 of the
// reach, 2^28 of the slope, 2^30 and 2^31 of W's slope, and next to them.
TEST(ProjectedBounds, AreTheTextsWhereProductsGetTooLarge) {
    const hw::MachineSpec m;
    constexpr std::int64_t w = 1 << 13;  // so a quotient in raster units is its dividend
    int huge_ones = 0;
    for (const std::int64_t v : {std::int64_t{1} << 13, std::int64_t{1} << 26}) {
        for (const std::int64_t d : {std::int64_t{0}, (std::int64_t{1} << 28) - v,
                                     std::int64_t{1} << 30, std::int64_t{1} << 31}) {
            for (std::int64_t dv = -5; dv <= 2; ++dv) {
                for (std::int64_t dd = d == 0 ? 0 : -9; dd <= (d == 0 ? 0 : 2); ++dd) {
                    std::array<Component, 4> c{};
                    c[3].f = {w, w + d + dd, w, w + d + dd};
                    for (std::size_t k = 0; k < 3; ++k) c[k].f = {0, v + dv, 0, v + dv};
                    std::array<ExactComponent, 4> e;
                    for (std::size_t k = 0; k < 4; ++k) e[k] = exact_component(c[k]);
                    ScreenBounds bounds{};
                    ExactScreen expected{};
                    ASSERT_EQ(projected_bounds(c, m, bounds), Visibility::bounded);
                    ASSERT_EQ(exact_projected(e, m, expected), Visibility::bounded);
                    for (std::size_t k = 0; k < 3; ++k)
                        ASSERT_TRUE(equal(expected[k], bounds[k])) << v + dv << ", " << d + dd;
                    huge_ones += bounds[0].slope_u >= huge || bounds[0].bend_u >= huge ? 1 : 0;
                }
            }
        }
    }
    EXPECT_GT(huge_ones, 50);
}

// Control points that are multiples of 16 have exact corrections, so the quotient of two surfaces
// is known exactly at every place, and lies within its bounds without any tolerance.
TEST(ProjectedBounds, HoldForTheExactQuotient) {
    Random random;
    hw::MachineSpec m;
    int held = 0;
    for (int n = 0; n < effort(2000); ++n) {
        std::array<Control, 4> p{};
        const std::int64_t w = std::int64_t{1} << random.between(8, 36);
        const std::int64_t varies = w >> random.between(4, 8);
        for (std::int64_t& c : p[3]) c = 16 * random.between(w - varies, w);
        for (std::size_t k = 0; k < 3; ++k) {
            const std::int64_t at = random.between(-300, 300);
            const std::int64_t size = std::max<std::int64_t>(w >> random.between(0, 12), 1);
            for (std::size_t q = 0; q < 16; ++q)
                p[k][q] = at * p[3][q] + 16 * random.between(-size, size);
        }
        const std::array<Component, 4> c{component_from_bezier(p[0]), component_from_bezier(p[1]),
                                         component_from_bezier(p[2]), component_from_bezier(p[3])};
        ScreenBounds b{};
        if (projected_bounds(c, m, b) != Visibility::bounded) continue;
        ++held;
        for (std::size_t k = 0; k < 3; ++k) {
            const int out = k == 2 ? depth_out(m) : 13;
            for (int j = 0; j <= 8; ++j) {
                for (int i = 0; i <= 8; ++i) {
                    const Int128 x = exact_value(p[k], i, j, 8) * power(out);
                    const Int128 divisor = exact_value(p[3], i, j, 8);
                    ASSERT_TRUE(x >= b[k].min * divisor && x <= b[k].max * divisor)
                        << "trial " << n << ", row " << k << " at " << i << ", " << j;
                }
            }
        }
    }
    EXPECT_GT(held, effort(2000) / 2);
}

// All edges of the patch lie left of the frame, each of them flat; its middle bulges into view.
TEST(BlockRule, APatchWhoseMiddleAloneIsInViewIsDrawn) {
    for (const bool upright : {false, true}) {
        Patch p;
        for (int j = 0; j < 4; ++j) {
            for (int i = 0; i < 4; ++i) {
                const bool inner = (i == 1 || i == 2) && (j == 1 || j == 2);
                const auto across = umbra78::test::q16(inner ? 5.5 : -2.1);
                const auto up = umbra78::test::q16(-1.5 + j);
                p.control[static_cast<std::size_t>(4 * j + i)] =
                    upright ? World{up, across, umbra78::test::q16(0.4 * i - 0.6)}
                            : World{across, up, umbra78::test::q16(0.4 * i - 0.6)};
            }
        }
        for (const View& view : {umbra78::test::orthographic(0, 0, 2),
                                 umbra78::test::perspective(0, 0, 2, 9, 1, 30)}) {
            hw::MachineSpec spec;
            spec.coefficient_bits = 24;
            umbra78::test::Drawing<> stage(spec);
            const DrawCounts counts = stage.draw(umbra78::test::Patches{p}, view, Sampling::centre);
            EXPECT_GT(counts.samples, 10000u) << (upright ? "upright" : "across");
            EXPECT_TRUE(stage.drawn(256, 256));
        }
    }
}

}  // namespace
}  // namespace umbra78::raster
