// Fisher's g, radial power, anisotropy and the peak's place, on inputs whose answer is known.
#include "tools/truth/spectrum_shape.hpp"

#include "tests/tools/truth/images.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace umbra78::tools {
namespace {

using test::Image, test::image, test::pi, test::Uniform;

Image white(int size, Uniform& uniform) {
    return image(size, [&](int, int) { return uniform() < 0.5; });
}

Image grating(int size, double u, double v) {
    return image(size, [&](int x, int y) { return std::cos(2 * pi * (u * x + v * y)); });
}

TEST(Frequency, FoldsIntoTheHalfPlane) {
    for (const Frequency f : {Frequency{0.3, 0.2}, {-0.3, -0.2}, {1.3, -2.8}, {-0.3, 0.8}}) {
        EXPECT_NEAR(aliased(f).u, 0.3, 1e-12);
        EXPECT_NEAR(aliased(f).v, 0.2, 1e-12);
    }
    EXPECT_NEAR((Frequency{0.03, 0.04}).period_px(), 20, 1e-12);
    EXPECT_TRUE(std::isinf(Frequency{}.period_px()));
    EXPECT_NEAR(distance({0.49, 0.1}, {-0.49, 0.1}), 0.02, 1e-12);
    EXPECT_NEAR(distance({0.49, 0.001}, {0.49, -0.001}), 0.002, 1e-12);
    EXPECT_NEAR(distance({0.2, 0.1}, {-0.2, -0.1}), 0, 1e-12);
}

TEST(HighestPeak, OfAGratingIsAtItsFrequency) {
    for (const Frequency f : {Frequency{5.0 / 64, 11.0 / 64}, {-20.0 / 64, 3.0 / 64},
                              {7.0 / 64, 0}, {0, 30.0 / 64}}) {
        const Peak peak = highest_peak(periodogram(grating(64, f.u, f.v), 64), 64);
        EXPECT_EQ(peak.at.u, f.u);
        EXPECT_EQ(peak.at.v, f.v);
        EXPECT_GT(peak.over_mean, 500);
    }
    EXPECT_EQ(highest_peak(periodogram(Image(64, 3.0), 8), 8).over_mean, 0);
}

// The 5 % points of R. A. Fisher's table, "Tests of significance in harmonic analysis" (1929).
TEST(Fisher, HasThePointsOfTheTable) {
    EXPECT_NEAR(fisher_p(0.68377, 5), 0.05, 1e-4);
    EXPECT_NEAR(fisher_p(0.44495, 10), 0.05, 1e-4);
    EXPECT_NEAR(fisher_p(0.27046, 20), 0.05, 1e-4);
    // One or two ordinates by hand: the only one's share is all; the greater of two is uniform.
    EXPECT_EQ(fisher_p(0.9, 1), 1);
    EXPECT_NEAR(fisher_p(0.75, 2), 0.5, 1e-12);
    // Of three: 3 (1 - g)^2 - 3 (1 - 2 g)^2.
    EXPECT_NEAR(fisher_p(0.4, 3), 0.96, 1e-12);
    EXPECT_EQ(fisher_p(0, 10), 1);
    EXPECT_EQ(fisher_p(1e-5, 32000), 1);
}

TEST(Fisher, RejectsAGratingAndAsManyNoisesAsItSays) {
    Uniform uniform;
    int below_tenth = 0;
    constexpr int runs = 200;
    for (int k = 0; k < runs; ++k) {
        const FisherTest test = fisher_test(white(32, uniform), 32);
        EXPECT_EQ(test.ordinates, (32 * 32 - 9 - 3) / 2);
        below_tenth += test.p < 0.1;
    }
    EXPECT_NEAR(below_tenth, 0.1 * runs, 4 * std::sqrt(runs * 0.09)) << "seed 1978";
    const FisherTest line = fisher_test(grating(64, 9.0 / 64, 4.0 / 64), 64);
    EXPECT_NEAR(line.g, 1, 1e-9);
    EXPECT_LT(line.p, 1e-100);
    // A weak line in noise: a tenth of its power.
    const Image weak = image(64, [&](int x, int y) {
        return uniform() - 0.5 + 0.13 * std::cos(2 * pi * (9 * x + 4 * y) / 64);
    });
    EXPECT_LT(fisher_test(weak, 64).p, 1e-6);
    EXPECT_EQ(fisher_test(Image(64, 1.0), 8).p, 1);
}

TEST(RadialPower, OfWhiteNoiseIsFlatAndAsAnisotropicAsItsSegments) {
    Uniform uniform;
    const int size = 512, n = 64;
    const Image noise = white(size, uniform);
    const SegmentedSpectrum mean =
        segmented_spectrum(noise, size, std::vector<std::uint8_t>(noise.size(), 1), n);
    EXPECT_EQ(mean.segments, 64);
    const RadialPower radial = radial_power(mean.power, n);
    ASSERT_EQ(radial.frequency.back(), 0.5);
    double db = 0;
    for (std::size_t k = 4; k < radial.power.size(); ++k) {
        EXPECT_NEAR(radial.power[k], 1, 0.1) << radial.frequency[k];
        db += radial.anisotropy_db[k] / static_cast<double>(radial.power.size() - 4);
    }
    EXPECT_NEAR(db, -10 * std::log10(64), 1) << "Ulichney: -10 log10 K";
}

TEST(RadialPower, ALineStandsOutOfItsRing) {
    const int n = 64;
    const RadialPower radial =
        radial_power(periodogram(grating(n, 12.0 / n, 16.0 / n), n, Taper::none), n);
    std::size_t highest = 0;
    for (std::size_t k = 0; k < radial.power.size(); ++k)
        if (radial.power[k] > radial.power[highest]) highest = k;
    EXPECT_EQ(radial.frequency[highest], 20.0 / n);
    // One of about pi * 20 bins of the half ring has it all.
    EXPECT_NEAR(radial.anisotropy_db[highest], 10 * std::log10(pi * 20), 0.5);
    EXPECT_GE(radial.max_anisotropy_db, radial.anisotropy_db[highest]);
}

TEST(RadialPower, HighPassNoiseRises) {
    Uniform uniform;
    const Image noise = white(129, uniform);
    const Image blue = image(128, [&](int x, int y) {
        return 2 * noise[y * 129 + x] - noise[y * 129 + x + 1] - noise[(y + 1) * 129 + x];
    });
    const RadialPower radial = radial_power(periodogram(blue, 128), 128);
    EXPECT_LT(radial.power[5], 0.05);
    EXPECT_GT(radial.power[60], 1.2);
}

TEST(SegmentedSpectrum, LeavesOutSegmentsWithAHole) {
    std::vector<std::uint8_t> valid(64 * 64, 1);
    valid[0] = 0;
    EXPECT_EQ(segmented_spectrum(Image(64 * 64, 1.0), 64, valid, 32).segments, 3);
    EXPECT_EQ(segmented_spectrum(Image(64 * 64, 1.0), 64, valid, 48).segments, 0);
    EXPECT_DEATH(cut_window(Image(64, 0.0), 8, 1, 0, 8), "");
    EXPECT_EQ(cut_window({{0, 1, 2, 3, 4, 5, 6, 7, 8}}, 3, 1, 1, 2), (Image{4, 5, 7, 8}));
}

// Transforms of every length are the definition's, with either taper.
TEST(Periodogram, IsTheDefinitionForEveryLength) {
    for (const int n : {1, 2, 3, 4, 6, 7, 12, 16})
        for (const Taper taper : {Taper::hann, Taper::none}) {
            const Image window = image(n, [](int x, int y) { return x * x + 3 * y + x * y % 5; });
            double mean = 0;
            for (const double value : window) mean += value / (n * n);
            const auto weight = [&](int i) {
                return taper == Taper::none ? 1 : std::pow(std::sin(pi * (i + 0.5) / n), 2);
            };
            const auto power = periodogram(window, n, taper);
            for (int v = 0; v < n; ++v)
                for (int u = 0; u < n; ++u) {
                    double real = 0, imaginary = 0;
                    for (int y = 0; y < n; ++y)
                        for (int x = 0; x < n; ++x) {
                            const double angle = 2 * pi * (u * x + v * y) / n;
                            const double value =
                                (window[y * n + x] - mean) * weight(x) * weight(y);
                            real += value * std::cos(angle);
                            imaginary += value * std::sin(angle);
                        }
                    const double defined = real * real + imaginary * imaginary;
                    EXPECT_NEAR(power[v * n + u], defined, 1e-9 * (1 + defined)) << n;
                }
        }
}

}  // namespace
}  // namespace umbra78::tools
