// Every level is that of hw/MACHINE.md, section 9, bit for bit: random blocks, poles, degenerate
// and edge-on ones, every shininess, light and viewer at infinity and near.
#include "tests/raster/exact_drawing.hpp"
#include "tests/support/effort.hpp"

#include <gtest/gtest.h>

namespace umbra78::raster {
namespace {

using namespace test;
using umbra78::test::effort;

UnitVector random_unit(Random& random) {
    const std::int64_t size = std::int64_t{1} << random.between(1, 20);
    return unit_vector({random.between(-size, size), random.between(-size, size),
                        random.between(-size, size)});
}

Toward random_toward(Random& random) {
    Toward t;
    t.to_point = random.bits() % 2 == 0;
    t.direction = random_unit(random);
    for (std::int64_t& p : t.point) p = random.between(-(1 << 24), 1 << 24);
    return t;
}

std::array<Component, 3> random_world_block(Random& random, std::uint64_t kind) {
    std::array<Component, 3> world;
    const std::int64_t at = std::int64_t{1} << random.between(1, 21);
    const std::int64_t size = std::int64_t{1} << random.between(0, 20);
    for (Component& c : world) {
        const std::int64_t place = random.between(-at, at);
        for (std::size_t k = 0; k < 4; ++k) {
            c.f[k] = place + random.between(-size, size);
            for (auto* g : {&c.gu, &c.gv, &c.guv}) (*g)[k] = random.between(-size, size) / 4;
        }
        switch (kind) {
            case 0: c.f[1] = c.f[0]; c.gu[0] = c.gu[1] = 0; break;  // an edge v = 0 that is a point
            case 1: c.f[2] = c.f[0]; c.gv[0] = c.gv[2] = 0; break;  // an edge u = 0 that is one
            case 2: c.f = {place, place, place, place}; c.gu = c.gv = {}; break;  // a point
            case 3: c.gu = c.gv = c.guv = {}; break;
            default: break;
        }
    }
    return world;
}

TEST(Shading, LevelsAreTheTextsBitForBit) {
    Random random;
    std::array<int, 256> seen{};
    int unlit = 0, highlights = 0, cut = 0;
    for (int n = 0; n < effort(30000); ++n) {
        const auto world = random_world_block(random, random.bits() % 8);
        const Material material{static_cast<std::int32_t>(random.between(0, 255)),
                                static_cast<std::int32_t>(random.between(0, 255)),
                                static_cast<std::int32_t>(random.between(0, 8))};
        ShadingSpec spec{static_cast<std::int32_t>(random.between(0, 256)), random_toward(random),
                         random_toward(random)};
        spec.rule = static_cast<ShadingRule>(random.between(0, 3));
        const BlockShading shading(world, spec, material);
        const ExactShading exact({exact_component(world[0]), exact_component(world[1]),
                                  exact_component(world[2])}, spec, material);
        for (int k = 0; k < 6; ++k) {
            const int i = static_cast<int>(random.bits() % 16);
            const int j = static_cast<int>(random.bits() % 16);
            const Shade in_light = shading.shade(i, j, 0)[0];
            const Shade in_shadow = shading.shade(i, j, 1)[0];
            const Shade expected = exact.shade(i, j, false);
            ASSERT_EQ(in_light, expected) << "case " << n << ", leaf " << i << ", " << j;
            ASSERT_EQ(in_shadow, exact.shade(i, j, true))
                << "case " << n << ", leaf " << i << ", " << j;
            // The direct share is what a shadow takes away, whatever is cut at 255.
            ASSERT_EQ(in_light.intensity - in_light.direct[0], in_shadow.intensity);
            ASSERT_EQ(in_shadow.direct[0], 0);
            const int lit = in_light.intensity, dark = in_shadow.intensity;
            cut += lit == 255 ? 1 : 0;
            ++seen[static_cast<std::size_t>(lit)];
            unlit += lit == dark ? 1 : 0;
            highlights += lit - dark > material.diffuse[0] ? 1 : 0;
        }
    }
    EXPECT_GT(std::count_if(seen.begin(), seen.end(), [](int c) { return c > 0; }), 250);
    EXPECT_GT(unlit, 1000);
    EXPECT_GT(cut, effort(1000));
    EXPECT_GT(highlights, effort(1000));
}

// A block that faces along z, with light exactly along its surface and one step above and below.
TEST(Shading, LightAlongTheSurfaceIsNoLight) {
    std::array<Component, 3> world{};
    world[0].f = {0, 1 << 20, 0, 1 << 20};
    world[1].f = {0, 0, 1 << 20, 1 << 20};
    const Material shiny{200, 255, 0};
    const auto level = [&](const UnitVector& light, const UnitVector& viewer) {
        const ShadingSpec spec{64, {false, light, {}}, {false, viewer, {}}};
        return int{BlockShading(world, spec, shiny).shade(4, 9, 0)[0].intensity};
    };
    const UnitVector above{0, 0, 1 << 14}, grazing{-(1 << 14), 0, 1};
    // N.L = 0: no light, though the mirror direction is the viewer's.
    EXPECT_EQ(level({1 << 14, 0, 0}, grazing), 50) << "ambient alone";
    EXPECT_EQ(level({1 << 14, 0, -1}, grazing), 50);
    EXPECT_GT(level({1 << 14, 0, 1}, grazing), 250) << "one step above";
    EXPECT_EQ(level({1 << 14, 0, 0}, above), 50);
    // R.V < 0 is no highlight, for any exponent: an even power would make it one.
    const UnitVector low{11585, 0, 11585};
    for (int shininess = 0; shininess <= 8; ++shininess) {
        const Material m{0, 255, shininess};
        const ShadingSpec spec{0, {false, low, {}}, {false, {16000, 0, 3528}, {}}};
        EXPECT_EQ(BlockShading(world, spec, m).shade(0, 0, 0)[0].intensity, 0) << shininess;
    }
    // N.V = 0 is seen from the front: nothing is turned.
    EXPECT_EQ(level(above, {1 << 14, 0, 0}), 200);
    EXPECT_EQ(level(above, {1 << 14, 0, -1}), 50);
}

// R.V may come out above 1 by rounding; it is clamped, so no level is above the material's.
TEST(Shading, AHighlightIsNoBrighterThanTheMaterials) {
    Random random;
    int full = 0;
    for (int n = 0; n < effort(30000); ++n) {
        const auto world = random_world_block(random, 3);
        const UnitVector light = random_unit(random);
        const Material m{0, 200, 8};
        const ShadingSpec spec{0, {false, light, {}}, {false, light, {}}};
        const int level = BlockShading(world, spec, m).shade(7, 8, 0)[0].intensity;
        ASSERT_LE(level, 200);
        full += level == 200 ? 1 : 0;
    }
    std::cout << "[ measured ] " << full << " full highlights\n";
}

TEST(UnitVector, IsRoundedHalfUpAndZeroForZero) {
    Random random;
    EXPECT_EQ(unit_vector({0, 0, 0}), (UnitVector{0, 0, 0}));
    for (int n = 0; n < effort(50000); ++n) {
        const std::int64_t size = std::int64_t{1} << random.between(0, 61);
        const WideVector v{random.between(-size, size), random.between(-size, size),
                           random.between(-size, size) / (n % 3 == 0 ? size : 1)};
        const ExactVector e = exact_unit14({v[0], v[1], v[2]});
        const UnitVector u = unit_vector(v);
        ASSERT_TRUE(u[0] == e[0] && u[1] == e[1] && u[2] == e[2]) << "case " << n;
    }
}

}  // namespace
}  // namespace umbra78::raster
