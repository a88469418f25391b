// Culling at its margins: a receiver is moved over the edges of the light's volume in steps finer
// than a quantum, a texel or the dither. Where the plan leaves the test out, the frame that leaves
// out nothing must be all lit.
#include "shadow/frame/culling.hpp"

#include "shadow/frame/frame.hpp"
#include "tests/shadow/frame/equal_frames.hpp"
#include "tests/shadow/frame/planned_scenes.hpp"
#include "tests/support/effort.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <span>

namespace umbra78::shadow {
namespace {

using test::PlannedFrame;
using test::PlannedScene;

constexpr std::int32_t unit = 1 << 16;

raster::View cube(std::int32_t azimuth_degrees, std::int32_t extent) {
    raster::View v;
    v.axes = raster::axes_from_angles(azimuth_degrees * unit, 0);
    v.extent = extent;
    v.near_depth = -8 * unit;
    v.far_depth = 8 * unit;
    return v;
}

// How many frames of a sweep had a shadow, and in how many the test was left out.
struct Sweep {
    int frames = 0, dark = 0, left_out = 0;

    void draw(const PlannedScene& planned) {
        PlannedFrame expected(planned), got(planned);
        expected.draw(FramePlan{});
        const FramePlan plan = make_plan(expected.inputs);
        got.draw(plan);
        EXPECT_TRUE(test::equal_frames(expected.frame.buffers, got.frame.buffers))
            << planned.name << ", step " << frames;
        const std::span mask = expected.frame.buffers.lights[0].mask;
        ++frames;
        dark += std::find(mask.begin(), mask.end(), mask_shadow) != mask.end();
        left_out += plan.at(Omission::post_process).reason == Reason::outside_light;
    }
    void print(const char* what) const {
        std::printf("%s: %d frames, %d with a shadow, the test left out in %d\n", what, frames,
                    dark, left_out);
    }
};

// The observer looks along -z, the light along -x: its X is the observer's depth. A receiver that
// faces the observer has one depth; the edge of the light's picture passes it in steps of a sixth
// of a quantum. The caster lies beside the observer's picture.
PlannedScene depth_against_the_lights_edge(std::int32_t edge, std::int32_t light_z) {
    PlannedScene p;
    p.name = edge < 0 ? "left edge" : "right edge";
    p.settings.machine.xy_bits = 5;
    p.settings.machine.coefficient_bits = 32;
    p.settings.machine.fraction_bits = 12;
    p.observer = cube(0, 2 * unit);
    p.observer.near_depth = -3 * unit;
    p.observer.far_depth = 3 * unit;
    p.light = cube(90, 2 * unit);
    p.light.target.z = light_z - edge;
    p.patches.push_back(
        raster::plane_patch({{-unit, -unit, 0}, {2 * unit, 0, 0}, {0, 2 * unit, 0}, 0}));
    p.patches.push_back(raster::plane_patch(
        {{3 * unit, -unit, -unit}, {0, 0, 2 * unit}, {0, 2 * unit, 0}, 0}));
    return p;
}

TEST(Culling, TheDepthMarginAtTheLightsEdge) {
    constexpr int step = umbra78::test::sanitized ? 7 : 1;
    for (const std::int32_t edge : {-2 * unit, 2 * unit}) {
        for (const auto form : {raster::PatchForm::catmull, raster::PatchForm::diced}) {
            Sweep sweep;
            for (std::int32_t z = -40; z <= 40; z += step) {
                PlannedScene p = depth_against_the_lights_edge(edge, z);
                p.settings.surface = form;
                sweep.draw(p);
            }
            sweep.print(edge < 0 ? "left edge" : "right edge");
            EXPECT_GT(sweep.dark, sweep.frames / 4);
            EXPECT_GT(sweep.left_out, sweep.frames / 6) << "a diced margin is two words wider";
        }
    }
}

// Two texels along the normal carry a receiver that lies outside the light's picture into it.
TEST(Culling, LeavesOutNoTestOfPointsThatAreMoved) {
    Sweep sweep;
    for (std::int32_t z = -40; z <= 40; z += 5) {
        PlannedScene p = depth_against_the_lights_edge(-2 * unit, z);
        p.settings.receiver = Receiver::normal;
        p.settings.normal_offset_q8 = 2 << 8;
        sweep.draw(p);
    }
    sweep.print("moved along the normal");
    EXPECT_EQ(sweep.dark, sweep.frames);
    EXPECT_EQ(sweep.left_out, 0);
}

// A lamp that stands over the receiver and looks along it: behind the lamp there is no quotient,
// and nothing is left out on its account. The caster is too near to be seen.
TEST(Culling, LeavesOutNoTestOfPointsBehindALamp) {
    PlannedScene p;
    p.name = "behind a lamp";
    p.settings.machine.xy_bits = 5;
    p.observer = cube(0, 2 * unit);
    p.observer.near_depth = -unit / 2;
    p.observer.far_depth = unit / 2;
    p.light = cube(90, 2 * unit);
    p.light.projection = raster::Projection::perspective;
    p.light.target = {-unit, 0, unit};
    p.light.distance = 2 * unit;  // the eye at x = 1, z = 1
    p.light.near_depth = unit / 16;
    p.patches.push_back(raster::plane_patch(
        {{-3 * unit / 2, -unit, 0}, {3 * unit, 0, 0}, {0, 2 * unit, 0}, 0}));
    p.patches.push_back(raster::plane_patch(
        {{0, -unit, 3 * unit / 4}, {3 * unit / 4, 0, 0}, {0, 2 * unit, 0}, 0}));
    Sweep sweep;
    sweep.draw(p);
    EXPECT_EQ(sweep.dark, 1);
    EXPECT_EQ(sweep.left_out, 0);
}

// Observer and light look the same way, and the light's picture begins beside the receiver, `gap`
// of the observer's eighth pixels away. The caster is too near to be seen.
PlannedScene receiver_beside_the_light(int gap, bool above) {
    PlannedScene p;
    p.settings.machine.xy_bits = 5;
    p.settings.machine.coefficient_bits = 32;
    p.observer = cube(0, 2 * unit);
    p.observer.near_depth = -unit / 2;
    p.observer.far_depth = unit / 2;
    p.light = cube(0, 8 * unit);  // a texel is four pixels
    const std::int32_t edge = gap * (unit / 64);
    raster::World& target = p.light.target;
    (above ? target.y : target.x) = edge + 8 * unit;
    const std::int32_t back = -3 * unit / 2;
    p.patches.push_back(
        raster::plane_patch({{back, back, 0}, {-back, 0, 0}, {0, -back, 0}, 0}));
    p.patches.push_back(raster::plane_patch(
        {{-2 * unit, -2 * unit, 2 * unit}, {6 * unit, 0, 0}, {0, 6 * unit, 0}, 0}));
    return p;
}

TEST(Culling, TheDithersMarginAtTheLightsEdge) {
    constexpr int step = umbra78::test::sanitized ? 3 : 1;
    for (const bool above : {false, true}) {
        for (const hw::DitherShape shape :
             {hw::DitherShape::none, hw::DitherShape::uniform, hw::DitherShape::triangular}) {
            Sweep sweep;
            for (int gap = -20; gap <= 90; gap += step) {
                PlannedScene p = receiver_beside_the_light(gap, above);
                p.name = above ? "above" : "beside";
                p.settings.dither = {shape, 4 << 8, 0x12345678};
                p.settings.registration =
                    gap % 2 == 0 ? Registration::centre : Registration::index;
                sweep.draw(p);
            }
            sweep.print(shape == hw::DitherShape::none ? "no dither" : "dither of four texels");
            EXPECT_GT(sweep.dark, shape == hw::DitherShape::none ? 5 * (step == 1) : 1);
            EXPECT_GT(sweep.left_out, 1);
        }
    }
}

}  // namespace
}  // namespace umbra78::shadow
