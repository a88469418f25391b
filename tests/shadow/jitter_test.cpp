// Jittered taps: each in its cell, evenly, by the place's own noise.
#include "shadow/window.hpp"

#include "tests/shadow/slow_point.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace umbra78::shadow {
namespace {

constexpr int one_texel = 128;  // a texel, in the words of X and Y

hw::MachineSpec jitter_machine() {
    hw::MachineSpec spec;
    spec.xy_bits = 4;
    return spec;
}

// Where the cells are the grid's texels the bytes change nothing: an even window about a texel's
// corner, an odd one about its middle.
TEST(Jitter, KeepsEachTapInItsCell) {
    const hw::MachineSpec m = jitter_machine();
    for (int side = 2; side <= 5; ++side)
        for (const int byte : {0, 1, 127, 128, 255}) {
            const std::int64_t at = side % 2 == 0 ? one_texel : one_texel + one_texel / 2;
            for (int i = 0; i < side; ++i)
                EXPECT_EQ(jittered_texel(m, {side, true}, i, static_cast<std::uint8_t>(byte), at),
                          first_texel(m, {side, false}, at) + i)
                    << side << " taps, byte " << byte;
        }
    // An even window half a texel off: half of the bytes go to either texel.
    int before = 0;
    for (int byte = 0; byte < 256; ++byte) {
        const auto noise = static_cast<std::uint8_t>(byte);
        before += jittered_texel(m, {2, true}, 0, noise, one_texel / 2) == 7;
    }
    EXPECT_EQ(before, 128);
}

TEST(Jitter, IsTheSlowModelsAndThePlacesOwn) {
    ShadowTest t;
    t.machine = jitter_machine();
    t.lookup = Lookup::percentage;
    t.tap_places = TapPlaces::jittered;
    for (const std::uint32_t seed : {0x12345678u, 1u, 0x7fffffffu})
        for (t.taps = 2; t.taps <= 5; ++t.taps) {
            t.dither.seed = seed;
            const test::SlowTapNoise slow(t);
            const int taps = t.taps * t.taps;
            for (int y = 0; y < 16; ++y) {
                hw::TapNoise line(seed, taps, t.machine, 0, y);
                for (int x = 0; x < 16; ++x) {
                    const hw::TapBytes expected = slow.bytes(static_cast<std::size_t>(16 * y + x));
                    const hw::TapBytes got = line.next();
                    ASSERT_EQ(got.x, expected.x) << x << " " << y;
                    ASSERT_EQ(got.y, expected.y) << x << " " << y;
                    const auto alone = hw::TapNoise(seed, taps, t.machine, x, y).next();
                    ASSERT_EQ(alone.x, expected.x) << "whatever was asked before";
                }
            }
        }
}

// MACHINE.md's example, section 10.
TEST(Jitter, IsTheDocuments) {
    const hw::MachineSpec m;
    const auto first = hw::TapNoise(0x12345678, 4, m, 0, 0).next();
    const auto other = hw::TapNoise(0x12345678, 4, m, 80, 180).next();
    const std::array x{first.x[0], first.x[1], first.x[2], first.x[3]};
    const std::array y{other.y[0], other.y[1], other.y[2], other.y[3]};
    EXPECT_EQ(x, (std::array<std::uint8_t, 4>{170, 214, 175, 198}));
    EXPECT_EQ(y, (std::array<std::uint8_t, 4>{210, 82, 212, 60}));
}

// Pearson's statistic of 256 classes: 255 on average, deviation 22.6.
double chi_square(const std::vector<std::uint8_t>& bytes) {
    std::array<double, 256> seen{};
    for (const std::uint8_t b : bytes) ++seen[b];
    const double mean = static_cast<double>(bytes.size()) / 256;
    double sum = 0;
    for (const double n : seen) sum += (n - mean) * (n - mean) / mean;
    return sum;
}
double correlation(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
    double sum = 0, aa = 0, bb = 0;
    for (std::size_t k = 0; k < a.size(); ++k) {
        sum += (a[k] - 127.5) * (b[k] - 127.5);
        aa += (a[k] - 127.5) * (a[k] - 127.5);
        bb += (b[k] - 127.5) * (b[k] - 127.5);
    }
    return sum / std::sqrt(aa * bb);
}

// Each tap of a frame's pixels is spread evenly over its cell, and no two bytes of a pixel, nor the
// dither's, go together. The control: one byte for both directions.
TEST(Jitter, IsEvenAndIndependent) {
    const hw::MachineSpec m;  // 512 x 512
    const int side = 3, taps = side * side;
    std::array<std::vector<std::uint8_t>, 2 * 9> of;
    std::vector<std::uint8_t> dither;
    const hw::Dither uniform{hw::DitherShape::uniform, 512, 0x12345678};
    for (int y = 0; y < 512; y += 3) {
        hw::TapNoise noise(0x12345678, taps, m, 0, y);
        hw::NoiseSource words(uniform, m, 0, y);
        for (int x = 0; x < 512; ++x) {
            const hw::TapBytes bytes = noise.next();
            for (std::size_t t = 0; t < 9; ++t) {
                of[2 * t].push_back(bytes.x[t]);
                of[2 * t + 1].push_back(bytes.y[t]);
            }
            dither.push_back(static_cast<std::uint8_t>(words.next().x + 128));
        }
    }
    const double noise_of_sample = 4.5 / std::sqrt(static_cast<double>(of[0].size()));
    for (std::size_t a = 0; a < of.size(); ++a) {
        EXPECT_LT(chi_square(of[a]), 255 + 5 * 22.6) << a;
        EXPECT_GT(chi_square(of[a]), 255 - 5 * 22.6) << a;
        EXPECT_LT(std::abs(correlation(of[a], dither)), noise_of_sample) << a;
        for (std::size_t b = 0; b < a; ++b)
            EXPECT_LT(std::abs(correlation(of[a], of[b])), noise_of_sample) << a << " " << b;
    }
    EXPECT_GT(correlation(of[0], of[0]), noise_of_sample) << "the control";
}

}  // namespace
}  // namespace umbra78::shadow
