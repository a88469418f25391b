// A frame that has lost something says so: each kind of loss has its key, its measured figure and a
// remedy, and the remedy helps. Truth's pixels that the machine does not draw are errors, too.
#include "tests/tools/render/case_scenes.hpp"

#include "tests/support/paths.hpp"
#include "tools/render/report.hpp"
#include "tools/scene/checks.hpp"
#include "tools/scene/visible_depths.hpp"

#include <nlohmann/json.hpp>

namespace umbra78::tools {
namespace {

using test::DrawnCase;
using Texts = std::vector<std::string>;

constexpr const char* left_light = "[light]\nazimuth = -60\nelevation = 40\n";
const Texts small{"xy_bits=8"};

// A ball in front of the eye over a floor so large that far / 1024 is behind the ball.
std::string ball_on_a_plain(int half) {
    const std::string side = std::to_string(half), whole = std::to_string(2 * half);
    return "[observer]\nprojection = \"perspective\"\nazimuth = 10\nelevation = 5\n"
           "target = [0, 0.5, 0]\nextent = 2.5\ndistance = 8\n" + std::string(left_light) +
           "target = [0, 0.5, 0]\nextent = 3\n[[sphere]]\ncentre = [0, 0.8, 0]\nradius = 0.5\n"
           "[[plane]]\norigin = [-" + side + ", 0, " + side + "]\nu = [" + whole +
           ", 0, 0]\nv = [0, 0, -" + whole + "]\n";
}

Texts with(const Texts& set, const Texts& more) {
    Texts all = set;
    all.insert(all.end(), more.begin(), more.end());
    return all;
}

TEST(FrameWarnings, TheFiguresHaveNoneAndLackNothing) {
    const LoadedScene file = load_scene(UMBRA78_SOURCE_DIR "/tools/scenes/figures.toml", {});
    EXPECT_EQ(lines_of(file.warnings), Texts{});
    RenderJob job(file.view(), file.settings);
    job.render();
    const SceneTruth truth = *trace(file);
    const std::vector<std::uint8_t> visible = job.visible();
    const Buffer depths = job.buffer(Plane::observer_z);
    const ShadowReport r =
        report(truth, {job.bytes(Plane::filtered), visible}, light_texel_band(truth), &depths);
    ASSERT_TRUE(r.coverage);
    EXPECT_TRUE(r.coverage->complete());
    EXPECT_EQ(r.coverage->drawn, 106772);
    EXPECT_EQ(r.coverage->beyond_edge, 55);
    EXPECT_EQ(r.all.lit + r.all.shadowed, 106772 - 55);
    EXPECT_EQ(r.unlit_side, 0);
    EXPECT_NE(print(r).find("compared    106717 of 106772 pixels drawn; 55 lie beyond the exact "
                            "silhouette, 0 on unlit sides\n"), std::string::npos);
    EXPECT_TRUE(frame_warnings(file, job, r).empty());
}

// The near plane is compared with the surfaces, not with its own fit; setting it as the line says
// brings the ball back.
TEST(FrameWarnings, AFittedNearPlaneThatCutsIsReported) {
    const std::string text = ball_on_a_plain(8000);
    const DrawnCase cut(text, small);
    EXPECT_EQ(cut.measured("near_plane"), 33);
    EXPECT_EQ(cut.scene.observer.near_depth, cut.scene.observer.far_depth / 1024);
    EXPECT_NE(cut.line("near_plane").find("(fitted: far / 1024)"), std::string::npos);
    EXPECT_NE(cut.line("near_plane").find("set observer.near = 2.9"), std::string::npos)
        << cut.line("near_plane");
    EXPECT_GT(cut.measured("missing"), 20000);
    EXPECT_GT(cut.measured("misplaced"), 1000);  // the plain behind the ball shows
    EXPECT_GT(cut.measured("object_words"), 10);
    EXPECT_GT(cut.measured("depth_order"), 4);   // the light's

    const std::string line = cut.line("near_plane");
    const std::size_t at = line.find("observer.near = ");
    const DrawnCase whole(text, with(small, {"observer.near=" + line.substr(at + 16, 5)}));
    EXPECT_EQ(whole.line("near_plane"), "");
    // A 32nd of the window may be overlooked; the ball is crushed by the floor's words.
    EXPECT_LT(whole.report->coverage->missing, 100);
}

// A ball is closed; a plane, a patch and a facet are not, and two facets share one side of three.
TEST(FrameWarnings, OpenSurfacesLoseTheirShadowsInAMapOfBacks) {
    const std::string ball =
        "[light]\nazimuth = 20\n[[sphere]]\ncentre = [0, 0, 0]\nradius = 0.5\n";
    const std::string plane =
        "[[plane]]\norigin = [-1, -1, -1]\nu = [2, 0, 0]\nv = [0, 0, 2]\n";
    const Texts back = with(small, {"map_depth=back"});
    EXPECT_EQ(DrawnCase(ball, back).line("open_surfaces"), "");
    EXPECT_EQ(DrawnCase(ball + plane, small).line("open_surfaces"), "");
    const DrawnCase open(ball + plane, back);
    EXPECT_EQ(open.measured("open_surfaces"), 1);
    EXPECT_NE(open.line("open_surfaces").find("1 of 33 patches have an open border"),
              std::string::npos)
        << open.line("open_surfaces");
}

TEST(FrameWarnings, AGivenNearOrFarThatCutsIsReported) {
    const std::string text = test::first_natural_scene();
    EXPECT_EQ(DrawnCase(text, small).keys(), Texts{"light_window"});
    const DrawnCase near(text, with(small, {"observer.near=8", "observer.far=20"}));
    EXPECT_GT(near.measured("near_plane"), 0);
    EXPECT_GT(near.measured("missing"), 1000);
    EXPECT_NE(near.line("near_plane").find("or leave near and far out"), std::string::npos);
    const DrawnCase far(text, with(small, {"observer.near=1", "observer.far=8"}));
    EXPECT_GT(far.measured("far_plane"), 0);
    EXPECT_GT(far.measured("missing"), 1000);
    // A caster that the light's near cuts: nothing is missing, but the shadow is.
    const DrawnCase light(text, with(small, {"light.near=1.7", "light.far=20"}));
    EXPECT_GT(light.measured("near_plane"), 0);
    EXPECT_NE(light.line("near_plane").find("the light's window"), std::string::npos);
}

// A ball 0.3 before a lamp whose wall is 400 away.
TEST(FrameWarnings, ALampsFittedNearPlaneThatCutsIsReported) {
    const DrawnCase lamp(
        "[observer]\nprojection = \"perspective\"\nelevation = 20\ntarget = [0, 2, -10]\n"
        "extent = 12\ndistance = 30\nnear = 1\nfar = 1200\n"
        "[light]\nkind = \"point\"\nposition = [0, 3, 0]\ntarget = [0, 3, -1]\n"
        "[[sphere]]\ncentre = [0, 3.0, -0.3]\nradius = 0.05\n"
        "[[plane]]\norigin = [-400, 0, -400]\nu = [800, 0, 0]\nv = [0, 400, 0]\n", small);
    EXPECT_EQ(lamp.measured("near_plane"), 32);
    EXPECT_NE(lamp.line("near_plane").find("set light.near = 0.24"), std::string::npos)
        << lamp.line("near_plane");
}

// What is beside the window is not cut, though its control points are nearer than near.
TEST(CutDepths, WhatTheWindowDoesNotShowIsNotCut) {
    const LoadedScene scene = parse_scene(
        "[observer]\nprojection = \"perspective\"\ntarget = [0, 0, 0]\nextent = 1\ndistance = 10\n"
        "near = 5\nfar = 200\n[light]\nazimuth = 0\n"
        "[[plane]]\norigin = [-50, -1, 50]\nu = [100, 0, 0]\nv = [0, 0, -100]\n", "a", {});
    EXPECT_FALSE(cut_depths(scene.observer, scene.patches).any());  // shown from depth 10 on
    raster::View view = scene.observer;
    view.near_depth = 12 << 16;
    view.far_depth = 50 << 16;
    const CutDepths cut = cut_depths(view, scene.patches);
    EXPECT_EQ(cut.before, 1u);
    EXPECT_EQ(cut.behind, 1u);
    EXPECT_NEAR(cut.nearest, 10, 4);   // within a 32nd of the patch: 100 / 32
    EXPECT_GE(cut.nearest, 10);
    EXPECT_DOUBLE_EQ(cut.farthest, 60);
}

TEST(FrameWarnings, DroppedBlocksAreReported) {
    const DrawnCase dropped(
        "[observer]\ntarget = [0, 0, 0]\nextent = 0.0000152587890625\n"
        "[light]\nazimuth = 30\ntarget = [0, 0, 0]\nextent = 2\n"
        "[[plane]]\norigin = [-16000, -16000, 0]\nu = [32000, 0, 0]\nv = [0, 32000, 3000]\n",
        small);
    EXPECT_GT(dropped.measured("dropped_blocks"), 0);
    EXPECT_GT(dropped.measured("missing"), 0);
    EXPECT_EQ(print(*dropped.report).find(" 0.00 %"), std::string::npos) << print(*dropped.report);
}

TEST(FrameWarnings, NothingVisibleIsReported) {
    const DrawnCase tiny(std::string("[observer]\nextent = 30000\ntarget = [0, 0, 0]\n") +
                         left_light + test::table_with_two_balls,
                         with(small, {"observer.target=[9000, 9000, 0]", "observer.extent=5"}));
    EXPECT_EQ(tiny.measured("nothing_visible"), 0);
    EXPECT_NE(print(*tiny.report).find("error       false shadow n/a, false light n/a;"),
              std::string::npos);
    EXPECT_TRUE(to_json(tiny.report)["false_shadow"].is_null());
}

// One far point makes the words of all others coarse.
TEST(FrameWarnings, CrushedObjectWordsAreReported) {
    const std::string text = std::string("[observer]\ntarget = [0, 0, 0]\nextent = 2\n") +
                             left_light + "target = [0, 0, 0]\nextent = 2\n" +
                             "[[sphere]]\ncentre = [0, 0, 0]\nradius = 0.7\n";
    EXPECT_EQ(DrawnCase(text, small).keys(), Texts{});
    const DrawnCase far(text + "[[sphere]]\ncentre = [32000, 0, 0]\nradius = 0.7\n", small);
    EXPECT_EQ(far.measured("object_words"), 64);  // a step of 1 unit; a pixel is 1/64
    const Coverage& c = *far.report->coverage;
    EXPECT_FALSE(c.complete());
    // The picture's whole error counts what no rate of the shadow counts.
    EXPECT_GE(far.report->wrong_pixels, c.missing + c.extra + c.misplaced);
    EXPECT_EQ(far.report->wrong_share(),
              double(far.report->wrong_pixels) / (c.seen + c.extra));
    EXPECT_NE(print(*far.report).find("% of all pixels are missing, extra, misplaced"),
              std::string::npos);
}

// Without recentring the translation of 100 units takes the rotation's bits.
TEST(FrameWarnings, ARotationWithoutItsBitsIsReported) {
    const std::string text =
        "[observer]\nazimuth = 15\nelevation = 30\n[light]\nazimuth = -100\nelevation = 20\n"
        "[[sphere]]\ncentre = [100, 100.8, 100]\nradius = 0.5\n"
        "[[sphere]]\ncentre = [100.9, 100.3, 100.2]\nradius = 0.3\n"
        "[[plane]]\norigin = [98, 100, 102]\nu = [4, 0, 0]\nv = [0, 0, -4]\n";
    const Texts off{"observer.recentre=off", "bias=1.5"};
    const DrawnCase narrow(text, off);
    EXPECT_GT(narrow.measured("view_matrix"), 0.25);
    EXPECT_GT(narrow.report->all.false_shadow_rate(), 0.5);
    const DrawnCase wide(text, with(off, {"coefficient_bits=24"}));
    EXPECT_EQ(wide.line("view_matrix"), "");
    EXPECT_LT(wide.report->all.false_shadow_rate(), 0.01);
    const DrawnCase recentred(text, {"bias=1.5"});
    EXPECT_EQ(recentred.keys(), Texts{});
    EXPECT_LT(recentred.report->all.false_shadow_rate(), 0.01);
}

TEST(FrameWarnings, DepthsWithoutOrderAreReported) {
    const DrawnCase deep(std::string(test::perspective_observer) +
                             "near = 0.0001\nfar = 30000\n" + test::near_lamp +
                             test::table_with_two_balls, small);
    EXPECT_GT(deep.measured("depth_order"), 100);
    EXPECT_NE(deep.line("depth_order").find("or leave both out"), std::string::npos);
    const DrawnCase light(std::string(left_light) + "near = -30000\nfar = 30000\n" +
                          test::table_with_two_balls, small);
    EXPECT_GT(light.measured("depth_order"), 4);
}

TEST(FrameWarnings, ABiasAboveFourTexelsIsReported) {
    const std::string text = test::first_natural_scene();
    const DrawnCase five(text, with(small, {"bias=5"}));
    EXPECT_NEAR(five.measured("bias"), 5, 0.01);
    EXPECT_NE(five.line("bias").find("set bias = 2 and bias_unit = \"texels\""),
              std::string::npos);
    EXPECT_EQ(DrawnCase(text, with(small, {"bias=4"})).line("bias"), "");
}

TEST(FrameWarnings, AreJsonWithKeyFigureAndLine) {
    const Warnings warnings{{"bias", 5, "the bias"}};
    EXPECT_EQ(to_json(warnings).dump(),
              R"([{"key":"bias","measured":5.0,"line":"the bias"}])");
}

}  // namespace
}  // namespace umbra78::tools
