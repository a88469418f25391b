// The study of contours: roughness of lines that are known, small shadows, the knee, and that the
// paper's figure 5 has the passes that the study chooses.
#include "tests/support/effort.hpp"
#include "tests/tools/study/study_cases.hpp"
#include "tools/cli/study_list.hpp"
#include "tools/study/contours/contours.hpp"
#include "tools/study/contours/roughness.hpp"
#include "tools/study/contours/small_shadows.hpp"
#include "tools/study/inputs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace umbra78::tools::study {
namespace {

constexpr int drawn_size = 256;

// Down the middle of the picture, with the shadow on the right hand, which is the left side.
const std::vector<ShadowEdge> straight_edge{{EdgeKind::cast, {{128, 16}, {128, 240}}}};

// Beside it by away(row), from row 16 to row 240.
template <class Away>
Roughness roughness_of(Away away) {
    Contour line;
    for (double row = 16; row <= 240; row += 0.25) line.push_back({128 + away(row), row});
    return roughness(straight_edge, std::vector<Contour>{line}, drawn_size);
}

TEST(Roughness, OfTheExactEdgeIsNone) {
    const EdgeRoughness r = roughness_of([](double) { return 0.0; })[EdgeKind::cast];
    EXPECT_DOUBLE_EQ(r.exact_px, 224);
    EXPECT_NEAR(r.length_ratio, 1, 1e-12);
    EXPECT_NEAR(r.rms_px, 0, 1e-9);
    EXPECT_NEAR(r.displacement_px, 0, 1e-12);
}

TEST(Roughness, OfADisplacedAndTurnedLineIsNone) {
    const EdgeRoughness r =
        roughness_of([](double row) { return 3 + 0.01 * (row - 128); })[EdgeKind::cast];
    EXPECT_NEAR(r.rms_px, 0, 1e-6);
    // Going down, the right hand is the left side of the picture: a larger column is lit.
    EXPECT_NEAR(r.displacement_px, 3, 1e-3);
    EXPECT_NEAR(r.max_px, 3 + 1.12, 1e-2);
}

TEST(Roughness, OfAWaveIsItsRms) {
    const double amplitude = 0.5;
    const EdgeRoughness r = roughness_of([&](double row) {
        return amplitude * std::sin(row * 2 * std::numbers::pi / 4);
    })[EdgeKind::cast];
    EXPECT_NEAR(r.rms_px, amplitude / std::sqrt(2), 0.05);
    EXPECT_NEAR(r.length_ratio, 1.14, 0.02);  // of sin with slope 0.785
    EXPECT_NEAR(r.displacement_px, 0, 0.01);
}

TEST(Roughness, WhatIsFarFromEveryEdgeIsStray) {
    const Roughness r = roughness_of([](double row) { return row > 128 ? 40.0 : 0.0; });
    EXPECT_NEAR(r.stray_px, 112, 20);
    EXPECT_LT(r[EdgeKind::cast].length_ratio, 0.7);
    EXPECT_EQ(r[EdgeKind::self].exact_px, 0);
}

TEST(SmallShadows, LoseNothingUnfilteredAndMoreWithEachPass) {
    for (const SmallShadow shape : {SmallShadow::bar, SmallShadow::spot})
        for (const double width : {2, 4, 8}) {
            EXPECT_EQ(lost_area(shape, width, {0, 0}), 0);
            double before = 0;
            for (int passes = 1; passes <= 8; ++passes) {
                const double lost = lost_area(shape, width, {0, passes});
                EXPECT_GE(lost, before - 0.02) << width << " px, " << passes << " passes";
                before = lost;
            }
        }
    EXPECT_EQ(lost_area(SmallShadow::bar, 2, {0, 8}), 1) << "no pixel of it is half dark any more";
    EXPECT_LT(lost_area(SmallShadow::bar, 8, {6, 8}), 0.1);
    EXPECT_GT(lost_area(SmallShadow::spot, 4, {6, 0}), lost_area(SmallShadow::spot, 4, {1, 0}));
}

TEST(Knee, IsFarthestBelowTheLine) {
    const std::vector<PassesAndError> all{{0, 0, 10}, {1, 0, 0.1}, {0, 1, 0.1},  // one filter only
                                          {1, 1, 3},  {2, 1, 2.5}, {1, 2, 2}, {1, 3, 1.9},
                                          {2, 2, 1.95}, {3, 3, 1.5}, {4, 3, 1.6}};
    const auto least = least_by_passes(all);
    ASSERT_EQ(least.size(), 6u);
    EXPECT_EQ(least[2].low_pass, 2);
    EXPECT_EQ(least[3].error, 1.9);
    // x 2/6 and 3/6, y 1.5/8.5 and 0.5/8.5: 0.490 and 0.441 below.
    const auto knee = knee_of_passes(least);
    ASSERT_TRUE(knee);
    EXPECT_EQ(std::pair(knee->dequantize, knee->low_pass), std::pair(1, 1));
    EXPECT_FALSE(knee_of_passes(std::span(least).first(2)));
}

TEST(Knee, OfTwoThatAreEqualIsTheSmoother) {
    const std::vector<PassesAndError> least{{0, 0, 10}, {1, 1, 2}, {1, 2, 1.01}, {5, 5, 0}};
    EXPECT_EQ(knee_of_passes(least)->low_pass, 2);  // 0.6 and 0.599
    const std::vector<PassesAndError> other{{0, 0, 10}, {1, 1, 2}, {1, 2, 1.2}, {5, 5, 0}};
    EXPECT_EQ(knee_of_passes(other)->low_pass, 1);  // 0.6 and 0.58
}

const Study& contours_study() { return study_of("contours", "", studies()); }

// The figures' scene: what the study chooses from all passes is what figures.toml asks for.
TEST(ContoursStudy, FigureFiveHasThePassesAtTheKnee) {
    if (umbra78::test::sanitized) GTEST_SKIP() << "the scene is drawn 28 times";
    Request request;
    request.scene_file = "figures.toml";
    request.scene = scene_of(request, {});
    std::vector<PassesAndError> kept;
    for (int d = 0; d <= 6; ++d)
        for (int p = 0; p <= 4; ++p) {
            double lost[3];
            for (std::size_t k = 0; k < 3; ++k)
                lost[k] = lost_area(SmallShadow::bar, width_limits[k].width_px, {d, p});
            if (lost[0] > width_limits[0].max_lost || lost[1] > width_limits[1].max_lost ||
                lost[2] > width_limits[2].max_lost)
                continue;
            Case c;
            c.set = {"dequantize=" + std::to_string(d), "low_pass=" + std::to_string(p)};
            c.extra = {{"measured", "edges"}};
            const Row row = figures_of(contours_study(), request, c);
            kept.push_back({d, p, row.number("self_rough_px")});
        }
    EXPECT_EQ(kept.size(), 28u) << "four passes of low-pass take a bar of 2 pixels";
    const auto knee = knee_of_passes(least_by_passes(kept));
    ASSERT_TRUE(knee);
    EXPECT_EQ(knee->dequantize, request.scene.settings.dequantize_passes);
    EXPECT_EQ(knee->low_pass, request.scene.settings.low_pass_passes);
}

TEST(ContoursStudy, ASmallShadowsCaseDrawsNoScene) {
    const Request request = small_sphere();
    Case c;
    c.set = {"dequantize=2", "low_pass=2"};
    c.extra = {{"measured", "small"}};
    const Row row = figures_of(contours_study(), request, c);
    EXPECT_FALSE(row.has("self_rough_px"));
    EXPECT_NEAR(row.number("lost_bar_2"), lost_area(SmallShadow::bar, 2, {2, 2}), 0);
}

}  // namespace
}  // namespace umbra78::tools::study
