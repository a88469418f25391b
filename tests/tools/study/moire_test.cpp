// The moire study: the beat is where the two grids put it; good and bad dither are distinguished.
#include "tests/tools/study/study_cases.hpp"
#include "tools/cli/study_list.hpp"
#include "tools/study/moire/report.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace umbra78::tools::study {
namespace {

Case drawn(const char* lookup, const char* dither, const char* size,
           const char* noise = "machine") {
    return {"",
            {"bias_unit=texels", "bias=0.5", std::string("lookup=") + lookup,
             std::string("dither=") + dither, std::string("dither_size=") + size},
            {{"ground", "plane"}, {"noise", noise}}};
}

Row measured(const Case& c) {
    static const auto study = make_moire_study();
    Row row = figures_of(*study, small_sphere(), c);
    row.set("ground", std::string("plane"));
    return row;
}

// 0.7 texels a pixel beat as -0.3: the pattern runs backwards.
TEST(GridBeat, FollowsFromTheTwoGrids) {
    GridBeat beat{{0.7, 0.1}, {0.05, 1.2}, 3, 1};
    EXPECT_NEAR(beat.predicted().u, -0.3, 1e-12);
    EXPECT_NEAR(beat.predicted().v, 0.1, 1e-12);
    beat.zv = -4;  // the steeper axis now is Y
    EXPECT_NEAR(beat.predicted().u, 0.05, 1e-12);
    EXPECT_NEAR(beat.predicted().v, 0.2, 1e-12);
    const Harmonic sum = harmonic_at(beat, aliased({0.75, 1.3}), 1e-9);
    EXPECT_EQ(sum.k, 1);
    EXPECT_EQ(sum.l, 1);
    EXPECT_EQ(harmonic_at(beat, {0.31, 0.41}, 1e-9).k, 0) << "none";
}

TEST(GridBeat, OfThePlaneIsWhereItsSpectrumPeaks) {
    const Row row = measured(drawn("nearest", "none", "1"));
    EXPECT_GT(row.number("peak_over_mean"), 1000);
    EXPECT_EQ(row.number("harmonic_k"), 1);
    EXPECT_EQ(row.number("harmonic_l"), 0);
    const double off = distance({row.number("peak_u"), row.number("peak_v")},
                                {row.number("beat_u"), row.number("beat_v")});
    EXPECT_LT(off, 1.0 / 256) << "a bin of the window";
    EXPECT_NEAR(row.number("beat_period_px"), 2.414, 0.002);
    EXPECT_EQ(verdict(row), "pattern");
}

// With bilinear lookup a texel of dither is noise; with nearest lookup none is.
TEST(MoireStudy, TellsThePlanesNoiseFromItsPattern) {
    EXPECT_EQ(verdict(measured(drawn("bilinear", "uniform", "1"))), "noise");
    EXPECT_EQ(verdict(measured(drawn("bilinear", "triangular", "1"))), "noise");
    EXPECT_EQ(verdict(measured(drawn("bilinear", "none", "1"))), "too few errors");
    EXPECT_EQ(verdict(measured(drawn("nearest", "normal", "1"))), "pattern");
}

TEST(MoireStudy, ControlsFail) {
    EXPECT_EQ(verdict(measured(drawn("nearest", "uniform", "0.25"))), "pattern");
    EXPECT_EQ(verdict(measured(drawn("nearest", "normal", "0.25"))), "pattern");
    EXPECT_EQ(verdict(measured(drawn("nearest", "uniform", "1", "restarted rows"))), "pattern");
    EXPECT_EQ(verdict(measured(drawn("bilinear", "uniform", "1", "restarted rows"))), "pattern");
}

// Without dither a restarted generator changes nothing: the copy in the study is the post-process.
TEST(MoireStudy, TheRestartedMaskIsTheMachinesButForItsNoise) {
    const LoadedScene scene = small_sphere().scene;
    for (const auto shape : {hw::DitherShape::none, hw::DitherShape::uniform}) {
        shadow::Settings settings = scene.settings;
        settings.dither.shape = shape;
        RenderJob job(scene.view(), settings);
        draw_mask(job);
        EXPECT_EQ(std::ranges::equal(mask_with_restarted_rows(job), job.bytes(Plane::mask)),
                  shape == hw::DitherShape::none);
    }
}

TEST(SpectrumPicture, IsWhiteAtTheHighestBinAndDarkFarBelow) {
    const int n = 16;
    std::vector<double> power(n * n, 1e-9);
    power[3 * n + 5] = 7;
    power[2 * n + 6] = 0.07;
    const auto gray = spectrum_picture(power, n);
    EXPECT_EQ(gray[(3 + n / 2) * n + 5 + n / 2], 255);
    EXPECT_EQ(gray[(2 + n / 2) * n + 6 + n / 2], 128) << "two of four decades below";
    EXPECT_EQ(gray[0], 0);
    EXPECT_EQ(spectrum_picture(std::vector<double>(64), 8), std::vector<std::uint8_t>(64));
}

TEST(Verdict, OfTheScenesSurfacesIsByFlatness) {
    const auto of = [](double flatness, int windows) {
        return verdict(row_with({{"ground", std::string("scene")},
                                 {"flatness", flatness},
                                 {"windows", std::int64_t{windows}}}));
    };
    EXPECT_EQ(of(0.36, 40), "pattern");
    EXPECT_EQ(of(0.56, 40), "noise");
    EXPECT_EQ(of(0.50, 40), "between");
    EXPECT_EQ(of(0.56, 9), "too few errors");
    EXPECT_EQ(of(std::nan(""), 0), "too few errors");
}

}  // namespace
}  // namespace umbra78::tools::study
