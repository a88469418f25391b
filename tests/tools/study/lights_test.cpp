// The study of lights: what it changes in a scene, how large its texels are, and what grows.
#include "tests/tools/study/study_cases.hpp"
#include "tools/cli/study_list.hpp"
#include "tools/study/grid.hpp"
#include "tools/study/lights/lights.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace umbra78::tools::study {
namespace {

double world(std::int32_t q16) { return std::ldexp(q16, -16); }

Real3 unit(const raster::Axis& axis) {
    return {std::ldexp(axis[0], -30), std::ldexp(axis[1], -30), std::ldexp(axis[2], -30)};
}

// A square that both views see from the front and that fills both windows.
Request square() {
    return request_of(R"([light]
azimuth = 0
extent  = 2
near    = -3
far     = 3

[observer]
azimuth = 0
extent  = 2
near    = -3
far     = 3

[[plane]]
origin  = [-16, -16, 0]
u       = [32, 0, 0]
v       = [0, 32, 0]

[settings]
xy_bits = 6
)");
}

TEST(LightsSize, ChangesTexelsAlone) {
    const Request request = square();
    for (const double texels : {0.25, 0.5, 1.0, 2.0, 4.0}) {
        Case c;
        c.set = size_overrides(request.scene, texels);
        const LoadedScene scene = scene_of(request, c);
        const int size = scene.settings.machine.size_px();
        EXPECT_DOUBLE_EQ(2 * world(scene.observer.extent) / size, 4.0 / 64) << "its pixels stay";
        EXPECT_DOUBLE_EQ(2 * world(scene.light().extent) / size, texels * 4 / 64);
        EXPECT_EQ(scene.light().near_depth, request.scene.light().near_depth);
        EXPECT_EQ(scene.light().far_depth, request.scene.light().far_depth);
        EXPECT_EQ(scene.settings.machine.z_bits, 16);
        const auto truth = trace(scene);
        ASSERT_TRUE(truth);
        const TexelSides sides = texel_sides(*truth);
        EXPECT_NEAR(sides.median, texels, 1e-9);
        EXPECT_NEAR(sides.most, texels, 1e-9);
    }
}

// On a plane turned by 60 degrees from the light, texels are twice as long one way.
TEST(TexelSides, GrowWhereTheLightGrazes) {
    const Request request = square();
    Case c;
    c.set = {"light.azimuth=60", "light.near=-40", "light.far=40"};
    const TexelSides sides = texel_sides(*trace(scene_of(request, c)));
    EXPECT_NEAR(sides.median, std::sqrt(2), 1e-6);
    SceneTruth dark = *trace(request.scene);
    std::ranges::fill(dark.truth.lit, std::uint8_t{0});
    EXPECT_TRUE(std::isnan(texel_sides(dark).median));
}

TEST(LightsAngle, IsFromTheObserversAzimuth) {
    Request request = square();
    for (const double own : {0.0, 120.0, -170.0})
        for (const double degrees : {0.0, 90.0, 180.0}) {
            Case c;
            c.set = {"observer.azimuth=" + std::to_string(own)};
            const LoadedScene turned = scene_of(request, c);
            c.set.push_back(angle_override(turned, degrees));
            const LoadedScene scene = scene_of(request, c);
            EXPECT_NEAR(dot(unit(scene.observer.axes.back), unit(scene.light().axes.back)),
                        std::cos(degrees * pi / 180), 1e-5) << own << " " << degrees;
        }
}

TEST(OpposedLamp, SeesWhatTheObserverSeesOrFacesIt) {
    const LoadedScene same = parse_scene(opposed_lamp_scene(0), "same", {});
    const LoadedScene opposite = parse_scene(opposed_lamp_scene(180), "opposite", {});
    const Real3 eye = unit(same.observer.axes.back);
    EXPECT_NEAR(dot(eye, unit(same.light().axes.back)), 1, 1e-6);
    const Real3 facing = unit(opposite.light().axes.back);
    EXPECT_NEAR(facing[0], -eye[0], 1e-5);
    EXPECT_NEAR(facing[1], eye[1], 1e-5);
    EXPECT_NEAR(facing[2], -eye[2], 1e-5);
    EXPECT_NEAR(world(same.light().distance), world(opposite.light().distance), 1e-3);
    EXPECT_NEAR(world(same.observer.distance), world(same.light().distance), 1e-3);
}

TEST(ErrorPicture, HasAGreyForEachAnswer) {
    SceneTruth truth{};
    truth.truth.visible = {1, 1, 1, 1, 0, 1};
    truth.truth.lit = {1, 1, 0, 0, 1, 1};
    truth.unlit_side = {0, 0, 0, 0, 0, 1};
    const std::vector<std::uint8_t> mask{0, 255, 255, 0, 0, 0};
    EXPECT_EQ(error_picture(truth, {mask, {}}),
              (std::vector<std::uint8_t>{200, 0, 110, 255, 235, 235}));
}

const Case* find_case(const std::vector<Case>& cases, Question q, std::string_view at) {
    for (const Case& c : cases)
        if (question_of(c) == q && c.extra.at(1).second == at) return &c;
    return nullptr;
}

// The light grazes the floor more and more: the least bias grows as one over the height.
TEST(LightsStudy, TheLeastBiasGrowsAsALampSinks) {
    Request request = small_sphere();
    request.vary = {{"xy_bits", {"7"}}};
    const auto study = make_lights_study();
    const auto cases = study->cases(request);
    std::vector<double> least;
    for (const char* at : {"1", "0.5", "0.25"}) {
        const Case* c = find_case(cases, Question::low_lamp, at);
        ASSERT_NE(c, nullptr) << at;
        const Row row = figures_of(*study, request, *c);
        EXPECT_EQ(row.number("at"), std::stod(at));
        EXPECT_EQ(row.number("missing_pixels"), 0);
        least.push_back(row.number("least_outside_world"));
    }
    EXPECT_NEAR(least[1] / least[0], 2, 0.5);
    EXPECT_NEAR(least[2] / least[1], 2, 0.5);
}

TEST(LightsStudy, ACoarserMapCostsErrorsAndSavesCycles) {
    const Request request = small_sphere();
    const auto study = make_lights_study();
    const auto cases = study->cases(request);
    const auto row = [&](const char* at) {
        return figures_of(*study, request, *find_case(cases, Question::size, at));
    };
    const Row fine = row("0.5"), own = row("1"), coarse = row("4");
    EXPECT_GT(own.number("false_light_at_least"), fine.number("false_light_at_least"));
    EXPECT_GT(coarse.number("false_light_at_least"), own.number("false_light_at_least"));
    EXPECT_GT(fine.number("light_cycles"), own.number("light_cycles"));
    EXPECT_GT(own.number("light_cycles"), coarse.number("light_cycles"));
    EXPECT_EQ(fine.number("observer_cycles"), own.number("observer_cycles"));
    EXPECT_EQ(fine.number("lit_px"), coarse.number("lit_px")) << "the picture stays";
    EXPECT_NEAR(coarse.number("texel_px_median"), 4 * own.number("texel_px_median"), 1e-9);
}

TEST(LightsStudy, ItsCasesAreNotMultiplied) {
    Request request = small_sphere();
    request.quick = true;
    const auto study = make_lights_study();
    EXPECT_EQ(study->cases(request).size(), 4u * 3 * 2);
    request.vary = {{"light.azimuth", {"-100", "-60"}}, {"lookup", {"percentage"}}};
    const auto cases = study->cases(request);
    std::set<std::string> names;
    for (const Case& c : cases) names.insert(c.name);
    EXPECT_EQ(names.size(), cases.size());
    for (const Case& c : cases)
        if (question_of(c) == Question::opposed_lamp) {
            EXPECT_NO_THROW(study->scene(request, c)) << c.name;
        }
    request.vary = {};
    request.scene = parse_scene(low_lamp_scene(1), "lamp", {});
    request.scene_text = low_lamp_scene(1);
    EXPECT_EQ(find_case(study->cases(request), Question::angle, "90"), nullptr)
        << "a lamp has no azimuth";
}

}  // namespace
}  // namespace umbra78::tools::study
