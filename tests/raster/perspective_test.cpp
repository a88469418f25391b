// Perspective drawing against projective formulas: outlines, depths, and surfaces that reach
// behind the eye.
#include "tests/raster/truth.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace umbra78::raster {
namespace {

using namespace test;
using umbra78::test::Patches;
using umbra78::test::perspective;
using umbra78::test::plane;
using umbra78::test::q16;
using umbra78::test::Drawing;

MachineSpec wide_coefficients() {
    MachineSpec spec;
    spec.coefficient_bits = 24;
    return spec;
}

struct PerspectiveCase {
    Sphere sphere;
    double distance, near, far;
};

// The view's words are exact to 0.06 px with 24-bit coefficients and 16-bit object words; centre
// sampling adds its slack. A corner is divided, and between corners depth is linear as it should
// be, so an error in place is all the error there is.
constexpr double margin = 0.1;

class PerspectiveSphere : public testing::TestWithParam<PerspectiveCase> {};

TEST_P(PerspectiveSphere, HasTheRightOutlineAndDepth) {
    const auto& [sphere, distance, near, far] = GetParam();
    MachineSpec spec = wide_coefficients();
    spec.xy_bits = 8;
    View view = perspective(25, -15, 1.6, distance, near, far);
    view.target = {q16(0.1), q16(-0.2), q16(0.05)};
    const Camera camera(view, spec);
    Patches patches;
    umbra78::test::add_sphere(patches, sphere);
    for (const Sampling sampling : {Sampling::centre, Sampling::leaf}) {
        Drawing<> stage(spec);
        EXPECT_EQ(stage.draw(patches, view, sampling).unresolved, 0u);
        const double reach = sampling == Sampling::centre ? margin : 0.7072 + margin;
        int must = 0, missed = 0, stray = 0, deep = 0;
        double worst = 0, sum = 0;
        for (int py = 0; py < spec.size_px(); ++py) {
            for (int px = 0; px < spec.size_px(); ++px) {
                const double x = px - 127.5, y = py - 127.5;
                const bool drawn = stage.drawn(px, py);
                const bool inside = disc_lies(camera, sphere, x, y, margin) == Lies::inside;
                must += inside ? 1 : 0;
                if (inside && !drawn && missed++ == 0)
                    ADD_FAILURE() << "pixel " << px << ", " << py << " is missed";
                if (!drawn) continue;
                if (disc_lies(camera, sphere, x, y, reach) == Lies::outside && stray++ == 0)
                    ADD_FAILURE() << "pixel " << px << ", " << py << " is drawn outside";
                // Depths of the places round about bound the code.
                double min = 1e9, max = -1e9;
                for (const double dx : {-reach, 0.0, reach}) {
                    for (const double dy : {-reach, 0.0, reach}) {
                        const auto at = hit(camera.ray(x + dx, y + dy), sphere);
                        const double code = at ? camera.code(*at, spec) : 1e9;
                        min = std::min(min, code);
                        max = std::max(max, code);
                    }
                }
                if (max == 1e9) continue;  // at the limb
                const double code = stage.depth_at(px, py);
                if ((code < min - 3 || code > max + 3) && deep++ == 0)
                    ADD_FAILURE() << "pixel " << px << ", " << py << ": code " << code
                                  << " not in " << min << " .. " << max;
                const auto at = hit(camera.ray(x, y), sphere);
                worst = std::max(worst, std::abs(code - camera.code(*at, spec)));
                sum += code - camera.code(*at, spec);
            }
        }
        EXPECT_GT(must, 100);
        std::cout << "[ measured ] " << must << " pixels, depth error at most " << worst
                  << " quanta, mean " << sum / must << '\n';
    }
}

INSTANTIATE_TEST_SUITE_P(
    Distances, PerspectiveSphere,
    testing::Values(PerspectiveCase{umbra78::test::sphere(0, 0, 0, 1), 5, 3, 8},
                    PerspectiveCase{umbra78::test::sphere(0.3, 0.5, -0.2, 0.9), 2.5, 0.5, 5},
                    PerspectiveCase{umbra78::test::sphere(0, 0, 0, 1.2), 1.8, 0.2, 200},
                    PerspectiveCase{umbra78::test::sphere(-0.5, 0.4, 0.3, 0.25), 40, 30, 50},
                    PerspectiveCase{umbra78::test::sphere(-3, -1, -9, 2.5), 6, 1, 30}));

// Planes through and past the eye are cut at the near plane: in few blocks, without loss before it.
TEST(Perspective, SurfacesThatReachBehindTheEyeAreDrawn) {
    const MachineSpec spec = wide_coefficients();
    for (const double near : {0.0625, 0.5}) {
        for (const double behind : {4.0, 5.0, 5.1, 8.0, 40.0}) {  // the eye is at z = 5
            const View view = perspective(0, 0, 2, 5, near, 60);
            const Patches floor{plane_patch(plane({-20, -1, behind}, {40, 0, 0},
                                                  {0, 0, -30 - behind}))};
            Drawing<> stage(spec);
            const DrawCounts counts = stage.draw(floor, view, Sampling::centre);
            EXPECT_EQ(counts.unresolved, 0u);
            EXPECT_LT(counts.blocks, 10000u);
            // The floor's far end is z = -30, so every row from 640/35 + 1 below the middle on.
            for (int py = 256 + 20; py < 512; ++py)
                for (int px = 0; px < 512; ++px)
                    ASSERT_TRUE(stage.drawn(px, py)) << px << ", " << py << " behind " << behind;
            const auto above = std::count_if(stage.depth().begin(),
                                             stage.depth().begin() + 512 * 256,
                                             [](std::uint16_t z) { return z != 0xffff; });
            EXPECT_EQ(above, 0) << "nothing above the horizon";
        }
    }
}

// A surface that ends just before the eye, a tenth of a million pixels below the frame: about a
// clamped centre its bounds held the frame, and it took the patch's whole allowance of splits.
TEST(Perspective, WhatEndsJustBeforeTheEyeTakesFewSplits) {
    const MachineSpec spec = wide_coefficients();
    for (const double near : {0.0009765625, 0.0625, 0.5}) {
        const View view = perspective(0, 0, 2, 5, near, 60);
        const Patches floor{plane_patch(plane({-20, -1, 5 - 1.0 / 512}, {40, 0, 0}, {0, 0, -30}))};
        Drawing<> stage(spec);
        const DrawCounts counts = stage.draw(floor, view, Sampling::centre);
        EXPECT_EQ(counts.unresolved, 0u);
        EXPECT_LT(counts.splits, 10000u) << "near " << near;
        for (int px = 0; px < 512; ++px) ASSERT_TRUE(stage.drawn(px, 511)) << px;
    }
}

TEST(Perspective, TheEyeMayStandInASurfaceOrInsideASphere) {
    const MachineSpec spec = wide_coefficients();
    const View view = perspective(0, 0, 2, 5, 0.0625, 60);
    Patches patches{plane_patch(plane({-20, 0, 20}, {40, 0, 0}, {0, 0, -40})),
                    plane_patch(plane({0, -20, 20}, {0, 40, 0}, {0, 0, -40}))};
    umbra78::test::add_sphere(patches, umbra78::test::sphere(0, 0, 5, 10));
    Drawing<> stage(spec);
    const DrawCounts counts = stage.draw(patches, view, Sampling::centre);
    EXPECT_EQ(counts.unresolved, 0u);
    EXPECT_LT(counts.blocks, 30000u);
    EXPECT_EQ(std::count(stage.depth().begin(), stage.depth().end(), 0xffff), 0)
        << "the sphere is all around";
}

}  // namespace
}  // namespace umbra78::raster
