// The bias in its three units, and that it arrives in the matrix as many quanta as it says.
#include "shadow/bias.hpp"

#include "shadow/frame/frame.hpp"
#include "shadow/frame/paper_figures.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace umbra78::shadow {
namespace {

constexpr std::int64_t one_q16 = 1 << 16;

std::int64_t in_quanta(BiasUnit unit, std::int64_t bias_q16, const BiasUnits& units) {
    std::int64_t out = -1;
    EXPECT_TRUE(bias_in_quanta(bias_q16, unit, units, out));
    return out;
}

// The cube of 4 world units a side: 512 pixels and 65536 quanta across.
TEST(Bias, OfTheFiguresInThreeUnits) {
    const BiasUnits u = bias_units(figure_view(figure_azimuth_q16), hw::MachineSpec{});
    EXPECT_EQ(u.quanta_per_world, hw::Rational(16384));
    EXPECT_EQ(u.texels_per_world, hw::Rational(128));
    struct Row {
        int figure;
        std::int64_t quanta_q16, texels_q16, world_q16;
    };
    for (const Row& r : {Row{3, 64 * one_q16, one_q16 / 2, one_q16 / 256},
                         Row{4, 192 * one_q16, 3 * one_q16 / 2, 3 * one_q16 / 256}}) {
        EXPECT_EQ(figure_settings(r.figure).bias_q16, r.quanta_q16);
        EXPECT_EQ(figure_settings(r.figure).bias_unit, BiasUnit::quanta);
        EXPECT_EQ(in_quanta(BiasUnit::quanta, r.quanta_q16, u), r.quanta_q16);
        EXPECT_EQ(in_quanta(BiasUnit::texels, r.texels_q16, u), r.quanta_q16);
        EXPECT_EQ(in_quanta(BiasUnit::world, r.world_q16, u), r.quanta_q16);
    }
}

// quanta = texels q / t = world q, for every width; one texel is 2^(z - xy) quanta in a cube.
TEST(Bias, UnitsFollowTheWidths) {
    hw::MachineSpec spec;
    for (spec.xy_bits = 4; spec.xy_bits <= 12; ++spec.xy_bits) {
        for (spec.z_bits = 4; spec.z_bits <= 24; ++spec.z_bits) {
            const BiasUnits u = bias_units(figure_view(figure_azimuth_q16), spec);
            EXPECT_EQ(u.quanta_per_world, hw::Rational(std::int64_t{1} << spec.z_bits, 4));
            EXPECT_EQ(u.texels_per_world, hw::Rational(std::int64_t{1} << spec.xy_bits, 4));
            const std::int64_t texel = in_quanta(BiasUnit::texels, 16 * one_q16, u);
            EXPECT_EQ(hw::Rational(texel, 16 * one_q16),
                      u.quanta_per_world / u.texels_per_world);
            EXPECT_EQ(in_quanta(BiasUnit::world, -4 * one_q16, u),
                      -(one_q16 << spec.z_bits));
        }
    }
}

TEST(Bias, RoundsHalfEvenToTheLastBit) {
    raster::View light = figure_view(0);
    hw::MachineSpec spec;
    spec.z_bits = 4;
    light.near_depth = -16 * one_q16;  // 16 quanta over 32 units: a half a unit
    light.far_depth = 16 * one_q16;
    const BiasUnits u = bias_units(light, spec);
    ASSERT_EQ(u.quanta_per_world, hw::Rational(1, 2));
    constexpr std::array<std::int64_t, 15> expected{-4, -3, -2, -2, -2, -1, 0, 0,
                                                    0,  1,  2,  2,  2,  3,  4};
    for (int w = -7; w <= 7; ++w)
        EXPECT_EQ(in_quanta(BiasUnit::world, w, u), expected[static_cast<std::size_t>(w + 7)])
            << w;
}

TEST(Bias, ThatDoesNotFitIsSaid) {
    raster::View light = figure_view(0);
    light.near_depth = 0;
    light.far_depth = 1;  // 2^-16 unit: 2^40 quanta a unit
    hw::MachineSpec spec;
    spec.z_bits = 24;
    const BiasUnits u = bias_units(light, spec);
    constexpr std::int64_t beyond = std::int64_t{1} << 23;
    std::int64_t out = 0;
    EXPECT_TRUE(bias_in_quanta(beyond - 1, BiasUnit::world, u, out));
    EXPECT_EQ(out, (beyond - 1) << 40);
    EXPECT_FALSE(bias_in_quanta(beyond, BiasUnit::world, u, out));
    EXPECT_TRUE(bias_in_quanta(-beyond, BiasUnit::world, u, out));
    EXPECT_EQ(out, INT64_MIN);
}

// A perspective light: q is the slope of Z's code over depth at the target, by definition and by
// the difference quotient, both in double precision.
TEST(Bias, OfAPointLightIsTheSlopeAtTheTarget) {
    raster::View light = figure_view(figure_azimuth_q16);
    light.projection = raster::Projection::perspective;
    struct Place {
        double distance, near, far;
    };
    for (const Place& p : {Place{10, 8, 13}, Place{3, 0.5, 40}, Place{100.25, 1, 1000}}) {
        light.distance = static_cast<std::int32_t>(p.distance * one_q16);
        light.near_depth = static_cast<std::int64_t>(p.near * one_q16);
        light.far_depth = static_cast<std::int64_t>(p.far * one_q16);
        for (const int z_bits : {12, 16, 24}) {
            hw::MachineSpec spec;
            spec.z_bits = z_bits;
            const BiasUnits u = bias_units(light, spec);
            const double codes = std::ldexp(1, z_bits);
            const auto code = [&](double d) {
                return codes * p.far * (d - p.near) / ((p.far - p.near) * d);
            };
            const double step = p.distance * 1e-5;
            const double slope = (code(p.distance + step) - code(p.distance - step)) / (2 * step);
            const double formula =
                codes * p.far * p.near / ((p.far - p.near) * p.distance * p.distance);
            EXPECT_NEAR(slope / formula, 1, 1e-7);
            const double world = std::ldexp(
                static_cast<double>(in_quanta(BiasUnit::world, one_q16, u)), -16);
            EXPECT_NEAR(world, formula, std::ldexp(1, -17) * (1 + 1e-9));
            const double texel = std::ldexp(
                static_cast<double>(in_quanta(BiasUnit::texels, one_q16, u)), -16);
            EXPECT_NEAR(texel, formula * 2 / 256, std::ldexp(1, -17) * (1 + 1e-9));
        }
    }
}

// What a lamp's quantum and texel are at a depth follows from two numbers: 2^z_bits far / (far -
// near) less the middle code and the bias, and half_px distance / extent, both Q.8.
TEST(Bias, ScaleOfAPointLightIsThatOfItsDepths) {
    raster::View lamp;
    lamp.projection = raster::Projection::perspective;
    lamp.extent = 2 << 16;
    lamp.distance = 5 << 16;
    lamp.near_depth = 1 << 16;
    lamp.far_depth = 3 << 16;
    const LightScale scale = light_scale(lamp, hw::MachineSpec{}, std::int64_t{64} << 16);
    EXPECT_EQ(scale.reach_q8, (65536 * 3 / 2 - 32768 - 64) * 256);
    EXPECT_EQ(scale.focal_q8, 256 * 5 / 2 * 256);
}

// The bias is the matrix's: with and without it, every point's Z differs by just that.
TEST(Bias, LivesInTheMatrix) {
    const hw::MachineSpec spec;
    const raster::View observer = figure_view(0), light = figure_view(figure_azimuth_q16);
    const auto unit = [&](std::int64_t quanta) {
        hw::MatrixWords m;
        EXPECT_EQ(hw::load_matrix(raster::observer_to_light(observer, light, spec, quanta << 16),
                                  spec, hw::screen_words(spec), m),
                  hw::LoadStatus::ok);
        return hw::TransformUnit(spec, m);
    };
    const hw::TransformUnit plain = unit(0);
    for (const int quanta : {1, 2, 63, 64, 192, 256, 1000, -1, -64, 16384}) {
        const hw::TransformUnit biased = unit(quanta);
        for (int x = -32768; x <= 32767; x += 4369)
            for (int z = -32768; z <= 32767; z += 3641) {
                const hw::Point a = plain({x, -x, z}), b = biased({x, -x, z});
                EXPECT_EQ(a.z - b.z, quanta) << x << " " << z;
                EXPECT_EQ(a.x, b.x);
                EXPECT_EQ(a.y, b.y);
            }
    }
}

}  // namespace
}  // namespace umbra78::shadow
