// Truth against answers known from geometry, and against a slow model that shares only the
// definition with it: it goes along the ray in small steps and looks on which side of each surface
// it is.
#include "tools/truth/truth.hpp"

#include "tests/tools/truth/half_lit.hpp"
#include "tests/support/effort.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace umbra78::tools {
namespace {

constexpr double degrees = std::numbers::pi / 180;

TruthView front_view(int size, double extent) {
    return {false, {}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, extent, 0, -100, 100, size};
}

// Looks down on the world: right is x, up in the picture is -z.
TruthView top_view(int size, double extent) {
    return {false, {}, {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}, extent, 0, -100, 100, size};
}

TruthLight light_at_azimuth(double angle) {
    return {false, {std::sin(angle * degrees), 0, std::cos(angle * degrees)}, {}};
}

TruthPlane floor_at(double y, double half) {
    return {{-half, y, -half}, {2 * half, 0, 0}, {0, 0, 2 * half}};
}

using test::total;

TEST(Truth, ASpheresTerminatorIsAtRightAnglesToTheLight) {
    const int size = 512;
    const TruthScene scene{{{{0, 0, 0}, 1.0}}, {}};
    const Truth truth = trace(scene, front_view(size, 1.25), light_at_azimuth(-100));
    int terminator = 0;
    for (int column = 0; column < size; ++column)
        terminator += truth.lit[size / 2 * size + column] != 0 ||
                      (column < size / 2 && !truth.visible[size / 2 * size + column]);
    const double expected = size / 2 * (1 + std::sin(-10 * degrees) / 1.25);
    EXPECT_NEAR(terminator, expected, 1);
    // A phase angle of 100 degrees: the lit part of the disc is (1 + cos 100) / 2.
    EXPECT_NEAR(double(total(truth.lit)) / total(truth.visible),
                (1 + std::cos(100 * degrees)) / 2, 0.002);
    const std::size_t centre = size / 2 * size + size / 2;
    EXPECT_NEAR(truth.depth[centre], -1, 1e-4);
    EXPECT_NEAR(truth.n_dot_l[centre], std::cos(100 * degrees), 0.01);
    EXPECT_EQ(truth.surface[centre], 0);
    EXPECT_EQ(truth.surface[0], no_surface);
    EXPECT_TRUE(std::isinf(truth.depth[0]));
}

TEST(Truth, ASpheresShadowOnAPlaneIsTheEllipseOfGeometry) {
    const int size = 300;
    const double elevation = 40 * degrees, height = 3, extent = 6;
    const TruthScene scene{{{{0, height, 0}, 1.0}}, {floor_at(0, 6)}};
    const TruthLight light{false, {-std::cos(elevation), std::sin(elevation), 0}, {}};
    const TruthView view = top_view(size, extent);
    const Truth truth = trace(scene, view, light);
    int shadowed = 0;
    for (std::size_t at = 0; at < truth.lit.size(); ++at) {
        if (truth.surface[at] != 1) continue;
        const auto [x, y, z] = truth.position[at];
        EXPECT_NEAR(y, 0, 1e-12);
        const double along_light = (x - height / std::tan(elevation)) * std::sin(elevation);
        const double distance = std::hypot(along_light, z);
        if (std::abs(distance - 1) < 1e-9) continue;
        EXPECT_EQ(truth.lit[at] == 0, distance < 1) << "at " << at % size << ", " << at / size;
        shadowed += distance < 1;
    }
    EXPECT_GT(shadowed, 500);
}

TEST(Truth, APointLightThrowsTheShadowOfTheTangentCone) {
    const int size = 400;
    const double light_height = 5, sphere_height = 2;
    const TruthScene scene{{{{0, sphere_height, 0}, 1.0}}, {floor_at(0, 5)}};
    const TruthLight light{true, {}, {0, light_height, 0}};
    const TruthView view = top_view(size, 5);
    const Truth truth = trace(scene, view, light);
    const double radius = light_height * std::tan(std::asin(1 / (light_height - sphere_height)));
    EXPECT_GT(radius, 1.7);
    for (std::size_t at = 0; at < truth.lit.size(); ++at) {
        if (truth.surface[at] != 1) continue;
        const double distance = std::hypot(truth.position[at][0], truth.position[at][2]);
        EXPECT_EQ(truth.lit[at] == 0, distance < radius) << at % size << ", " << at / size;
    }
    // What lies behind the light throws no shadow.
    EXPECT_FALSE(occluded({0, 0, 0}, {true, {}, {0, 0.9, 0}}, scene, 1));
    EXPECT_TRUE(occluded({0, 0, 0}, {true, {}, {0, 5, 0}}, scene, 1));
}

TEST(Truth, InPerspectiveASphereShowsItsTangentCone) {
    const int size = 400;
    const double distance = 3;
    TruthView view = front_view(size, 1.5);
    view.perspective = true;
    view.distance = distance;
    view.near_depth = 0.1;
    const Truth truth = trace({{{{0, 0, 0}, 1.0}}, {}}, view, light_at_azimuth(0));
    const double radius_px = distance * std::tan(std::asin(1 / distance)) / view.pixel();
    EXPECT_NEAR(total(truth.visible), std::numbers::pi * radius_px * radius_px, 100);
    const std::size_t centre = size / 2 * size + size / 2;
    EXPECT_NEAR(truth.depth[centre], distance - 1, 1e-4);  // from the eye
}

TEST(Truth, ProjectUndoesRay) {
    TruthView view = top_view(64, 2);
    for (const bool perspective : {false, true}) {
        view.perspective = perspective;
        view.distance = 5;
        const Ray ray = view.ray(10.25, 50.5);
        const Real3 seen = view.project(along(ray.origin, 3.5, ray.direction));
        EXPECT_NEAR(seen[0], 10.25, 1e-9);
        EXPECT_NEAR(seen[1], 50.5, 1e-9);
        EXPECT_NEAR(seen[2], 3.5, 1e-9);
    }
    EXPECT_LT(view.project({0, 0, -1})[1], 32);  // up is toward row 0
}

TEST(Truth, APlaneIsLitWhereLightAndViewerAreOnOneSide) {
    TruthScene scene{{}, {{{-1, -1, 0}, {2, 0, 0}, {0, 2, 0}}}};
    for (const bool turned : {false, true}) {
        if (turned) std::swap(scene.planes[0].u, scene.planes[0].v);
        const Truth front = trace(scene, front_view(64, 2), light_at_azimuth(30));
        const Truth behind = trace(scene, front_view(64, 2), light_at_azimuth(150));
        EXPECT_EQ(total(front.visible), 32 * 32);
        EXPECT_EQ(total(front.lit), 32 * 32);
        EXPECT_EQ(total(behind.lit), 0);
    }
}

TEST(Truth, OnlyWhatLiesBetweenNearAndFarIsSeen) {
    const TruthScene scene{{{{0, 0, 0}, 1.0}}, {{{-9, -9, -5}, {18, 0, 0}, {0, 18, 0}}}};
    TruthView view = front_view(64, 2);
    const std::size_t centre = 32 * 64 + 32;
    EXPECT_EQ(trace(scene, view, light_at_azimuth(0)).surface[centre], 0);
    view.near_depth = 0;  // cuts the sphere open: its back shows
    EXPECT_NEAR(trace(scene, view, light_at_azimuth(0)).depth[centre], 1, 1e-2);
    view.near_depth = 2;
    EXPECT_EQ(trace(scene, view, light_at_azimuth(0)).surface[centre], 1);
    view.far_depth = 4;
    EXPECT_EQ(trace(scene, view, light_at_azimuth(0)).surface[centre], no_surface);
}

// Whether the way from `point` to `point + length way` passes through a surface's inside; the
// first and last thousandth are not looked at.
bool marched_occluded(const TruthScene& scene, const Real3& point, const Real3& way,
                      double length) {
    const int steps = 4000;
    for (int step = 4; step < steps - 4; ++step) {
        const Real3 at = along(point, length * step / steps, way);
        for (const TruthSphere& sphere : scene.spheres) {
            const Real3 from = along(at, -1, sphere.centre);
            if (dot(from, from) < sphere.radius * sphere.radius) return true;
        }
        const Real3 next = along(point, length * (step + 1) / steps, way);
        for (const TruthPlane& plane : scene.planes) {  // the tests' planes are level floors
            const bool through = (at[1] - plane.origin[1]) * (next[1] - plane.origin[1]) <= 0;
            const double s = (at[0] - plane.origin[0]) / plane.u[0];
            const double t = (at[2] - plane.origin[2]) / plane.v[2];
            if (through && s >= 0 && s <= 1 && t >= 0 && t <= 1) return true;
        }
    }
    return false;
}

TEST(Truth, AgreesWithMarchingAlongTheRay) {
    const unsigned seed = 78;
    std::mt19937 random(seed);
    const auto place = [&] { return 4 * (static_cast<double>(random()) / 4294967296.0) - 2; };
    int cases = 0, shadowed = 0, differing = 0;
    for (int trial = 0; trial < (umbra78::test::sanitized ? 4 : 12); ++trial) {
        TruthScene scene{{}, {floor_at(-2, 2), floor_at(1.5, 0.7)}};
        for (int i = 0; i < 4; ++i)
            scene.spheres.push_back({{place(), place(), place()}, 0.6});
        TruthLight light{trial % 2 == 0, {place(), 3, place()},
                         {place(), 7, place()}};
        light.direction = along({}, 1 / std::sqrt(dot(light.direction, light.direction)),
                                light.direction);
        TruthView view = front_view(24, 2.8);
        view.rotation[1] = {0, 0.8, -0.6};
        view.rotation[2] = {0, 0.6, 0.8};
        const Truth truth = trace(scene, view, light);
        for (std::size_t at = 0; at < truth.lit.size(); ++at) {
            if (!truth.visible[at] || std::abs(truth.n_dot_l[at]) < 0.1) continue;
            const Ray ray = light.ray(truth.position[at]);
            const bool dark = truth.n_dot_l[at] < 0 ||
                              marched_occluded(scene, ray.origin, ray.direction,
                                               light.point ? 1 : 20);
            ++cases;
            shadowed += dark;
            differing += dark == (truth.lit[at] != 0);
        }
    }
    EXPECT_GT(cases, umbra78::test::sanitized ? 500 : 1500) << "seed " << seed;
    EXPECT_GT(shadowed, cases / 10);
    EXPECT_LE(differing, cases / 1000) << "seed " << seed;  // a march may step over an edge
}

// The eye in a closed room: its normals point inward, a lamp inside lights all of it, and no light
// from outside reaches it.
TEST(Truth, ASphereSeenFromInsideIsLitFromInsideOnly) {
    const TruthScene room{{{{0, 0, 0}, 10.0}}, {}};
    TruthView view = front_view(32, 3);
    view.perspective = true;
    view.distance = 6;
    view.near_depth = 0.01;
    const Truth inside = trace(room, view, {true, {}, {0, 5, 0}});
    EXPECT_EQ(total(inside.visible), 32 * 32);
    EXPECT_EQ(total(inside.lit), 32 * 32);
    const std::size_t centre = 16 * 32 + 16;
    EXPECT_NEAR(inside.depth[centre], 16, 0.01);
    EXPECT_NEAR(inside.normal[centre][2], 1, 0.01);
    for (const TruthLight& outside : {TruthLight{true, {}, {0, 50, 0}}, light_at_azimuth(0),
                                      light_at_azimuth(180)})
        EXPECT_EQ(total(trace(room, view, outside).lit), 0);
    // A ball in the room throws its shadow on the wall.
    TruthScene with_ball = room;
    with_ball.spheres.push_back({{0, 0, -5}, 1});
    const Truth shadowed = trace(with_ball, view, {true, {}, {0, 5, 0}});
    EXPECT_GT(total(shadowed.visible) - total(shadowed.lit), 10);
    EXPECT_EQ(shadowed.lit[0], 1);
}

TEST(Truth, NothingInTheSceneIsNothingSeen) {
    const Truth truth = trace({}, front_view(16, 1), light_at_azimuth(0));
    EXPECT_EQ(total(truth.visible), 0);
    EXPECT_EQ(truth.lit.size(), 256u);
}

}  // namespace
}  // namespace umbra78::tools
