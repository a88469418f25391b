// Depth formats in integers against the host's floats, and the experiment against the bound.
#include "tools/bias/trial.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <random>

namespace umbra78::tools::bias {
namespace {

TEST(DepthFormats, FloatsAreTheHosts) {
    std::mt19937_64 random(78);
    for (int k = 0; k < 200000; ++k) {
        const std::int64_t depth = static_cast<std::int64_t>(random() >> 15) >> (random() % 48);
        if (depth > far_depth) continue;
        const auto host = static_cast<float>(std::ldexp(static_cast<double>(depth), -48));
        ASSERT_EQ(encode(DepthFormat::d32f, depth), std::bit_cast<std::uint32_t>(host)) << depth;
    }
    EXPECT_EQ(encode(DepthFormat::d32f, far_depth), 0x3f800000u);
    EXPECT_EQ(encode(DepthFormat::d32f, 0), 0u);
    // A tie goes to the even mantissa, and a carry into the exponent.
    const std::int64_t half = far_depth / 2, last = std::int64_t{1} << 24;  // 2^-24 of 1/2 .. 1
    EXPECT_EQ(encode(DepthFormat::d32f, half + last / 2), 0x3f000000u);
    EXPECT_EQ(encode(DepthFormat::d32f, half + last + last / 2), 0x3f000002u);
    EXPECT_EQ(encode(DepthFormat::d32f, far_depth - 1), 0x3f800000u);
}

TEST(DepthFormats, UnormsAreTheirFormula) {
    std::mt19937_64 random(78);
    for (const DepthFormat format : {DepthFormat::d16, DepthFormat::d24}) {
        const double max = std::ldexp(1, unorm_bits(format)) - 1;
        for (int k = 0; k < 200000; ++k) {
            const auto depth = static_cast<std::int64_t>(random() >> 16);
            const long double exact = std::ldexp(static_cast<long double>(depth), -48) * max;
            ASSERT_EQ(encode(format, depth), static_cast<std::uint32_t>(std::floor(exact + 0.5L)));
        }
        EXPECT_EQ(encode(format, far_depth), static_cast<std::uint32_t>(max));
        EXPECT_EQ(encode(format, far_depth + 5), static_cast<std::uint32_t>(max));
        EXPECT_EQ(encode(format, -5), 0u);
    }
}

TEST(DepthFormats, UnitsOfAConstantAreTheSpecifications) {
    EXPECT_EQ(bias_unit(DepthFormat::d24, far_depth), (far_depth + 8388607) / 16777215);
    EXPECT_EQ(bias_unit(DepthFormat::d32f, far_depth), far_depth >> 23);            // e = 0
    EXPECT_EQ(bias_unit(DepthFormat::d32f, far_depth - 1), far_depth >> 24);        // e = -1
    EXPECT_EQ(bias_unit(DepthFormat::d32f, far_depth * 3 / 8), far_depth >> 25);    // e = -2
}

MapSetup setup_of(DepthFormat format, Filter filter, double slope, double azimuth, bool reversed) {
    MapSetup s;
    s.extent = 20;
    s.range = 50;
    s.format = format;
    s.filter = filter;
    s.slope_deg = slope;
    s.azimuth_deg = azimuth;
    s.reversed = reversed;
    return s;
}

// No more than the bound, and nearly as much, since places at a texel's very border are tried.
TEST(BiasTrial, FindsTheBound) {
    for (const DepthFormat format : {DepthFormat::d16, DepthFormat::d24, DepthFormat::d32f})
        for (const Filter filter : {Filter::nearest, Filter::bilinear, Filter::pcf3, Filter::pcf5})
            for (const double azimuth : {0.0, 45.0})
                for (const bool reversed : {false, true}) {
                    const MapSetup s = setup_of(format, filter, 60, azimuth, reversed);
                    const Need need = need_of(s);
                    const Found found = experiment(s);
                    ASSERT_TRUE(found.constant && found.slope && found.normal);
                    const double steps = need.constant() / need.step;
                    EXPECT_LE(*found.constant, steps + 1);
                    EXPECT_GE(*found.constant, 0.95 * need.geometry / need.step - 1);
                    EXPECT_LE(*found.slope, need.slope_max + 1.0 / 64);
                    EXPECT_GE(*found.slope, 0.9 * need.slope_max - 2 * need.step / need.geometry);
                    const double normal = need.normal / s.texel();
                    EXPECT_LE(*found.normal, normal + 1.0 / 64);
                    EXPECT_GE(*found.normal, 0.9 * normal - 0.1);
                }
}

TEST(BiasTrial, OfASurfaceThatFacesTheLightNeedsNothing) {
    const Found found = experiment(setup_of(DepthFormat::d16, Filter::pcf5, 0, 45, false));
    EXPECT_EQ(found.constant, 0);
    EXPECT_EQ(found.slope, 0.0);
    EXPECT_EQ(found.normal, 0.0);
}

}  // namespace
}  // namespace umbra78::tools::bias
