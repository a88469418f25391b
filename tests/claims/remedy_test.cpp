// What figures 3, 4 and 5 are wrong by, against exact truth; the bias in its three units; and what
// the widths of Z and of X and Y have to do with it.
#include "tests/claims/ground.hpp"

#include "shadow/bias.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

namespace umbra78::claims {
namespace {

using shadow::BiasUnit;
using shadow::figure_settings;
using shadow::Lookup;

void print(const char* what, const ShadowError& e) {
    std::printf("%-40s false shadow %.5f (%d of %d lit), false light %.5f (%d of %d shadowed)\n",
                what, e.false_shadow_rate(), e.false_shadow, e.lit, e.false_light_rate(),
                e.false_light, e.shadowed);
}

TEST(Bias, OfFigures3And4InThreeUnits) {
    const auto units = shadow::bias_units(
        shadow::figure_view(shadow::figure_azimuth_q16), hw::MachineSpec{});
    for (const int figure : {3, 4}) {
        std::int64_t quanta_q16 = 0;
        const auto s = figure_settings(figure);
        ASSERT_TRUE(shadow::bias_in_quanta(s.bias_q16, s.bias_unit, units, quanta_q16));
        const hw::Rational quanta = hw::Rational(quanta_q16, 65536);
        const hw::Rational world = quanta / units.quanta_per_world;
        const hw::Rational texels = world * units.texels_per_world;
        std::int64_t texels_q16 = 0, world_q16 = 0;
        ASSERT_TRUE(texels.round_scaled(16, fixed::Rounding::half_even, texels_q16));
        ASSERT_TRUE(world.round_scaled(16, fixed::Rounding::half_even, world_q16));
        std::printf("figure %d's bias: %.4g quanta, %.4g texels, %.8g world units\n", figure,
                    q16(quanta_q16), q16(texels_q16), q16(world_q16));
        EXPECT_EQ(quanta, hw::Rational(figure == 3 ? 64 : 192));
        EXPECT_EQ(texels, hw::Rational(figure == 3 ? 1 : 3, 2));
        EXPECT_EQ(world, hw::Rational(figure == 3 ? 1 : 3, 256));
    }
}

TEST(Figure4, IsWithinItsBounds) {
    const Machine machine(figure_settings(4));
    const Ground& g = ground();
    const ShadowError all = shadow_error(g.truth, machine.compared());
    const auto band = g.band(0);
    const ShadowError outside = shadow_error(g.truth, machine.compared(), band);
    print("figure 4", all);
    print("figure 4, outside the light texel's band", outside);
    EXPECT_LT(all.false_shadow_rate(), 0.01);
    EXPECT_LT(all.false_light_rate(), 0.08);
    EXPECT_LT(outside.false_shadow_rate(), 0.005);
    EXPECT_LT(outside.false_light_rate(), 0.005);
    // The band leaves enough to judge by.
    EXPECT_GT(outside.lit, 3 * all.lit / 4);
    EXPECT_GT(outside.shadowed, 3 * all.shadowed / 4);

    const ShadowError three = shadow_error(g.truth, Machine(figure_settings(3)).compared());
    print("figure 3", three);
    EXPECT_GT(three.false_shadow_rate(), 20 * all.false_shadow_rate());
    EXPECT_LT(three.false_light_rate(), all.false_light_rate()) << "what the remedy costs";
}

// Figure 5 is a mask of 256 levels; from 128 on it counts as shadow.
TEST(Figure5, HasItsRatesAtItsThreshold) {
    const Machine machine(figure_settings(5));
    const Ground& g = ground();
    const tools::MachineMask edges{machine.buffers().lights[0].edges, machine.visible};
    const ShadowError four = shadow_error(g.truth, machine.compared());
    const ShadowError dequantized = shadow_error(g.truth, edges);
    const ShadowError five = shadow_error(g.truth, machine.filtered());
    const ShadowError outside = shadow_error(g.truth, machine.filtered(), g.band(2));
    print("figure 4's mask", four);
    print("edges dequantized, threshold 128", dequantized);
    print("figure 5, threshold 128", five);
    print("figure 5, outside the band of 2 px more", outside);
    for (const int threshold : {64, 192})
        print(threshold == 64 ? "figure 5, threshold 64" : "figure 5, threshold 192",
              shadow_error(g.truth, machine.filtered(threshold)));
    EXPECT_LT(five.false_shadow_rate(), 0.004);
    EXPECT_LT(five.false_light_rate(), 0.08);
    EXPECT_LT(five.false_shadow, four.false_shadow) << "isolated pixels are filtered away";
    EXPECT_EQ(outside.false_shadow + outside.false_light, 0);
    const int before = isolated_pixels(machine.compared(), 512);
    const int after = isolated_pixels(machine.filtered(), 512);
    std::printf("isolated pixels: %d in figure 4, %d in figure 5\n", before, after);
    EXPECT_LT(10 * after, before);
}

// The same bias in world units everywhere; truth is traced at the machine's resolution.
ShadowError at_widths(int xy_bits, int z_bits, Lookup lookup) {
    Settings s = figure_settings(3);
    s.machine.xy_bits = xy_bits;
    s.machine.z_bits = z_bits;
    s.lookup = lookup;
    s.bias_unit = BiasUnit::world;
    s.bias_q16 = 65536 / 256;
    const Ground g(-100, 1 << xy_bits);
    const ShadowError e = shadow_error(g.truth, Machine(s).compared());
    char what[64];
    std::snprintf(what, sizeof what, "%s, X and Y %d bits, Z %d bits", name(lookup), xy_bits,
                  z_bits);
    print(what, e);
    return e;
}

TEST(Widths, FourBitsOfZAreWorthLessThanOneOfXAndY) {
    for (const Lookup lookup : {Lookup::nearest, Lookup::bilinear}) {
        const double full = at_widths(9, 16, lookup).false_shadow_rate();
        const double z14 = at_widths(9, 14, lookup).false_shadow_rate();
        const double z12 = at_widths(9, 12, lookup).false_shadow_rate();
        const double xy8 = at_widths(8, 16, lookup).false_shadow_rate();
        const double by_z = std::abs(z12 - full), by_xy = std::abs(xy8 - full);
        std::printf("%s: Z from 16 to 12 bits changes the rate by %.4f, X and Y from 9 to 8 by "
                    "%.4f\n",
                    name(lookup), by_z, by_xy);
        EXPECT_LT(by_z, by_xy) << name(lookup);
        EXPECT_LT(std::abs(z14 - full), by_z) << name(lookup);
        // Nine bits of X and Y are the problem of figure 3; interpolated, both errors are small.
        if (lookup == Lookup::nearest) {
            EXPECT_LT(4 * by_z, by_xy);
        }
    }
}

// Figure 3's settings but for the lookup.
TEST(Widths, AnAccumulatorOf22BitsIsEnough) {
    const Ground ground;
    for (const Lookup lookup : {Lookup::nearest, Lookup::bilinear}) {
        const auto with_bits = [&](int bits) {
            Settings s = figure_settings(3);
            s.lookup = lookup;
            s.machine.max_accumulator_bits = bits;
            return shadow_error(ground.truth, Machine(s).compared());
        };
        const ShadowError exact = with_bits(35), enough = with_bits(22), little = with_bits(16);
        std::printf("%s: false shadow %.4f and false light %.4f with 35 bits, %.4f and %.4f with "
                    "22, %.4f and %.4f with 16\n", name(lookup), exact.false_shadow_rate(),
                    exact.false_light_rate(), enough.false_shadow_rate(),
                    enough.false_light_rate(), little.false_shadow_rate(),
                    little.false_light_rate());
        EXPECT_LT(std::abs(enough.false_shadow_rate() - exact.false_shadow_rate()), 0.001);
        EXPECT_LT(std::abs(enough.false_light_rate() - exact.false_light_rate()), 0.001);
        EXPECT_GT(little.false_shadow_rate() - exact.false_shadow_rate(), 0.01);
    }
}

}  // namespace
}  // namespace umbra78::claims
