// Figure 4's noise: the words themselves, their mean, variance and distribution. Whether the
// post-process uses them as they are is asked in dither_in_use_test.cpp.
//
// A word is the centred sum of k bytes, scaled to one texel peak to peak, in 128ths. Its variance
// is that of k uniforms, (k (2^16 - 1) / 12) (2 A / 2^16)^2, and 1/12 for the rounding to words:
// about 128^2 / (12 k). With k = 12 the deviation is 1/12 texel, 10.7 words.
#include "tests/claims/exact_words.hpp"
#include "tests/claims/ground.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

namespace umbra78::claims {
namespace {

using hw::DitherShape;
using hw::DitherWords;

struct Moments {
    double mean = 0, variance = 0;
    int min = 0, max = 0;
};

template <class Word>
Moments moments(const std::vector<DitherWords>& plane, Word&& word) {
    Moments m;
    double sum = 0, squares = 0;
    for (const DitherWords& w : plane) {
        const int v = word(w);
        sum += v;
        squares += double{1} * v * v;
        m.min = std::min(m.min, v);
        m.max = std::max(m.max, v);
    }
    const auto n = static_cast<double>(plane.size());
    m.mean = sum / n;
    m.variance = squares / n - m.mean * m.mean;
    return m;
}

// The correlation of a frame's words with those dx, dy pixels on, or of X with Y.
template <class A, class B>
double correlation(const std::vector<DitherWords>& plane, int dx, int dy, A&& a, B&& b) {
    double ab = 0, aa = 0, bb = 0;
    for (int y = 0; y + dy < 512; ++y)
        for (int x = 0; x + dx < 512; ++x) {
            const double u = a(plane[static_cast<std::size_t>(512 * y + x)]);
            const double v = b(plane[static_cast<std::size_t>(512 * (y + dy) + x + dx)]);
            ab += u * v;
            aa += u * u;
            bb += v * v;
        }
    return ab / std::sqrt(aa * bb);
}

constexpr auto x_word = [](const DitherWords& w) { return w.x; };
constexpr auto y_word = [](const DitherWords& w) { return w.y; };

constexpr double texel_words = 128;
double stated_variance(int k) { return texel_words * texel_words / (12 * k); }

TEST(Dither, FirstWordsOfFigure4) {
    const auto plane = noise_plane(DitherShape::normal);
    constexpr std::array<std::array<int, 2>, 8> first{
        {{-13, 25}, {-21, 0}, {4, 2}, {-2, -1}, {6, -25}, {-20, -8}, {10, 0}, {-16, -1}}};
    for (std::size_t k = 0; k < first.size(); ++k) {
        EXPECT_EQ(plane[k].x, first[k][0]) << k;
        EXPECT_EQ(plane[k].y, first[k][1]) << k;
    }
}

TEST(Dither, HasTheStatedMeanAndVariance) {
    for (const auto& [shape, text] :
         {std::pair{DitherShape::uniform, "uniform"}, {DitherShape::triangular, "triangular"},
          {DitherShape::normal4, "normal4"}, {DitherShape::normal, "normal"}}) {
        const int k = hw::uniforms(shape);
        const auto plane = noise_plane(shape);
        const Moments x = moments(plane, x_word), y = moments(plane, y_word);
        std::printf("%-10s mean %+.3f %+.3f words, variance %.2f %.2f (stated %.2f), deviation "
                    "%.4f texel, from %d to %d\n",
                    text, x.mean, y.mean, x.variance, y.variance, stated_variance(k),
                    std::sqrt(x.variance) / texel_words, x.min, x.max);
        for (const Moments& m : {x, y}) {
            // Five standard errors, and what the last byte's width and the rounding can add.
            const double sigma = std::sqrt(stated_variance(k)) / 512;
            EXPECT_NEAR(m.mean, 0, 5 * sigma + 0.01) << text;
            EXPECT_NEAR(m.variance / stated_variance(k), 1, 0.015) << text;
            EXPECT_GE(m.min, -64) << text;
            EXPECT_LE(m.max, 64) << text;
        }
    }
}

// Chi squared of a frame's 2^19 words, X and Y, over those expected 20 times and more; and how
// many standard deviations that is from what independent bytes give.
template <int K>
double surprise(DitherShape shape) {
    const auto probability = exact_words<K>();
    const auto plane = noise_plane(shape);
    std::array<double, 129> seen{};
    for (const DitherWords& w : plane)
        for (const int v : {w.x, w.y}) seen[static_cast<std::size_t>(v + 64)] += 1;
    double chi_squared = 0;
    int cells = 0;
    for (std::size_t c = 0; c < seen.size(); ++c) {
        const double expected = probability[c] * 2 * static_cast<double>(plane.size());
        if (expected < 20) continue;
        ++cells;
        chi_squared += (seen[c] - expected) * (seen[c] - expected) / expected;
    }
    const double deviations = (chi_squared - cells + 1) / std::sqrt(2.0 * cells - 2);
    std::printf("%d bytes a word: chi squared %.1f over %d words, %+.1f deviations\n", K,
                chi_squared, cells, deviations);
    return deviations;
}

TEST(Dither, OfUpToFourBytesHasTheExactDistribution) {
    EXPECT_LT(std::abs(surprise<1>(DitherShape::uniform)), 4);
    EXPECT_LT(std::abs(surprise<2>(DitherShape::triangular)), 4);
    EXPECT_LT(std::abs(surprise<4>(DitherShape::normal4)), 4);
}

// Figure 4's word takes 96 successive bits, and that is long enough to see the register: of any
// three bits n, n - 28, n - 31 each is the exclusive or of the other two, and so, squared, of
// n, n - 56, n - 62. Such a triple has a mean product of -1/8 about one half, and gives the sum a
// third moment of -6/8 of the product of its places' values. The words are a little skew,
// -0.056, where twelve independent bytes are not at all; mean and variance are as stated.
TEST(Dither, OfTwelveBytesIsSkewAsTheRegisterMakesIt) {
    double third = 0;
    for (const auto& [far, near] : {std::pair{31, 28}, {62, 56}})
        for (int n = far; n < 96; ++n)
            third -= 6.0 / 8 * std::ldexp(1, n % 8 + (n - near) % 8 + (n - far) % 8);
    const double stated = third / std::pow(12 * 65535 / 12.0, 1.5);

    const auto plane = noise_plane(DitherShape::normal);
    double cubes = 0, fourth = 0;
    for (const DitherWords& w : plane)
        for (const double v : {w.x, w.y}) {
            cubes += v * v * v;
            fourth += v * v * v * v;
        }
    const double n = 2 * static_cast<double>(plane.size());
    const double variance =
        (moments(plane, x_word).variance + moments(plane, y_word).variance) / 2;
    const double skewness = cubes / n / std::pow(variance, 1.5);
    std::printf("normal: skewness %+.4f (from the register's relations %+.4f, independent 0), "
                "kurtosis %.3f (independent %.3f)\n",
                skewness, stated, fourth / n / (variance * variance), 3 - 6.0 / (5 * 12));
    EXPECT_NEAR(stated, -0.056, 0.001);
    EXPECT_NEAR(skewness, stated, 0.014) << "four standard errors";
    EXPECT_GT(surprise<12>(DitherShape::normal), 10) << "so the exact distribution is not met";
}

// The exact variance is a quarter of a per cent below the formula: A = 1365 is short of
// 1365 1/3, so no sum comes to a half word exactly, and word 0 gets 25 of the sums, others 24.
TEST(Dither, ExactMeanAndVarianceOfTheNormalWord) {
    const auto probability = exact_words<12>();
    double mean = 0, square = 0;
    for (int w = -64; w <= 64; ++w) {
        mean += probability[static_cast<std::size_t>(w + 64)] * w;
        square += probability[static_cast<std::size_t>(w + 64)] * w * w;
    }
    std::printf("normal, exact: mean %.5f words, variance %.4f, by the formula %.4f\n", mean,
                square, stated_variance(12));
    EXPECT_NEAR(mean, 0, 1e-6);
    EXPECT_NEAR(square, 113.5034, 0.0001);
}

// X and Y, and neighbouring pixels, have nothing to do with each other.
TEST(Dither, WordsAreUncorrelated) {
    const double limit = 5.0 / 512;  // five standard errors over a frame
    for (const DitherShape shape : {DitherShape::uniform, DitherShape::triangular,
                                    DitherShape::normal4, DitherShape::normal}) {
        const auto plane = noise_plane(shape);
        EXPECT_NEAR(correlation(plane, 0, 0, x_word, y_word), 0, limit);
        for (const auto& [dx, dy] : {std::pair{1, 0}, {0, 1}, {1, 1}, {2, 0}, {0, 2}}) {
            EXPECT_NEAR(correlation(plane, dx, dy, x_word, x_word), 0, limit) << dx << dy;
            EXPECT_NEAR(correlation(plane, dx, dy, y_word, y_word), 0, limit) << dx << dy;
            EXPECT_NEAR(correlation(plane, dx, dy, x_word, y_word), 0, limit) << dx << dy;
        }
    }
}

// --- negative controls --------------------------------------------------------------------------

// Triangular dither is the sum of two uniforms; of one uniform taken twice it is a uniform again,
// with twice the variance.
TEST(DitherControls, TriangularOfOneSharedUniformHasTwiceTheVariance) {
    const double sound = moments(noise_plane(DitherShape::triangular), x_word).variance;
    const double shared = moments(noise_plane(DitherShape::uniform), x_word).variance;
    std::printf("variance of triangular dither %.1f (stated %.1f), of one shared uniform %.1f\n",
                sound, stated_variance(2), shared);
    EXPECT_NEAR(sound / stated_variance(2), 1, 0.015);
    EXPECT_NEAR(shared / stated_variance(2), 2, 0.03);
}

TEST(DitherControls, AQuarterTexelHasASixteenthOfTheVariance) {
    const double whole = moments(noise_plane(DitherShape::normal), x_word).variance;
    const double quarter = moments(noise_plane(DitherShape::normal, 64), x_word).variance;
    std::printf("variance of the normal dither %.2f, of a quarter texel's %.2f\n", whole, quarter);
    EXPECT_NEAR(quarter * 16 / whole, 1, 0.03);
    EXPECT_GT(std::abs(quarter / stated_variance(12) - 1), 0.5) << "so the test above fails it";
}

}  // namespace
}  // namespace umbra78::claims
