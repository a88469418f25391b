// Bias in the units of interfaces and engines: the worked example, and each formula put forwards,
// as its specification has it.
#include "tools/bias/units.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace umbra78::tools::bias {
namespace {

// 2048 texels over 20 m, 50 m of depth, 1.5 texels of reach, 60 degrees along an axis of the map.
MapSetup worked_example(DepthFormat format = DepthFormat::d16) {
    MapSetup s;
    s.extent = 20;
    s.range = 50;
    s.format = format;
    s.filter = Filter::pcf3;
    s.slope_deg = 60;
    s.azimuth_deg = 0;
    return s;
}

double converted(const MapSetup& s, std::string_view target, std::string_view name) {
    const Amount amount = amount_of(s, need_of(s).geometry);
    for (const Converted& c : convert(amount, amount))
        if (c.parameter->target == target && c.parameter->name == name)
            return c.value.value_or(std::nan(""));
    ADD_FAILURE() << "no row " << target << ", " << name;
    return 0;
}

TEST(BiasUnits, AreThoseOfTheWorkedExample) {
    const MapSetup s = worked_example();
    const Need need = need_of(s);
    EXPECT_NEAR(s.texel(), 9.765625e-3, 1e-15);
    EXPECT_NEAR(need.geometry, 25.3718e-3, 5e-8);
    EXPECT_NEAR(amount_of(s, need.geometry).depth(), 5.07437e-4, 5e-10);
    EXPECT_NEAR(need.normal, 12.6859e-3, 5e-8);
    EXPECT_NEAR(need.step, 0.763e-3, 5e-7);
    EXPECT_NEAR(need.slope_euclidean, 1.5, 1e-12);
    EXPECT_NEAR(need.slope_max, 1.5, 1e-12);
    const struct {
        const char *target, *name;
        double value, within;
    } rows[] = {
        {"Direct3D", "DepthBias", 34, 0},
        {"Direct3D", "SlopeScaledDepthBias", 1.5, 1e-9},
        {"WebGPU", "depthBias", 34, 0},
        {"Vulkan", "depthBiasConstantFactor", 33.2554, 5e-5},
        {"Vulkan", "depthBiasSlopeFactor", 1.5, 1e-9},
        {"OpenGL", "glPolygonOffset units", 33.26, 5e-3},
        {"Metal", "setDepthBias depthBias", 33.2549, 5e-5},
        {"three.js", "shadow.bias", -0.000507437, 5e-10},
        {"three.js", "shadow.normalBias", 0.0126859, 5e-8},
        {"Babylon.js", "bias, PCF and PCSS", 0.00101487, 5e-9},
        {"Babylon.js", "bias, other filters", 0.000507437, 5e-10},
        {"Babylon.js", "bias, cascades with PCF and depthClamp", 0.000338291, 5e-10},
        {"Babylon.js", "normalBias", 0.0146484, 5e-8},
        {"Godot 4", "shadow_bias", 0.0507437, 5e-8},
        {"Godot 4", "shadow_normal_bias", 1.73205, 5e-6},
        {"Unity HDRP", "slope-scale depth bias", 0.3, 1e-9},
        {"Unity HDRP", "normal bias", 1.29904, 5e-6},
        {"Unity built-in", "bias", 0.0253718, 5e-8},
        {"Unity built-in", "normal bias", 1.5, 1e-9},
        {"Unreal", "ShadowBias, with SlopeBias 0.5", 0.207846, 5e-7},
        {"bevy", "shadow_depth_bias", 0.0253718, 5e-8},
        {"bevy", "shadow_normal_bias", 0.918559, 5e-7},
        {"Filament", "constantBias", 0.0253718, 5e-8},
        {"Filament", "normalBias", 2.99707, 5e-6},
        {"Filament", "polygonOffsetSlope", 1.5, 1e-9},
    };
    for (const auto& row : rows)
        EXPECT_NEAR(converted(s, row.target, row.name), row.value, row.within)
            << row.target << ", " << row.name;
    MapSetup hard = s;  // as URP scales it: 1 for a hard shadow, 2.5 for a soft one of medium width
    Amount amount = amount_of(hard, need_of(s).geometry);
    const auto urp = [&](double taps, Kind kind) {
        amount.taps = taps;
        for (const Converted& c : convert(amount, amount))
            if (c.parameter->target == "Unity URP" && c.parameter->kind == kind) return *c.value;
        return 0.0;
    };
    EXPECT_NEAR(urp(1, Kind::constant), 2.59808, 5e-6);
    EXPECT_NEAR(urp(5, Kind::constant), 1.03923, 5e-6);
    EXPECT_NEAR(urp(1, Kind::normal), 2.59808, 5e-6);
    EXPECT_NEAR(urp(5, Kind::normal), 1.03923, 5e-6);
}

TEST(BiasUnits, OfTheOtherDepthFormats) {
    EXPECT_EQ(converted(worked_example(DepthFormat::d24), "Direct3D", "DepthBias"), 8514);
    MapSetup real = worked_example(DepthFormat::d32f);
    real.depth = 0.75;
    EXPECT_EQ(converted(real, "Direct3D", "DepthBias"), 8514);
    real.depth = 0.3;
    EXPECT_EQ(converted(real, "Direct3D", "DepthBias"), 17027);
    EXPECT_NEAR(converted(real, "Vulkan", "depthBiasConstantFactor, FLOAT"), 5.07437e-4, 5e-10);
    EXPECT_NEAR(converted(real, "Vulkan", "depthBiasConstantFactor, FORCE_UNORM"),
                5.07437e-4 * 16777216, 5e-2);
    MapSetup reversed = worked_example();
    reversed.reversed = true;
    EXPECT_EQ(converted(reversed, "Direct3D", "DepthBias"), -34);
    EXPECT_NEAR(converted(reversed, "Direct3D", "SlopeScaledDepthBias"), -1.5, 1e-9);
    EXPECT_GT(converted(reversed, "Filament", "polygonOffsetSlope"), 0) << "it turns by itself";
    EXPECT_LT(converted(reversed, "three.js", "shadow.bias"), 0);
}

TEST(BiasUnits, OfAllAzimuths) {
    MapSetup s = worked_example();
    s.azimuth_deg = 45;
    EXPECT_NEAR(need_of(s).slope_euclidean, 2.1213, 5e-5);
    EXPECT_NEAR(need_of(s).slope_max, 3, 1e-9);
    for (int azimuth = 0; azimuth <= 90; ++azimuth) {
        MapSetup other = s;
        other.azimuth_deg = azimuth;
        EXPECT_LE(need_of(other).geometry, need_of(s).geometry * (1 + 1e-12));
        EXPECT_LE(need_of(other).slope_max, 3 + 1e-9);
    }
}

// bias = constant r + slope m, in window depth: the raster stages' formula, put forwards.
TEST(BiasUnits, RasterFormulasGiveTheBiasBack) {
    for (const DepthFormat format : {DepthFormat::d16, DepthFormat::d24, DepthFormat::d32f})
        for (const double azimuth : {0.0, 30.0, 45.0})
            for (const bool reversed : {false, true}) {
                MapSetup s = worked_example(format);
                s.azimuth_deg = azimuth;
                s.reversed = reversed;
                const double d = need_of(s).geometry / s.range;
                const int n = format == DepthFormat::d16 ? 16 : 24;
                const double z = reversed ? 1 - s.depth : s.depth;
                const bool real = format == DepthFormat::d32f;
                const double r_float = std::exp2(std::floor(std::log2(z)) - 23);
                const double r_d3d = real ? r_float : 1 / (std::exp2(n) - 1);
                const double r_vulkan = real ? r_float : std::exp2(-n);
                const double sign = reversed ? -1 : 1;
                const double zx = std::tan(M_PI / 3) * std::cos(azimuth * M_PI / 180);
                const double zy = std::tan(M_PI / 3) * std::sin(azimuth * M_PI / 180);
                const double texel = s.extent / s.map_px / s.range;
                const double m_max = std::max(zx, zy) * texel, m_2 = std::hypot(zx, zy) * texel;
                const auto gives = [&](const char* target, const char* name, double unit) {
                    return sign * converted(s, target, name) * unit;
                };
                const double whole = gives("Direct3D", "DepthBias", r_d3d);
                EXPECT_GE(whole, d * (1 - 1e-12));
                EXPECT_LT(whole, d + r_d3d);
                EXPECT_NEAR(gives("Vulkan", "depthBiasConstantFactor", r_vulkan), d, 1e-12);
                EXPECT_NEAR(gives("OpenGL", "glPolygonOffset units", r_vulkan), d, 1e-12);
                EXPECT_NEAR(gives("Metal", "setDepthBias depthBias", r_d3d), d, 1e-12);
                EXPECT_NEAR(gives("Direct3D", "SlopeScaledDepthBias", m_max), d, 1e-12);
                EXPECT_NEAR(gives("Vulkan", "depthBiasSlopeFactor", m_2), d, 1e-12);
            }
}

// What a shader or an engine does with its parameter, put forwards: the same bias along the light.
TEST(BiasUnits, EnginesFormulasGiveTheBiasBack) {
    const MapSetup s = worked_example();
    const double b = need_of(s).geometry, t = s.texel(), R = s.range;
    const double angle = M_PI / 3, sine = std::sin(angle), cosine = std::cos(angle);
    const auto value = [&](const char* target, const char* name) {
        return converted(s, target, name);
    };
    // A move by n along the normal is worth n / cos along the light.
    EXPECT_NEAR(value("three.js", "shadow.normalBias") / cosine, b, 1e-12);
    EXPECT_NEAR(value("Babylon.js", "normalBias") * sine / cosine, b, 1e-12);
    // A move sideways by g lowers the map's plane by g tan.
    EXPECT_NEAR(value("Godot 4", "shadow_normal_bias") * t * sine * std::tan(angle), b, 1e-12);
    EXPECT_NEAR(value("Godot 4", "shadow_bias") / 100 * R, b, 1e-12);
    EXPECT_NEAR(value("Unity HDRP", "normal bias") * t / cosine, b, 1e-12);
    EXPECT_NEAR(value("Unity built-in", "normal bias") * t * sine / cosine, b, 1e-12);
    EXPECT_NEAR(value("bevy", "shadow_normal_bias") * std::sqrt(2) * t / cosine, b, 1e-12);
    EXPECT_NEAR(value("Filament", "normalBias") * 0.5 * (20.0 / 2046) * sine / cosine, b, 1e-12);
    EXPECT_NEAR(value("Unity URP", "normal bias") * t * 1.5 * (1 - cosine) / cosine, b, 1e-12);
    EXPECT_NEAR(value("Unreal", "ShadowBias, with SlopeBias 0.5") * 10 * (10.0 / 2048) *
                    (1 + 3 * 0.5 * 1), b, 1e-12);
}

TEST(BiasUnits, OfASurfaceThatFacesTheLight) {
    MapSetup s = worked_example();
    s.slope_deg = 0;
    const Amount step = amount_of(s, need_of(s).constant());
    const Amount none = amount_of(s, need_of(s).geometry);
    for (const Converted& c : convert(step, none)) {
        if (c.parameter->kind == Kind::constant)
            EXPECT_TRUE(c.value && *c.value != 0) << c.parameter->target;
        else
            EXPECT_TRUE(!c.value || *c.value == 0) << c.parameter->target;
    }
}

}  // namespace
}  // namespace umbra78::tools::bias
