// Edge dequantizing: shapes whose answer is known, and every answer against the slow model.
#include "shadow/filters/dequantize.hpp"

#include "tests/shadow/filters/slow_dequantize.hpp"
#include "tests/shadow/random_frames.hpp"
#include "tests/support/buffers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numeric>
#include <string>
#include <vector>

namespace umbra78::shadow {
namespace {

using fixed::Rational;
using test::PixelTest;
using test::Random;

constexpr hw::Depth16 none = 65535;
constexpr std::uint8_t dark = 255;

// A mask and what is seen, of 2^bits pixels a side.
struct Picture {
    explicit Picture(int bits)
        : size(1 << bits), observer(bits), mask(observer.depth.size()), out(mask.size(), 99),
          visited(edge_visited_words(bits), 0xdeadbeef),
          coverage(edge_coverage_words(bits), std::int16_t{-77}) {
        std::fill(observer.depth.begin(), observer.depth.end(), hw::Depth16{1000});
    }
    std::size_t at(int x, int y) const { return static_cast<std::size_t>(y * size + x); }
    void shade(const PixelTest& shadow) {
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) mask[at(x, y)] = shadow(x, y) ? dark : 0;
    }
    void hide(const PixelTest& background) {
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x)
                if (background(x, y)) observer.depth[at(x, y)] = none;
    }
    void dequantize_here(int passes) {
        steps = dequantize<hw::Depth16>(mask, observer.store, none, passes, {visited, coverage},
                                        out);
    }
    int total() const { return std::accumulate(out.begin(), out.end(), 0); }

    int size;
    test::OwnedStore<hw::Depth16> observer;
    std::vector<std::uint8_t> mask, out;
    std::vector<std::uint32_t> visited;
    std::vector<std::int16_t> coverage;
    std::uint64_t steps = 0;
};

struct SlowAnswer {
    std::vector<std::uint8_t> out;
    std::uint64_t steps = 0;
    std::vector<int> coverage;
    Rational area, perimeter;  // of the smoothed chains; the perimeter as |dx| + |dy|
};

SlowAnswer slow_dequantize(const Picture& p, int passes) {
    const auto shadow = [&](int x, int y) { return p.mask[p.at(x, y)] >= 128; };
    const auto background = [&](int x, int y) { return p.observer.depth[p.at(x, y)] == none; };
    SlowAnswer answer;
    std::vector<test::SlowChain> chains = test::slow_chains(p.size, shadow, background);
    for (test::SlowChain& chain : chains) {
        answer.steps += chain.size();
        chain = test::slow_smooth(chain, passes);
        answer.area += test::slow_area(chain);
        for (std::size_t k = 0; k < chain.size(); ++k) {
            const auto& a = chain[k];
            const auto& b = chain[(k + 1) % chain.size()];
            for (const Rational& d : {b.x - a.x, b.y - a.y})
                answer.perimeter += d.is_negative() ? -d : d;
        }
    }
    answer.coverage = test::slow_coverage(p.size, chains);
    for (std::size_t a = 0; a < answer.coverage.size(); ++a) {
        const bool hidden = p.observer.depth[a] == none;
        answer.out.push_back(static_cast<std::uint8_t>(
            hidden ? 0 : (answer.coverage[a] * 255 + 128) / 256));
    }
    return answer;
}

double as_double(const Rational& r) {
    std::int64_t q20 = 0;
    EXPECT_TRUE(r.round_scaled(20, fixed::Rounding::half_even, q20));
    return std::ldexp(static_cast<double>(q20), -20);
}

// Against the slow model, and total coverage against the exact area of the smoothed chains: each
// of the 16 sub-rows is off by at most a 32nd of a pixel a crossing, and half a sub-row at its
// ends.
void expect_slow_answer(Picture& p, int passes, const std::string& what) {
    SCOPED_TRACE(what + ", passes " + std::to_string(passes));
    p.dequantize_here(passes);
    const SlowAnswer slow = slow_dequantize(p, passes);
    EXPECT_EQ(p.steps, slow.steps);
    if (p.out != slow.out)
        umbra78::test::expect_equal_buffers("edges", p.size, slow.out, p.out);
    const double covered =
        std::accumulate(slow.coverage.begin(), slow.coverage.end(), 0) / 256.0;
    const double area = as_double(slow.area), perimeter = as_double(slow.perimeter);
    EXPECT_NEAR(covered, area, perimeter / 16 + 1e-9);
}

constexpr std::array<int, 7> all_passes{0, 1, 2, 3, 4, 5, 6};

// --- known shapes -------------------------------------------------------------------------------

TEST(Dequantize, WithoutPassesTheMaskIsItsOwnArea) {
    Random random;
    for (int round = 0; round < 20; ++round) {
        Picture p(4 + round % 3);
        p.shade([&](int, int) { return random.bits() % 3 == 0; });
        p.dequantize_here(0);
        umbra78::test::expect_equal_buffers("mask", p.size, p.mask, p.out);
    }
}

// A square's corners move a quarter of the way to their neighbours: each pass halves its side.
TEST(Dequantize, ASinglePixelShrinksToAQuarterAPass) {
    const std::array<int, 7> side_16{16, 8, 4, 2, 1, 0, 0};  // in sixteenths, as the count sees it
    for (const int passes : all_passes) {
        Picture p(4);
        p.shade([](int x, int y) { return x == 7 && y == 5; });
        p.dequantize_here(passes);
        const int side = side_16[static_cast<std::size_t>(passes)];
        EXPECT_EQ(p.steps, 4u);
        EXPECT_EQ(p.out[p.at(7, 5)], (side * side * 255 + 128) / 256) << passes;
        EXPECT_EQ(p.total(), p.out[p.at(7, 5)]) << "nothing but the pixel";
    }
}

// Straight edges stand still, but for `passes` pixels from a corner.
TEST(Dequantize, AStraightEdgeIsUnchangedAwayFromItsEnds) {
    for (const int passes : all_passes) {
        Picture p(6);
        p.shade([](int x, int y) { return x >= 13 && x < 51 && y >= 17 && y < 40; });
        p.dequantize_here(passes);
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x) {
                const auto near = [&](int v, int a, int b) {
                    return std::min(std::abs(v - a), std::abs(v - b)) <= passes;
                };
                if (near(x, 13, 51) && near(y, 17, 40)) continue;
                ASSERT_EQ(p.out[p.at(x, y)], p.mask[p.at(x, y)]) << x << " " << y;
            }
        const int rounded_off = 38 * 23 * 255 - p.total();
        EXPECT_EQ(rounded_off == 0, passes == 0);
        EXPECT_LE(rounded_off, 4 * 255 * passes) << "less than a pixel a corner a pass";
    }
}

// A half plane y > p/q x, drawn in whole pixels, comes back as nearly the line itself: compared
// with its exact area in each pixel that either of them cuts, away from the frame's edge.
double mean_area_error(const Picture& p, const std::vector<std::uint8_t>& mask, double slope,
                       double offset) {
    double error = 0;
    int pixels = 0;
    for (int x = 12; x < p.size - 12; ++x)
        for (int y = 0; y < p.size; ++y) {
            double ideal = 0;  // over 64 columns, each exact
            for (int k = 0; k < 64; ++k)
                ideal += std::clamp(y + 1 - (slope * (x + (k + 0.5) / 64) + offset), 0.0, 1.0);
            ideal /= 64;
            const double got = mask[p.at(x, y)] / 255.0;
            if (ideal == got && (ideal == 0 || ideal == 1)) continue;
            error += std::abs(got - ideal);
            ++pixels;
        }
    return pixels == 0 ? 0 : error / pixels;
}

TEST(Dequantize, ASlantedEdgeBecomesNearlyTheLine) {
    struct Slope {
        int rise, run, passes;
        double at_most;  // of the error before
    };
    // Four passes reach four pixels along the edge, which is less than the long stairs of 1:12.
    for (const Slope& s : {Slope{1, 3, 0, 1}, {1, 3, 1, 0.55}, {1, 3, 2, 0.3}, {1, 3, 4, 0.07},
                           {1, 3, 6, 0.05}, {1, 1, 4, 0.15}, {1, 2, 4, 0.02}, {1, 5, 4, 0.35},
                           {2, 7, 4, 0.4}, {1, 12, 4, 0.8}}) {
        Picture p(6);
        // An odd run's stairs lie evenly round a line that passes half a step beside centres.
        const double slope = static_cast<double>(s.rise) / s.run;
        const double offset = 10 + (s.run % 2 == 0 ? 0 : 0.5 / s.run);
        p.shade([&](int x, int y) { return y + 0.5 > slope * (x + 0.5) + offset - 1e-9; });
        p.dequantize_here(s.passes);
        const double before = mean_area_error(p, p.mask, slope, offset);
        const double after = mean_area_error(p, p.out, slope, offset);
        std::printf("edge of slope %d:%d, %d passes: mean area error %.4f before, %.4f after\n",
                    s.rise, s.run, s.passes, before, after);
        EXPECT_LE(after, s.at_most * before) << s.rise << ":" << s.run << " " << s.passes;
    }
}

// Round shapes shrink a little: an average of nodes lies inside the curve.
TEST(Dequantize, ADiscBecomesRounder) {
    struct Disc {
        double radius;
        double error_at_max, shrinks_at_max;  // parts of the error before, of the area
    };
    for (const Disc& disc : {Disc{5.3, 0.85, 0.08}, {12.0, 0.55, 0.015}, {24.7, 0.55, 0.008}}) {
        const double radius = disc.radius;
        Picture p(6);
        const double cx = 31.7, cy = 32.2;
        p.shade([&](int x, int y) { return std::hypot(x + 0.5 - cx, y + 0.5 - cy) < radius; });
        p.dequantize_here(4);
        double before = 0, after = 0, area = 0;
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x) {
                int in = 0;
                for (int k = 0; k < 1024; ++k)
                    in += std::hypot(x + (k % 32 + 0.5) / 32 - cx, y + (k / 32 + 0.5) / 32 - cy) <
                          radius;
                const double ideal = in / 1024.0;
                before += std::abs(p.mask[p.at(x, y)] / 255.0 - ideal);
                after += std::abs(p.out[p.at(x, y)] / 255.0 - ideal);
                area += p.out[p.at(x, y)] / 255.0;
            }
        const double exact = 3.14159265358979 * radius * radius;
        std::printf("disc of radius %.1f, 4 passes: area error %.1f pixels before, %.1f after; "
                    "area %.1f of %.1f\n",
                    radius, before, after, area, exact);
        EXPECT_LT(after, disc.error_at_max * before);
        EXPECT_NEAR(area / exact, 1, disc.shrinks_at_max);
    }
}

TEST(Dequantize, AShadowOverTheWholeFrameStays) {
    for (const int passes : all_passes) {
        Picture p(5);
        p.shade([](int, int) { return true; });
        p.dequantize_here(passes);
        EXPECT_EQ(p.steps, 128u);
        EXPECT_EQ(p.out, p.mask) << passes;
        p.shade([](int, int) { return false; });
        p.dequantize_here(passes);
        EXPECT_EQ(p.steps, 0u);
        EXPECT_EQ(p.total(), 0) << passes;
    }
}

// Pixels that touch only at a corner are kept apart: each shrinks as if alone.
TEST(Dequantize, ACheckerboardIsSoManySinglePixels) {
    for (const int passes : all_passes) {
        Picture p(5), alone(5);
        p.shade([](int x, int y) { return (x + y) % 2 == 0; });
        p.dequantize_here(passes);
        alone.shade([](int x, int y) { return x == 7 && y == 5; });
        alone.dequantize_here(passes);
        EXPECT_EQ(p.steps, 4u * 32 * 16);
        for (int y = 1; y < 31; ++y)
            for (int x = 1; x < 31; ++x)
                ASSERT_EQ(p.out[p.at(x, y)],
                          (x + y) % 2 == 0 ? alone.out[alone.at(7, 5)] : 0)
                    << x << " " << y << " passes " << passes;
    }
}

// Where the shadow ends with the surface, or with the frame, its edge is a silhouette and stays.
TEST(Dequantize, SilhouettesArePinned) {
    for (const int passes : all_passes) {
        Picture p(5);
        p.hide([](int x, int y) { return 3 * y < x; });  // a slanted silhouette, all in shadow
        p.shade([](int x, int y) { return 3 * y >= x && x < 20; });
        p.dequantize_here(passes);
        for (int y = 0; y < 32; ++y)
            for (int x = 0; x < 32; ++x) {
                const bool seen = p.observer.depth[p.at(x, y)] != none;
                // Right up to the silhouette, but for the straight edge's ends at x = 20.
                if (seen && x >= 20 - passes) continue;
                ASSERT_EQ(p.out[p.at(x, y)], seen ? dark : 0) << x << " " << y;
            }
        expect_slow_answer(p, passes, "silhouette");
    }
}

TEST(Dequantize, ThresholdIs128) {
    Picture p(4);
    for (std::size_t a = 0; a < p.mask.size(); ++a) p.mask[a] = a / 16 < 8 ? 127 : 128;
    p.dequantize_here(2);
    for (std::size_t a = 0; a < p.mask.size(); ++a)
        ASSERT_EQ(p.out[a], a / 16 < 8 ? 0 : dark) << a;
}

TEST(Dequantize, InPlaceIsTheSame) {
    Random random;
    Picture p(5);
    p.shade([&](int, int) { return random.bits() % 2 == 0; });
    p.dequantize_here(3);
    const std::vector<std::uint8_t> expected = p.out;
    dequantize<hw::Depth16>(p.mask, p.observer.store, none, 3, {p.visited, p.coverage}, p.mask);
    EXPECT_EQ(p.mask, expected);
}

// --- against the slow model ---------------------------------------------------------------------

// Masks of 4 x 3 pixels, in the middle and at a corner of the frame, where nodes are pinned.
TEST(Dequantize, SmallMasks) {
    Picture p(4);
    for (int bits = 1; bits < 4096 && !HasFailure(); bits += 3) {
        const int corner = bits % 2 == 0 ? 0 : 6;
        p.shade([&](int x, int y) {
            const int i = x - corner, j = y - corner;
            return i >= 0 && j >= 0 && i < 4 && j < 3 && (bits >> (4 * j + i) & 1) != 0;
        });
        expect_slow_answer(p, bits % 5 + 1, "mask " + std::to_string(bits));
    }
}

TEST(Dequantize, RandomMasksAndSilhouettes) {
    Random random;
    for (int round = 0; round < 60 && !HasFailure(); ++round) {
        Picture p(4 + static_cast<int>(random.bits() % 2));
        const std::uint64_t density = 1 + random.bits() % 7;
        // Noise, or blobs: what a random line and a random disc leave.
        const double a = static_cast<double>(random.between(-200, 200)) / 100;
        const double b = static_cast<double>(random.between(0, 2000)) / 100;
        const double cx = static_cast<double>(random.between(0, 3200)) / 100;
        const double r = static_cast<double>(random.between(100, 1600)) / 100;
        const std::uint64_t kind = random.bits() % 3;
        p.shade([&](int x, int y) {
            if (kind == 0) return random.bits() % 8 < density;
            const bool over = y > a * x + b, in = std::hypot(x - cx, y - b) < r;
            return kind == 1 ? over != in : in && random.bits() % 16 != 0;
        });
        if (random.bits() % 2 == 0)
            p.hide([&](int x, int y) {
                const bool gone = std::hypot(x - cx, y - cx) > 1.2 * r;
                if (gone) p.mask[p.at(x, y)] = 0;  // the machine never shades the background
                return gone;
            });
        const auto passes = static_cast<int>(random.bits() % 7);
        expect_slow_answer(p, passes, "round " + std::to_string(round));
    }
}

// Long chains, holes in holes, at every number of passes.
TEST(Dequantize, RingsAtEveryNumberOfPasses) {
    for (const int passes : all_passes) {
        Picture p(6);
        p.shade([](int x, int y) {
            return static_cast<int>(std::hypot(x - 30.2, y - 33.1)) / 5 % 2 == 0;
        });
        expect_slow_answer(p, passes, "rings");
    }
}

}  // namespace
}  // namespace umbra78::shadow
