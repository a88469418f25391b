// The dither as the post-process uses it, measured on masks alone.
//
// The observer sees one plane, and the light's depth map is stripes one texel wide, near and far in
// turn. The matrix moves each point to `threshold` words (128ths of a texel) short of the border of
// two stripes, so whether it is in shadow says whether its dither word is at least the threshold:
// stripes of columns show the X words, stripes of rows the Y words. From such masks come
//   the distribution of each axis' words, at seven thresholds, against the exact one;
//   the correlation of X with Y, in one pixel and in neighbours;
//   the correlation of each axis with itself, along the line and from line to line.
// Each of four faults of a noise source fails the statistic that is meant for it.
#include "shadow/post_process.hpp"
#include "tests/claims/exact_words.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace umbra78::claims {
namespace {

using hw::DitherShape;
using hw::DitherWords;

constexpr int size = 512;
constexpr std::array thresholds{-24, -16, -8, 0, 8, 16, 24};  // words
constexpr std::size_t sign = 3;                               // the threshold 0

enum class Axis : std::uint8_t { x, y };
enum class LoopForm : std::uint8_t { definition, rows };

// For each threshold, 1 where a pixel's word is at least that.
using Bits = std::vector<std::uint8_t>;
using AxisBits = std::array<Bits, thresholds.size()>;
struct Seen {
    AxisBits x, y;
};

// Of words that are known: what the masks would show.
Seen seen_of(const std::vector<DitherWords>& words) {
    Seen seen;
    for (std::size_t t = 0; t < thresholds.size(); ++t)
        for (const DitherWords& w : words) {
            seen.x[t].push_back(w.x >= thresholds[t]);
            seen.y[t].push_back(w.y >= thresholds[t]);
        }
    return seen;
}

std::vector<DitherWords> words_of(DitherShape shape, std::int32_t size_q8 = 256) {
    hw::Dither dither;
    dither.shape = shape;
    dither.size_q8 = size_q8;
    hw::NoiseSource source(dither, hw::MachineSpec{}, 0, 0);
    std::vector<DitherWords> words(std::size_t{size} * size);
    for (DitherWords& w : words) w = source.next();
    return words;
}

// The identity, but that a pixel's centre moves half a texel and `threshold` words down the axis:
// to `threshold` words before the border between its texel and the one before.
hw::MatrixWords moved(Axis axis, int threshold) {
    hw::MatrixWords m;
    for (std::size_t r = 0; r < 3; ++r) m.word[r][r] = 1 << 14;
    m.word[static_cast<std::size_t>(axis)][3] = -64 - threshold;
    return m;
}

// Read from the masks of the post-process, in one of its forms.
AxisBits seen_in_masks(Axis axis, DitherShape shape, LoopForm form) {
    shadow::ShadowTest s;
    s.dither.shape = shape;
    const hw::MachineSpec& m = s.machine;
    std::vector<hw::Depth16> surface(std::size_t{size} * size, hw::Depth16{20000});
    std::vector<hw::Depth16> stripes(surface.size());
    const auto odd = [&](std::size_t a) { return (axis == Axis::x ? a % size : a / size) % 2; };
    for (std::size_t a = 0; a < stripes.size(); ++a)
        stripes[a] = static_cast<hw::Depth16>(odd(a) != 0 ? m.deepest_drawn() : 0);
    const shadow::DepthMaps<hw::Depth16> maps{.observer = {m.xy_bits, surface, {}},
                                              .light = {m.xy_bits, stripes, {}}};
    const auto memory = std::make_unique<shadow::RowMemory>();
    AxisBits seen;
    for (std::size_t t = 0; t < thresholds.size(); ++t) {
        std::vector<std::uint8_t> mask(surface.size());
        const hw::MatrixWords matrix = moved(axis, thresholds[t]);
        if (form == LoopForm::definition) {
            post_process(maps, matrix, s, mask);
        } else {
            EXPECT_TRUE(rows_cover(s, matrix));
            post_process_rows(maps, matrix, s, *memory, mask);
        }
        seen[t].resize(mask.size());
        for (std::size_t a = 0; a < mask.size(); ++a)
            seen[t][a] = (mask[a] == shadow::mask_shadow) != (odd(a) != 0);
    }
    return seen;
}

Seen seen_in_masks(DitherShape shape, LoopForm form) {
    return {seen_in_masks(Axis::x, shape, form), seen_in_masks(Axis::y, shape, form)};
}

// --- statistics ---------------------------------------------------------------------------------

double mean(const Bits& bits) {
    double sum = 0;
    for (const std::uint8_t b : bits) sum += b;
    return sum / static_cast<double>(bits.size());
}

// The greatest distance of the share of words at or above a threshold from the exact share.
double off_distribution(const AxisBits& seen, const std::array<double, 129>& exact) {
    double greatest = 0;
    for (std::size_t t = 0; t < thresholds.size(); ++t) {
        double expected = 0;
        for (int word = thresholds[t]; word <= 64; ++word)
            expected += exact[static_cast<std::size_t>(word + 64)];
        greatest = std::max(greatest, std::abs(mean(seen[t]) - expected));
    }
    return greatest;
}

// Of a's signs with b's dx, dy pixels on. Signs that never change correlate with nothing.
double correlation(const Bits& a, const Bits& b, int dx, int dy) {
    const double ma = mean(a), mb = mean(b);
    double ab = 0, aa = 0, bb = 0;
    for (int y = 0; y + dy < size; ++y)
        for (int x = 0; x + dx < size; ++x) {
            const double u = a[static_cast<std::size_t>(size * y + x)] - ma;
            const double v = b[static_cast<std::size_t>(size * (y + dy) + x + dx)] - mb;
            ab += u * v;
            aa += u * u;
            bb += v * v;
        }
    return aa * bb == 0 ? 0 : ab / std::sqrt(aa * bb);
}

struct Statistics {
    double x_off = 0, y_off = 0;  // of the distribution
    double cross = 0;             // X with Y, the greatest of the pixel and its neighbours
    double along = 0, lines = 0;  // each axis with itself, along a line, from line to line
};

Statistics measure(const std::string& what, const Seen& seen,
                   const std::array<double, 129>& exact) {
    Statistics s{off_distribution(seen.x, exact), off_distribution(seen.y, exact)};
    const Bits &x = seen.x[sign], &y = seen.y[sign];
    const auto raise = [](double& greatest, double r) {
        greatest = std::max(greatest, std::abs(r));
    };
    for (const auto& [dx, dy] : {std::pair{0, 0}, {1, 0}, {0, 1}, {1, 1}}) {
        raise(s.cross, correlation(x, y, dx, dy));
        raise(s.cross, correlation(y, x, dx, dy));
    }
    for (const Bits* axis : {&x, &y}) {
        for (int dx = 1; dx <= 4; ++dx) raise(s.along, correlation(*axis, *axis, dx, 0));
        for (int dy = 1; dy <= 8; ++dy)
            for (const int dx : {0, 1}) raise(s.lines, correlation(*axis, *axis, dx, dy));
    }
    std::printf("%-40s off the distribution X %.4f, Y %.4f; correlation X with Y %.4f, along "
                "lines %.4f, from line to line %.4f\n",
                what.c_str(), s.x_off, s.y_off, s.cross, s.along, s.lines);
    return s;
}

// A frame has 2^18 words: the standard error of a share is 1/1024, that of a correlation 1/512.
// Five of a share are allowed, and the 0.0037 by which the register's three-term relations move it:
// they skew the sum of twelve bytes by -0.056 (dither_test.cpp), which is 0.056/6 times the normal
// density's greatest value. Ten of a correlation are allowed: the register gives 0.0096.
constexpr double share_limit = 5.0 / 1024 + 0.0037;
constexpr double correlation_limit = 10.0 / 512;

void expect_sound(const Statistics& s, const std::string& what) {
    EXPECT_LT(s.x_off, share_limit) << what;
    EXPECT_LT(s.y_off, share_limit) << what;
    EXPECT_LT(s.cross, correlation_limit) << what;
    EXPECT_LT(s.along, correlation_limit) << what;
    EXPECT_LT(s.lines, correlation_limit) << what;
}

// --- the stream as used -------------------------------------------------------------------------

TEST(DitherInUse, HasItsDistributionAndNoCorrelation) {
    for (const LoopForm form : {LoopForm::definition, LoopForm::rows}) {
        const std::string name = form == LoopForm::rows ? "row form, " : "definition, ";
        expect_sound(measure(name + "normal", seen_in_masks(DitherShape::normal, form),
                             exact_words<12>()), name + "normal");
        expect_sound(measure(name + "uniform", seen_in_masks(DitherShape::uniform, form),
                             exact_words<1>()), name + "uniform");
    }
}

// The masks show the source's words, so the faults below are those that masks would show.
TEST(DitherInUse, IsReadRightFromTheMasks) {
    const Seen words = seen_of(words_of(DitherShape::normal));
    const Seen masks = seen_in_masks(DitherShape::normal, LoopForm::definition);
    EXPECT_TRUE(words.x == masks.x);
    EXPECT_TRUE(words.y == masks.y);
}

// --- negative controls --------------------------------------------------------------------------

TEST(DitherInUseControls, ASixteenthTooNarrowIsOffTheDistribution) {
    for (const int size_q8 : {240, 64}) {
        const Statistics s =
            measure("size " + std::to_string(size_q8) + "/256",
                    seen_of(words_of(DitherShape::normal, size_q8)), exact_words<12>());
        EXPECT_GT(s.x_off, share_limit);
        EXPECT_GT(s.y_off, share_limit);
        EXPECT_LT(s.cross, correlation_limit) << "and nothing else shows it";
        EXPECT_LT(s.lines, correlation_limit);
    }
}

TEST(DitherInUseControls, XsWordForYCorrelates) {
    auto words = words_of(DitherShape::normal);
    for (DitherWords& w : words) w.y = w.x;
    const Statistics s = measure("X's word for Y", seen_of(words), exact_words<12>());
    EXPECT_GT(s.cross, 0.99);
    EXPECT_LT(s.y_off, share_limit) << "and nothing else shows it";
    EXPECT_LT(s.lines, correlation_limit);
}

TEST(DitherInUseControls, NoDitherOfYIsOffTheDistribution) {
    auto words = words_of(DitherShape::normal);
    for (DitherWords& w : words) w.y = 0;
    const Statistics s = measure("no dither of Y", seen_of(words), exact_words<12>());
    EXPECT_GT(s.y_off, 0.2);
    EXPECT_LT(s.x_off, share_limit);
}

TEST(DitherInUseControls, RestartedRowsCorrelateFromLineToLine) {
    for (const std::size_t lines : {std::size_t{1}, std::size_t{8}}) {
        auto words = words_of(DitherShape::normal);
        for (std::size_t k = lines * size; k < words.size(); ++k)
            words[k] = words[k % (lines * size)];
        const Statistics s = measure("restarted after lines: " + std::to_string(lines),
                                     seen_of(words), exact_words<12>());
        EXPECT_GT(s.lines, 0.99);
    }
}

}  // namespace
}  // namespace umbra78::claims
