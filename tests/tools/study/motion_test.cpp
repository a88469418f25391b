// The study of motion: the frames of a sequence, flips counted by hand, and what snapping does.
#include "tests/tools/study/study_cases.hpp"
#include "tools/cli/study_list.hpp"
#include "tools/study/motion/picture.hpp"
#include "tools/study/strip.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace umbra78::tools::study {
namespace {

// Two spheres, one in the other's shadow; the middle of the light's window is no texel's corner.
Request two_spheres(const std::string& light_target = "[0.1, 0.05, 0]") {
    return request_of("[light]\nazimuth = -70\nelevation = 10\nextent = 3\ntarget = " +
                      light_target + R"(
near = -4
far = 4

[observer]
extent = 2
target = [0, 0, 0]

[[sphere]]
centre = [0.3, 0, 0]
radius = 1

[[sphere]]
centre = [-1.4, 0.3, 0.4]
radius = 0.5

[settings]
xy_bits = 7
bias    = 192
bias_unit = "quanta"
lookup  = "nearest"
)");
}

MotionSeen seen(const Request& request, const MotionCase& c) {
    const TruthCache truths;
    return see_motion(request.scene, c, truths);
}

double mean_flicker(const MotionSeen& seen) {
    double sum = 0;
    for (const Flips& f : seen.compared) sum += f.share(f.flicker());
    return sum / static_cast<double>(seen.compared.size());
}

TEST(MotionFrame, TheFirstIsTheSceneItself) {
    const Request request = two_spheres();
    for (const Motion motion : {Motion::light_turns, Motion::observer_turns, Motion::light_moves,
                                Motion::observer_moves}) {
        const LoadedScene first = motion_frame(request.scene, {motion, false, true, 2}, 0);
        EXPECT_EQ(truth_key(first), truth_key(request.scene));
        EXPECT_EQ(first.settings.dither.seed, request.scene.settings.dither.seed);
    }
}

// Frame 7 is what the scene file with the azimuth of frame 7 says.
TEST(MotionFrame, TurnsByATenthOfADegree) {
    const Request request = two_spheres();
    const auto turned = [&](const char* key, Motion motion) {
        Case c;
        c.set = {key};
        EXPECT_EQ(truth_key(motion_frame(request.scene, {motion, false, false, 8}, 7)),
                  truth_key(scene_of(request, c)));
    };
    turned("light.azimuth=-69.3", Motion::light_turns);
    turned("observer.azimuth=0.7", Motion::observer_turns);
}

TEST(MotionFrame, MovesByAFractionOfAPixel) {
    const Request request = two_spheres();
    const double texel = 6.0 / 128, pixel = 4.0 / 128, word = std::ldexp(1, -16);
    const auto place = [](const raster::View& v, const raster::Axis& axis) {
        return std::ldexp(static_cast<double>(raster::along(axis, v.target)), -46);
    };
    const auto expect_moved = [&](Motion motion, int frame, auto view, double x, double y) {
        const LoadedScene moved = motion_frame(request.scene, {motion, false, false, 9}, frame);
        const raster::View &from = view(request.scene), &to = view(moved);
        EXPECT_NEAR(place(to, to.axes.right) - place(from, from.axes.right), x, 2 * word);
        EXPECT_NEAR(place(to, to.axes.up) - place(from, from.axes.up), y, 2 * word);
        EXPECT_NEAR(place(to, to.axes.back), place(from, from.axes.back), 2 * word);
    };
    const auto light = [](const LoadedScene& s) -> const raster::View& { return s.light(); };
    const auto observer = [](const LoadedScene& s) -> const raster::View& { return s.observer; };
    expect_moved(Motion::light_moves, 5, light, 5 * 0.3 * texel, 5 * 0.2 * texel);
    expect_moved(Motion::observer_moves, 5, observer, 5 * 0.3 * pixel, 5 * 0.2 * pixel);
    // The light's window is taken along: the two targets keep their distance.
    const LoadedScene moved =
        motion_frame(request.scene, {Motion::observer_moves, false, false, 9}, 8);
    EXPECT_NE(moved.light().target, request.scene.light().target);
    EXPECT_EQ(moved.light().target.x - request.scene.light().target.x,
              moved.observer.target.x - request.scene.observer.target.x);
    EXPECT_EQ(moved.light().target.y - request.scene.light().target.y,
              moved.observer.target.y - request.scene.observer.target.y);
}

TEST(MotionFrame, SnappingPutsTheOriginOnACorner) {
    const Request request = two_spheres();
    EXPECT_GT(off_corner_texels(request.scene), 0.1);
    for (const Motion motion : {Motion::light_turns, Motion::light_moves, Motion::observer_moves})
        for (int frame = 0; frame < 6; ++frame) {
            const LoadedScene scene = motion_frame(request.scene, {motion, true, false, 6}, frame);
            EXPECT_LT(off_corner_texels(scene), 0.001) << frame;  // 2 words of 2^-16 in 3/64
        }
}

TEST(MotionFrame, ALampCannotBeSnapped) {
    Request request = two_spheres();
    request.scene = parse_scene("[light]\nkind = \"point\"\nposition = [-3, 2, 4]\n"
                                "[[sphere]]\ncentre = [0, 0, 0]\nradius = 1\n", "lamp.toml", {});
    EXPECT_THROW(motion_frame(request.scene, {Motion::light_moves, true, false, 2}, 1), SceneError);
    const auto study = make_motion_study();
    for (const Case& c : study->cases(request)) EXPECT_FALSE(motion_case(c).snapped) << c.name;
    const LoadedScene a = motion_frame(request.scene, {Motion::light_turns, false, false, 2}, 0);
    const LoadedScene b = motion_frame(request.scene, {Motion::light_turns, false, false, 2}, 1);
    EXPECT_NE(truth_key(a), truth_key(b)) << "it goes about its target";
    EXPECT_EQ(a.light().distance, b.light().distance);
}

TEST(MotionFrame, RenewsTheSeedInEachFrame) {
    const Request request = two_spheres();
    std::vector<std::uint32_t> seeds;
    for (int frame = 0; frame < 100; ++frame) {
        const auto scene =
            motion_frame(request.scene, {Motion::light_turns, false, true, 100}, frame);
        seeds.push_back(scene.settings.dither.seed);
        EXPECT_GE(seeds.back(), 1u);
        EXPECT_LE(seeds.back(), 0x7fffffffu);
    }
    std::ranges::sort(seeds);
    EXPECT_EQ(std::ranges::adjacent_find(seeds), seeds.end());
}

// Eight pixels: background, the unlit side, and six that are compared.
TEST(Flips, AreRightfulOrFlicker) {
    const auto frame = [](std::vector<std::uint8_t> lit, std::vector<std::uint8_t> mask) {
        auto traced = std::make_shared<Traced>();
        traced->truth.truth.visible = {0, 1, 1, 1, 1, 1, 1, 1};
        traced->truth.unlit_side = {0, 1, 0, 0, 0, 0, 0, 0};
        traced->truth.truth.lit = std::move(lit);
        traced->band = {0, 0, 0, 0, 0, 1, 1, 1};
        return SeenFrame{traced, std::move(mask), std::vector<std::uint8_t>(8, 1)};
    };
    const SeenFrame before = frame({1, 1, 1, 1, 1, 1, 1, 0}, {0, 0, 0, 0, 0, 0, 0, 255});
    const SeenFrame after = frame({0, 0, 0, 1, 1, 0, 1, 1}, {255, 255, 255, 255, 0, 0, 128, 127});
    std::vector<int> flickers(8, 0);
    const Flips f = flips(before, after, flickers);
    EXPECT_EQ(f.compared, 6);
    EXPECT_EQ(f.truth, 3);     // pixels 2, 5, 7
    EXPECT_EQ(f.mask, 4);      // pixels 2, 3, 6, 7
    EXPECT_EQ(f.rightful, 2);  // pixels 2 and 7
    EXPECT_EQ(f.flicker(), 2);
    EXPECT_EQ(f.compared_outside, 3);
    EXPECT_EQ(f.flicker_outside, 1);
    EXPECT_EQ(flickers, (std::vector<int>{0, 0, 0, 1, 0, 0, 1, 0}));
    EXPECT_DOUBLE_EQ(f.share(f.flicker()), 2.0 / 6);
    EXPECT_EQ(Flips{}.share(0), 0);
}

// The window of a light at infinity slides: truth stands still. Snapped, the machine does, too,
// unless its noise is another in each frame.
TEST(MotionStudy, ASlidingWindowFlickersUnlessItIsSnapped) {
    Request request = two_spheres();
    const MotionSeen free = seen(request, {Motion::light_moves, false, false, 4});
    const MotionSeen snapped = seen(request, {Motion::light_moves, true, false, 4});
    for (const auto* each : {&free, &snapped})
        for (const Flips& f : each->compared) EXPECT_EQ(f.truth, 0);
    EXPECT_GT(mean_flicker(free), 0.01);
    EXPECT_LT(mean_flicker(snapped), 0.001);
    request.scene.settings.dither.shape = hw::DitherShape::normal;
    EXPECT_LT(mean_flicker(seen(request, {Motion::light_moves, true, false, 4})), 0.001);
    EXPECT_GT(mean_flicker(seen(request, {Motion::light_moves, true, true, 4})), 0.003);
}

// About an origin that is a corner already, snapping has nothing to take from a turn.
TEST(MotionStudy, SnappingDoesNotHelpATurningLight) {
    const Request request = two_spheres("[0, 0, 0]");
    const MotionSeen free = seen(request, {Motion::light_turns, false, false, 3});
    const MotionSeen snapped = seen(request, {Motion::light_turns, true, false, 3});
    EXPECT_GT(mean_flicker(free), 0.01);
    EXPECT_EQ(free.flickers, snapped.flickers);
    EXPECT_GT(free.compared[0].truth, 0);
}

TEST(MotionStudy, FixedNoiseFlickersLessThanRenewedNoise) {
    Request request = two_spheres();
    request.scene.settings.dither.shape = hw::DitherShape::normal;
    const double fixed = mean_flicker(seen(request, {Motion::observer_turns, false, false, 4}));
    const double renewed = mean_flicker(seen(request, {Motion::observer_turns, false, true, 4}));
    EXPECT_LT(fixed, renewed / 1.5);
}

TEST(MotionStudy, ItsCasesAreRun) {
    Request request = two_spheres();
    request.quick = true;
    const auto study = make_motion_study();
    const auto cases = study->cases(request);
    EXPECT_EQ(cases.size(), 7u * 4) << "the observer's turn is not snapped";
    const Row row = figures_of(*study, request, cases.front());
    EXPECT_EQ(motion_case(cases.front()).frames, 3);
    const auto steps = steps_of(row, "flicker_steps");
    ASSERT_EQ(steps.size(), 2u);
    EXPECT_NEAR((steps[0] + steps[1]) / 2, row.number("flicker_mean"), 1e-6);
    EXPECT_NEAR(std::max(steps[0], steps[1]), row.number("flicker_max"), 1e-6);
    EXPECT_NEAR(row.number("flips_mean") - row.number("rightful_mean"),
                row.number("flicker_mean"), 1e-12);
    EXPECT_GE(row.number("ever_flickered"), row.number("flicker_max"));
    EXPECT_EQ(row.number("missing_pixels"), 0);
    EXPECT_EQ(row.number("outside_light"), 0);
    request.quick = false;
    EXPECT_EQ(study->cases(request).size(), 7u * 12);
    request.vary = {{"lookup", {"percentage"}}, {"dither", {"none"}}};
    EXPECT_EQ(study->cases(request).size(), 7u * 2);
}

TEST(FlickerPicture, IsDarkerTheMoreOften) {
    MotionSeen of;
    of.size_px = 2;
    of.compared.resize(4);
    of.flickers = {0, 1, 4, 0};
    of.seen = {1, 1, 1, 0};
    const auto gray = flicker_picture(of);
    EXPECT_EQ(gray, (std::vector<std::uint8_t>{225, 120, 0, 255}));
    const Strip strip = side_by_side(std::vector{gray, gray}, 2);
    EXPECT_EQ(strip.width, 12);
    EXPECT_EQ(strip.gray[strip.width + 1], 255);
    EXPECT_EQ(strip.gray[strip.width + 10], 0);
    EXPECT_EQ(strip.gray[5], 128);
}

}  // namespace
}  // namespace umbra78::tools::study
