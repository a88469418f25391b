// Truth of a light with an area: the share of it that is seen, where that is known by hand.
#include "tests/support/effort.hpp"
#include "tools/scene/scene_file.hpp"
#include "tools/truth/metrics.hpp"
#include "tools/truth/patch_truth.hpp"
#include "tools/truth/scene_truth.hpp"
#include "tools/render/render_job.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace umbra78::tools {
namespace {

// A floor seen from above, and a half plane x < 0 at height 1, seen from below by nobody: the
// square light stands at height 5, so that a floor point at x sees the part of it beyond
// -x (5 - 1) / 1, of a side of 2.
constexpr double light_height = 5, edge_height = 1, side = 2;

double share_by_hand(double x) {
    return std::clamp(0.5 + x * (light_height - edge_height) / (edge_height * side), 0.0, 1.0);
}

std::string half_plane_scene(int samples, int xy_bits = 8) {
    return "[observer]\nazimuth = 0\nelevation = 90\ntarget = [0.6, 0, 0]\nextent = 0.5\n"
           "near = -0.5\nfar = 2\nrecentre = \"off\"\n"
           "[light]\nkind = \"area\"\nposition = [0, 5, 0]\ntarget = [0, 0, 0]\nsize = 2\n"
           "extent = 3\nsamples = " + std::to_string(samples) + "\n"
           "[[plane]]\norigin = [-4, 0, 4]\nu = [8, 0, 0]\nv = [0, 0, -8]\n"
           "[[plane]]\norigin = [-4, 1, 4]\nu = [4, 0, 0]\nv = [0, 0, -8]\n"
           "[settings]\nxy_bits = " + std::to_string(xy_bits) +
           "\nz_bits = 16\nlookup = \"bilinear\"\nbias = 2\n"
           "bias_unit = \"texels\"\n";
}

double x_of(const Truth& truth, std::size_t at) { return truth.position[at][0]; }

TEST(AreaTruth, IsTheShareByHand) {
    const LoadedScene scene =
        parse_scene(half_plane_scene(4, umbra78::test::sanitized ? 6 : 8), "a.toml", {});
    ASSERT_TRUE(scene.has_closed_form());
    const auto known = trace(scene);
    ASSERT_TRUE(known);
    const Truth& truth = known->truth;
    EXPECT_EQ(truth.points, 1024);
    int lit = 0, umbra = 0, between = 0;
    for (std::size_t at = 0; at < truth.visible.size(); ++at) {
        if (!truth.visible[at] || truth.position[at][1] > 0.5) continue;
        const double expected = share_by_hand(x_of(truth, at));
        ASSERT_NEAR(truth.light_share(at), expected, 1.0 / 32) << x_of(truth, at);
        lit += truth.light_share(at) == 1;
        umbra += truth.light_share(at) == 0;
        between += truth.light_share(at) > 0 && truth.light_share(at) < 1;
        EXPECT_EQ(truth.lit[at], truth.light_share(at) >= 0.5);
    }
    EXPECT_GT(lit, umbra78::test::sanitized ? 60 : 1000);
    EXPECT_GT(between, umbra78::test::sanitized ? 60 : 1000);
    EXPECT_EQ(umbra, 0);  // the window begins at x = 0.1, where 0.7 of the light is seen
}

// Embree and the closed form count the same points, but for those on an edge.
TEST(AreaTruth, IsEmbreesToo) {
    if (!traces_patches()) GTEST_SKIP() << "built without Embree";
    const LoadedScene scene = parse_scene(half_plane_scene(2), "a.toml", {});
    const auto known = trace(scene);
    ASSERT_TRUE(known);
    TruthLight light = known->light;
    ASSERT_TRUE(light.has_area());
    const auto traced = trace_patches(scene.surfaces(), known->observer, light);
    ASSERT_TRUE(traced);
    int compared = 0;
    for (std::size_t at = 0; at < known->truth.visible.size(); ++at) {
        if (!known->truth.visible[at] || !traced->truth.visible[at]) continue;
        EXPECT_NEAR(known->truth.light_share(at), traced->truth.light_share(at), 0.04) << at;
        ++compared;
    }
    EXPECT_GT(compared, 10000);
}

// The machine's darkness comes nearer to truth with more points, and its penumbra as large.
TEST(AreaTruth, MorePointsComeNearerToIt) {
    if (umbra78::test::sanitized) GTEST_SKIP() << "numbers, whose parts the other tests go through";
    double before = 1;
    for (const int samples : {2, 4, 8}) {
        const LoadedScene scene = parse_scene(half_plane_scene(samples), "a.toml", {});
        const auto known = trace(scene);
        ASSERT_TRUE(known);
        RenderJob job(scene.view(), scene.settings);
        job.render();
        const std::vector<std::uint8_t> visible = job.visible();
        const GradedError error =
            graded_error(known->truth, {job.bytes(Plane::filtered), visible}, known->unlit_side);
        EXPECT_GT(error.penumbra, 1000) << samples;
        EXPECT_LT(error.rms(), before) << samples;
        EXPECT_LT(error.rms(), 0.6 / samples) << samples;
        EXPECT_NEAR(error.penumbra_ratio(), 1, samples == 8 ? 0.15 : 1);
        before = error.rms();
    }
}

// Shares between 0 and 1 count for neither end.
TEST(AreaTruth, GradedErrorsAreFromTheShare) {
    Truth truth(2);
    truth.points = 4;
    truth.seen = {4, 0, 1, 2};
    truth.visible = {1, 1, 1, 1};
    truth.lit = {1, 0, 0, 1};
    const std::vector<std::uint8_t> mask{0, 255, 255, 102};
    const GradedError error = graded_error(truth, {mask, {}});
    EXPECT_EQ(error.lit, 1);
    EXPECT_EQ(error.umbra, 1);
    EXPECT_EQ(error.penumbra, 2);
    EXPECT_EQ(error.between, 1);
    EXPECT_EQ(error.lit_below_98 + error.umbra_above_2, 0);
    EXPECT_DOUBLE_EQ(error.mean_absolute(), (0.25 + 0.1) / 4);
    EXPECT_DOUBLE_EQ(error.rms(), std::sqrt((0.0625 + 0.01) / 4));
    EXPECT_DOUBLE_EQ(error.penumbra_ratio(), 0.5);
}

}  // namespace
}  // namespace umbra78::tools
