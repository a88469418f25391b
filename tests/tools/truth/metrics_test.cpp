// The measures on inputs whose answer is known, and negative controls: the measures must tell bad
// dithers from a good one.
#include "tools/truth/metrics.hpp"

#include "tests/tools/truth/half_lit.hpp"
#include "tests/tools/truth/images.hpp"
#include "tools/truth/edge_bands.hpp"
#include "tools/truth/spectrum.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace umbra78::tools {
namespace {

using test::Image, test::image, test::pi, test::seed, test::Uniform;
using test::Bytes, test::half_lit, test::shadow_from, test::total;

LocalFlatness flatness(const Image& error, int size) {
    return median_local_flatness(error, size, Bytes(error.size(), 1));
}

TEST(ShadowError, AShiftedMaskGivesItsShift) {
    const Truth truth = half_lit(40, 20);
    const Bytes later = shadow_from(40, 23), sooner = shadow_from(40, 18);
    EXPECT_EQ(shadow_error(truth, {later, {}}).false_light, 3 * 40);
    EXPECT_EQ(shadow_error(truth, {later, {}}).false_shadow, 0);
    EXPECT_EQ(shadow_error(truth, {sooner, {}}).false_shadow, 2 * 40);
    EXPECT_DOUBLE_EQ(shadow_error(truth, {sooner, {}}).false_shadow_rate(), 0.1);
    EXPECT_DOUBLE_EQ(shadow_error(truth, {later, {}}).false_light_rate(), 0.15);

    for (const int radius : {0, 1, 2, 3, 4}) {
        const Bytes band = edge_band(truth, radius);
        EXPECT_EQ(total(band), 2 * radius * 40);
        const int left = std::max(3 - radius, 0) * 40;
        EXPECT_EQ(shadow_error(truth, {later, {}}, band).false_light, left);
    }
}

// By hand: four lit pixels at 0, 5, 6 and 255, four in shadow at 255, 250, 249 and 128.
TEST(GradedError, IsInTheLightThatIsSeen) {
    const Truth truth = half_lit(4, 2);
    Bytes mask(16, 0), drawn(16, 0);
    int lit = 0, umbra = 0;
    const int of_lit[] = {0, 5, 6, 255}, of_umbra[] = {255, 250, 249, 128};
    for (std::size_t at = 0; at < 16; ++at) {
        int& n = truth.lit[at] ? lit : umbra;
        if (n == 4) continue;
        mask[at] = static_cast<std::uint8_t>((truth.lit[at] ? of_lit : of_umbra)[n++]);
        drawn[at] = 1;
    }
    ASSERT_EQ(lit + umbra, 8);
    const GradedError error = graded_error(truth, {mask, drawn});
    EXPECT_EQ(error.lit, 4);
    EXPECT_EQ(error.umbra, 4);
    EXPECT_EQ(error.absolute, 5u + 6 + 255 + 5 + 6 + 127);
    EXPECT_EQ(error.squares, 25u + 36 + 65025 + 25 + 36 + 16129);
    EXPECT_EQ(error.lit_below_98, 2) << "5 / 255 is 1.96 %, 6 / 255 is 2.35 %";
    EXPECT_EQ(error.umbra_above_2, 2);
    EXPECT_EQ(error.between, 5);
    EXPECT_TRUE(error.graded());
    EXPECT_DOUBLE_EQ(error.mean_absolute(), 404 / 255.0 / 8);
    EXPECT_DOUBLE_EQ(error.rms(), std::sqrt(81276 / 8.0) / 255);
    EXPECT_DOUBLE_EQ(error.lit_below_98_rate(), 0.5);
    EXPECT_DOUBLE_EQ(error.umbra_above_2_rate(), 0.5);
}

// Of a binary mask the mean error is the share of wrong pixels, and the other two are its rates.
TEST(GradedError, OfABinaryMaskIsItsRates) {
    const Truth truth = half_lit(40, 20);
    const Bytes sooner = shadow_from(40, 18);
    const GradedError graded = graded_error(truth, {sooner, {}});
    const ShadowError binary = shadow_error(truth, {sooner, {}});
    EXPECT_FALSE(graded.graded());
    EXPECT_DOUBLE_EQ(graded.mean_absolute(), 2.0 / 40);
    EXPECT_DOUBLE_EQ(graded.rms(), std::sqrt(2.0 / 40));
    EXPECT_DOUBLE_EQ(graded.lit_below_98_rate(), binary.false_shadow_rate());
    EXPECT_DOUBLE_EQ(graded.umbra_above_2_rate(), binary.false_light_rate());
    EXPECT_EQ(graded_error({}, {}).mean_absolute(), 0);
    EXPECT_EQ(graded_error({}, {}).rms(), 0);
}

TEST(ShadowError, CountsOnlyWhatBothSee) {
    const Truth truth = half_lit(8, 4);
    Bytes drawn(64, 0);
    drawn[0] = drawn[7] = 1;
    const ShadowError error = shadow_error(truth, {Bytes(64, 128), drawn});
    EXPECT_EQ(error.lit, 1);
    EXPECT_EQ(error.shadowed, 1);
    EXPECT_EQ(error.false_shadow, 1);  // 128 is shadow, 127 is not
    EXPECT_EQ(shadow_error(truth, {Bytes(64, 127), drawn}).false_light, 1);
    EXPECT_EQ(shadow_error(truth, {Bytes(64, 127), drawn, 100}).false_light, 0);
    EXPECT_EQ(shadow_error({}, {}).false_shadow_rate(), 0);
    EXPECT_DEATH(shadow_error(truth, {Bytes(63), {}}), "");
}

TEST(ShadowError, AnIsolatedPixelAgreesWithNoNeighbour) {
    Bytes mask(100, 0);
    EXPECT_EQ(isolated_pixels({mask, {}}, 10), 0);
    mask[33] = 255;
    EXPECT_EQ(isolated_pixels({mask, {}}, 10), 1);
    mask[34] = 255;
    EXPECT_EQ(isolated_pixels({mask, {}}, 10), 0);
    for (int at = 0; at < 100; ++at) mask[at] = (at + at / 10) % 2 ? 255 : 0;
    EXPECT_EQ(isolated_pixels({mask, {}}, 10), 100);
    Bytes drawn(100, 0);
    drawn[50] = 1;  // alone: there is none to disagree with
    EXPECT_EQ(isolated_pixels({mask, drawn}, 10), 0);
}

TEST(Flatness, OfWhiteNoiseIsExpOfMinusGammaAndMoreIfSparse) {
    Uniform uniform;
    const auto white = [&](double density) {
        return flatness(image(512, [&](int, int) { return uniform() < density; }), 512);
    };
    EXPECT_EQ(white(0.5).windows, 31 * 31);
    EXPECT_NEAR(white(0.5).median, 0.5615, 0.01) << "seed " << seed;
    EXPECT_NEAR(white(0.1).median, 0.568, 0.01) << "seed " << seed;
    EXPECT_NEAR(white(0.02).median, 0.592, 0.01) << "seed " << seed;
}

TEST(Flatness, OfWhatRepeatsIsLow) {
    const auto grating = [](int x, int y) { return std::sin(0.9 * x + 0.4 * y) > 0 ? 1.0 : 0.0; };
    EXPECT_LT(flatness(image(256, grating), 256).median, 0.1);
    const auto chirp = [](int x, int y) {
        return std::sin(0.004 * x * x + 0.003 * y * y) > 0 ? 1.0 : 0.0;
    };
    EXPECT_LT(flatness(image(256, chirp), 256).median, 0.48);
}

TEST(Flatness, LeavesOutWindowsThatSayNothing) {
    Uniform uniform;
    const Image noise = image(64, [&](int, int) { return uniform() < 0.5; });
    Bytes valid(noise.size(), 1);
    EXPECT_EQ(median_local_flatness(noise, 64, valid).windows, 9);
    valid[0] = 0;
    EXPECT_EQ(median_local_flatness(noise, 64, valid).windows, 8);
    EXPECT_EQ(median_local_flatness(noise, 64, valid, {.min_valid = 0.9}).windows, 9);
    EXPECT_EQ(flatness(Image(64 * 64, 0.0), 64).windows, 0);
    EXPECT_EQ(flatness(image(64, [](int x, int y) { return x < 15 && y < 1; }), 64).windows, 0);
    EXPECT_EQ(spectral_flatness(Image(32 * 32, 3.0), 32), 0);
}

// A wedge's height in quanta is rounded after dither; the error of the compare "was it rounded
// up?" is what a shadow test sees.
Image dithered_wedge(const std::function<double(int, int)>& dither) {
    return image(256, [&](int x, int y) {
        const double height = 0.37 * x + 0.19 * y;
        return std::floor(height + 0.5 + dither(x, y)) > height ? 1.0 : 0.0;
    });
}

TEST(Flatness, TellsGoodDitherFromBad) {
    Uniform uniform;
    const auto score = [](const std::function<double(int, int)>& dither) {
        return flatness(dithered_wedge(dither), 256).median;
    };
    const auto uniform_over = [&](double quanta) {
        return [&uniform, quanta](int, int) { return quanta * (uniform() - 0.5); };
    };
    EXPECT_GT(score(uniform_over(2)), 0.53) << "seed " << seed;
    EXPECT_LT(score(uniform_over(0)), 0.1);
    EXPECT_LT(score(uniform_over(0.25)), 0.48) << "seed " << seed;

    // A generator that starts every row in the same state.
    Image row;
    for (int x = 0; x < 256; ++x) row.push_back(2 * (uniform() - 0.5));
    EXPECT_LT(score([&](int x, int) { return row[x]; }), 0.48) << "seed " << seed;
}

TEST(Periodogram, AGratingPeaksAtItsFrequency) {
    const int n = 64;
    const Image grating =
        image(n, [](int x, int y) { return std::cos(2 * pi * (5 * x + 11 * y) / n); });
    const auto power = periodogram(grating, n);
    const auto peak = std::max_element(power.begin(), power.end()) - power.begin();
    EXPECT_TRUE(peak == 11 * n + 5 || peak == (n - 11) * n + n - 5) << peak;
    EXPECT_GT(peak_over_mean(grating, n), 500);
    // Against the definition, at one bin, of a window that is neither even nor odd.
    const Image window = image(8, [](int x, int y) { return x * x + 3 * y + x * y % 5; });
    double mean = 0, real = 0, imaginary = 0;
    for (const double value : window) mean += value / 64;
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x) {
            const auto hann = [](int i) { return std::pow(std::sin(pi * (i + 0.5) / 8), 2); };
            const double value = (window[y * 8 + x] - mean) * hann(x) * hann(y);
            real += value * std::cos(2 * pi * (3 * x + 6 * y) / 8);
            imaginary += value * std::sin(2 * pi * (3 * x + 6 * y) / 8);
        }
    const auto small = periodogram(window, 8);
    EXPECT_NEAR(small[6 * 8 + 3], real * real + imaginary * imaginary, 1e-9);
    EXPECT_NEAR(small[2 * 8 + 5], small[6 * 8 + 3], 1e-9);
}

TEST(Periodogram, OfWhiteNoisePeaksAtLogOfTheCells) {
    Uniform uniform;
    const Image noise = image(256, [&](int, int) { return uniform(); });
    EXPECT_NEAR(peak_over_mean(noise, 256), std::log(256 * 256), 3) << "seed " << seed;
    EXPECT_NEAR(spectral_flatness(noise, 256), 0.5615, 0.01) << "seed " << seed;
}

TEST(Profile, RunsFromTheLimbToTheShadowLineOnEitherSide) {
    const int size = 256;
    const TruthScene scene{{{{0, 0, 0}, 1.0}}, {}};
    const TruthView view{false, {}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, 1.1, 0, -2, 2, size};
    for (const double degrees : {-100.0, 100.0, -150.0}) {
        const double angle = degrees * pi / 180, side = degrees < 0 ? -1 : 1;
        const TruthLight light{false, {std::sin(angle), 0, std::cos(angle)}, {}};
        const Truth truth = trace(scene, view, light);
        Bytes mask(size * size);
        const double line = std::abs(angle) - pi / 2, half_way = (line + pi / 2) / 2;
        for (std::size_t at = 0; at < mask.size(); ++at)  // false shadow on the line's half
            mask[at] = side * std::atan2(truth.position[at][0], truth.position[at][2]) < half_way
                           ? 255 : 0;
        const auto profile = limb_to_line_profile(truth, {mask, {}}, scene, 0, view, light, 4);
        int lit = 0;
        for (int bin = 0; bin < 4; ++bin) {
            EXPECT_GT(profile[bin].lit, 100) << degrees;
            EXPECT_EQ(profile[bin].false_shadow_rate(), bin < 2 ? 0 : 1) << degrees << " " << bin;
            lit += profile[bin].lit;
        }
        EXPECT_EQ(lit, std::count(truth.lit.begin(), truth.lit.end(), 1));
    }
}

}  // namespace
}  // namespace umbra78::tools
