// Shading against its formula in double precision: Lambert's cosine, Phong's highlight, two sides,
// the poles of a sphere, light from a point.
#include "tests/raster/truth.hpp"
#include "tests/support/effort.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace umbra78::raster {
namespace {

using namespace test;
using umbra78::test::orthographic;
using umbra78::test::Patches;
using umbra78::test::perspective;
using umbra78::test::plane;
using umbra78::test::q16;
using umbra78::test::Drawing;

double level_of(const Material& m, double ambient, double nl, double nv, double lv) {
    if (nv < 0) {
        nl = -nl;
        nv = -nv;
    }
    double level = m.diffuse[0] * (ambient + (1 - ambient) * std::max(0.0, nl));
    if (nl > 0)
        level += m.specular[0] * std::pow(std::clamp(2 * nl * nv - lv, 0.0, 1.0), 1 << m.shininess);
    return std::min(level, 255.0);
}

double level_of(const Material& m, double ambient, const Vector3& n, const Vector3& l,
                const Vector3& v) {
    return level_of(m, ambient, dot3(n, l), dot3(n, v), dot3(l, v));
}

// One flat block with the tangents u and v, in object words of 14 bits and 6 guard bits.
std::array<Component, 3> flat(const Vector3& u, const Vector3& v) {
    std::array<Component, 3> world{};
    const auto word = [](double d) { return std::int64_t{std::lround(d * (1 << 20))}; };
    for (std::size_t k = 0; k < 3; ++k) {
        world[k].f = {0, word(u[k]), word(v[k]), word(u[k] + v[k])};
    }
    return world;
}

UnitVector q14(const Vector3& v) {
    UnitVector u{};
    for (std::size_t k = 0; k < 3; ++k)
        u[k] = static_cast<std::int32_t>(std::lround(v[k] * (1 << 14)));
    return u;
}

TEST(Shading, IsLambertsCosineOnBothSides) {
    const Material matt{200, 0, 0};
    for (int degrees = 0; degrees < 360; degrees += 5) {
        const double angle = degrees * 3.14159265358979 / 180;
        const Vector3 u{std::cos(angle), std::sin(angle), 0}, v{0, 0, 1};
        const Vector3 normal{std::sin(angle), -std::cos(angle), 0};  // u x v
        const Vector3 light = unit3({0.6, 0.7, 0.2}), viewer = unit3({0.5, 0.1, -1});
        const ShadingSpec spec{77, {false, q14(light), {}}, {false, q14(viewer), {}}};
        const double expected = level_of(matt, 77 / 256.0, normal, light, viewer);
        const int front = BlockShading(flat(u, v), spec, matt).shade(3, 9, 0)[0].intensity;
        EXPECT_NEAR(front, expected, 0.6) << degrees;
        EXPECT_EQ(BlockShading(flat(v, u), spec, matt).shade(3, 9, 0)[0].intensity, front)
            << "turned over, " << degrees << " degrees";
        EXPECT_EQ(BlockShading(flat(u, v), spec, matt).shade(3, 9, 1)[0].intensity,
                  (200 * 77 + 128) / 256)
            << "in shadow: ambient alone";
    }
}

// A flat block whose control points stand in its corners: all four tangents are 0, and the chords
// give the normal that evenly spaced points give.
TEST(Shading, OfCoincidentControlPointsIsTheFlatBlocks) {
    const Vector3 u{0.5, 0.125, 0.25}, v{-0.25, 0.5, 0.125};
    const std::array<Component, 3> even = flat(u, v);
    std::array<Component, 3> doubled = even;
    for (std::size_t k = 0; k < 3; ++k) {
        Component& c = doubled[k];
        const std::int64_t gu = 3 * (c.f[1] - c.f[0]) / 4, gv = 3 * (c.f[2] - c.f[0]) / 4;
        c.gu = {gu, -gu, gu, -gu};
        c.gv = {gv, gv, -gv, -gv};
    }
    const Material matt{200, 0, 0};
    const ShadingSpec spec{77, {false, q14(unit3({0.6, -0.7, 0.8})), {}},
                           {false, q14({0, 0, 1}), {}}};
    const BlockShading right(even, spec, matt), shading(doubled, spec, matt);
    EXPECT_GT(right.shade(3, 12, 0)[0].intensity, 70);  // not ambient light alone, which is 60
    for (int leaf = 0; leaf < 256; ++leaf)
        EXPECT_EQ(shading.shade(leaf % 16, leaf / 16, 0)[0].intensity,
                  right.shade(leaf % 16, leaf / 16, 0)[0].intensity) << leaf;
    // One edge a point as well: the opposite edge's chord.
    std::array<Component, 3> tip = doubled;
    for (Component& c : tip) {
        c.f[3] = c.f[2];
        c.gu[2] = c.gu[3] = 0;
        c.gv[1] = 3 * (c.f[3] - c.f[1]) / 4;
        c.gv[3] = -c.gv[1];
    }
    EXPECT_GT(BlockShading(tip, spec, matt).shade(8, 15, 0)[0].intensity, 70);
}

TEST(Shading, TheHighlightIsBrightestInTheMirrorDirection) {
    const Vector3 light = unit3({1, 0, 1}), up{0, 1, 0};
    const ShadingSpec spec{0, {false, q14(light), {}}, {false, q14({-0.70710678, 0, 0.70710678}),
                                                        {}}};
    const Material shiny{0, 255, 4};
    int best = -1, best_degrees = 0;
    for (int degrees = -40; degrees <= 40; ++degrees) {
        const double angle = degrees * 3.14159265358979 / 180;
        const Vector3 normal{std::sin(angle), 0, std::cos(angle)};
        const Vector3 across{std::cos(angle), 0, -std::sin(angle)};
        const int level = BlockShading(flat(across, up), spec, shiny).shade(0, 0, 0)[0].intensity;
        const double expected = level_of(shiny, 0, normal, light, {-0.70710678, 0, 0.70710678});
        EXPECT_NEAR(level, expected, 1.5) << degrees;
        EXPECT_EQ(BlockShading(flat(across, up), spec, shiny).shade(0, 0, 1)[0].intensity, 0);
        if (level > best) {
            best = level;
            best_degrees = degrees;
        }
    }
    EXPECT_EQ(best, 255);
    EXPECT_EQ(best_degrees, 0);
}

// All of a sphere of 92 pixels but its last 3 % next to the limb. A level is its leaf's, taken up
// to half a pixel away, so it may differ by the level's change within the pixel and by 1.
void expect_sphere_levels(double azimuth, double elevation, const Material& material) {
    Drawing<> stage;
    stage.materials = {material};
    stage.ambient_q8 = 90;
    const View view = orthographic(azimuth, elevation, 2);
    const View light = orthographic(azimuth - 50, elevation > 0 ? elevation - 40 : 30, 2);
    Patches patches;
    const Sphere sphere = umbra78::test::sphere(0.1, 0.05, -0.02, 0.72);
    umbra78::test::add_sphere(patches, sphere);
    stage.draw(patches, view, Sampling::centre, &light);
    const Camera camera(view, {});
    const Vector3 l = axis3(light.axes.back);
    const auto truth = [&](double x, double y) {
        const auto at = hit(camera.ray(x, y), sphere);
        if (!at) return -1.0;
        return level_of(material, 90 / 256.0, unit3(along(*at, -1, world3(sphere.centre))), l,
                        camera.back);
    };
    double worst = 0, worst_excess = 0;
    int pixels = 0, worst_x = 0, worst_y = 0;
    for (int py = 0; py < 512; ++py) {
        for (int px = 0; px < 512; ++px) {
            const double x = px - 255.5, y = py - 255.5;
            if (disc_lies(camera, sphere, x, y, 0.03 * 92) != Lies::inside) continue;
            const double expected = truth(x, y);
            double change = 0;
            for (const double dx : {-0.5, 0.5})
                for (const double dy : {-0.5, 0.5})
                    change = std::max(change, std::abs(truth(x + dx, y + dy) - expected));
            const double difference = std::abs(stage.intensity_at(px, py) - expected);
            worst = std::max(worst, difference);
            ++pixels;
            if (difference - change <= worst_excess) continue;
            worst_excess = difference - change;
            worst_x = px;
            worst_y = py;
        }
    }
    EXPECT_GT(pixels, 20000);
    EXPECT_LT(worst_excess, 1) << "at " << worst_x << ", " << worst_y;
    EXPECT_LT(worst, material.specular[0] == 0 ? 2 : 5);
    std::cout << "[ measured ] view " << azimuth << ", " << elevation << ": levels differ by "
              << worst << " at most, by " << worst_excess
              << " beyond the change within the pixel\n";
}

TEST(Shading, OfASphereIsAnalyticAtEveryPixelAndAtThePoles) {
    for (const double elevation : {0.0, 60.0, 90.0, -90.0, -45.0}) {
        if (umbra78::test::sanitized && elevation != 0 && elevation != 90) continue;
        expect_sphere_levels(20, elevation, {215, 0, 0});
        expect_sphere_levels(20, elevation, {165, 90, 5});
    }
}

// A plane under a point light: the direction changes from place to place.
TEST(Shading, APointLightShinesFromItsPlace) {
    Drawing<> stage;
    stage.materials = {{200, 50, 4}};
    stage.ambient_q8 = 26;
    const View view = orthographic(10, 80, 2);
    View light = perspective(40, 50, 1, 1.5, 0.1, 10);  // an eye 1.5 from the target
    light.target = {q16(0.2), 0, q16(-0.3)};
    const Camera camera(view, {}), lamp(light, {});
    Patches patches{plane_patch(plane({-2, 0, -2}, {4, 0, 0}, {0, 0, 4}))};
    stage.draw(patches, view, Sampling::centre, &light);
    double worst = 0;
    int pixels = 0;
    for (int py = 0; py < 512; ++py) {
        for (int px = 0; px < 512; ++px) {
            if (!stage.drawn(px, py)) continue;
            const auto ray = camera.ray(px - 255.5, py - 255.5);
            const Vector3 at = along(ray.origin, -ray.origin[1] / ray.direction[1], ray.direction);
            const Vector3 l = unit3(along(lamp.eye(), -1, at));
            const double expected =
                level_of(stage.materials[0], 26 / 256.0, {0, 1, 0}, l, camera.back);
            worst = std::max(worst, std::abs(stage.intensity_at(px, py) - expected));
            ++pixels;
        }
    }
    EXPECT_GT(pixels, 200000);
    EXPECT_LT(worst, 2.5);
    std::cout << "[ measured ] point light: levels differ by at most " << worst << '\n';
}

// Blinn's highlight has Phong's size where light and viewer stand near the normal, and both are
// gone half a right angle away; without a rule every sample has the material's level.
TEST(ShadingRules, HaveHighlightsOfOneSize) {
    const Material glossy{100, 100, 5};
    const auto level = [&](ShadingRule rule, double degrees) {
        const double angle = degrees * 3.14159265358979 / 180;
        const Vector3 light{std::sin(angle), 0, std::cos(angle)};
        ShadingSpec spec{0, {false, q14(light), {}}, {false, q14({0, 0, 1}), {}}};
        spec.rule = rule;
        return int{BlockShading(flat({1, 0, 0}, {0, 1, 0}), spec, glossy)
                       .shade(7, 7, 0)[0].intensity};
    };
    for (const double degrees : {0.0, 3.0, 6.0, 12.0, 45.0, 80.0}) {
        const int phong = level(ShadingRule::phong, degrees);
        EXPECT_NEAR(level(ShadingRule::blinn, degrees), phong, 2) << degrees;
        const int lambert = level(ShadingRule::lambert, degrees);
        EXPECT_NEAR(lambert, 100 * std::cos(degrees * 3.14159265358979 / 180), 0.6) << degrees;
        EXPECT_EQ(level(ShadingRule::none, degrees), 100);
        EXPECT_GE(phong, lambert);
    }
    EXPECT_EQ(level(ShadingRule::phong, 0), 200);
    EXPECT_EQ(level(ShadingRule::phong, 80), level(ShadingRule::lambert, 80));
    // Far from there the two rules differ: to the side of grazing light Blinn's is narrow.
    const Vector3 low = unit3({-1, 0, 0.1}), away = unit3({1, 0.3, 0.1});
    std::array<int, 2> shine{};
    for (const ShadingRule rule : {ShadingRule::phong, ShadingRule::blinn}) {
        ShadingSpec spec{0, {false, q14(low), {}}, {false, q14(away), {}}};
        spec.rule = rule;
        shine[static_cast<std::size_t>(rule)] =
            BlockShading(flat({1, 0, 0}, {0, 1, 0}), spec, {0, 255, 5}).shade(7, 7, 0)[0].intensity;
    }
    EXPECT_GT(shine[0], 40);
    EXPECT_LT(shine[1], 5);
}

}  // namespace
}  // namespace umbra78::raster
