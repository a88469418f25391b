// The noise source against a register that shifts a bit at a time: each pixel owns its words.
#include "hw/noise_source.hpp"

#include "tests/fixed/boundary.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace umbra78::hw {
namespace {

using fixed::test::Random;

constexpr std::array shapes{DitherShape::uniform, DitherShape::triangular, DitherShape::normal4,
                            DitherShape::normal};

// b[n] = b[n-31] xor b[n-28], the seed's bits first.
std::vector<std::uint8_t> slow_bits(std::uint32_t seed, std::size_t count) {
    std::vector<std::uint8_t> b(count);
    for (std::size_t n = 0; n < count; ++n)
        b[n] = static_cast<std::uint8_t>(n < 31 ? seed >> n & 1 : b[n - 31] ^ b[n - 28]);
    return b;
}

// The word of k bytes from bit `at` on, low bit first, by the formula of fixed/dither.hpp.
int slow_word(const std::vector<std::uint8_t>& bits, std::size_t at, int k, const Dither& d,
              int fraction_bits) {
    int sum = 0;
    for (int n = 0; n < 8 * k; ++n) sum += bits[at + static_cast<std::size_t>(n)] << (n % 8);
    const double amplitude =
        std::floor(std::ldexp(d.size_q8, fraction_bits + 16) / (256.0 * 512 * k) + 0.5);
    return static_cast<int>(std::floor((2 * sum - 255 * k) * amplitude / 65536 + 0.5));
}

TEST(NoiseSource, EqualsARegisterThatShiftsABitAtATime) {
    const int width = 32, lines = 4;
    MachineSpec spec;
    spec.xy_bits = 5;
    for (const DitherShape shape : shapes) {
        const int k = uniforms(shape);
        const Dither dither{shape, 256 + 64 * k, 0x2bcdef01};
        const auto bits = slow_bits(dither.seed, static_cast<std::size_t>(width * lines * 16 * k));
        std::size_t at = 0;
        for (int y = 0; y < lines; ++y) {
            NoiseSource source(dither, spec, 0, y);
            for (int x = 0; x < width; ++x) {
                const DitherWords w = source.next();
                const auto half = static_cast<std::size_t>(8 * k);
                ASSERT_EQ(w.x, slow_word(bits, at, k, dither, spec.fraction_bits)) << x << ',' << y;
                ASSERT_EQ(w.y, slow_word(bits, at + half, k, dither, spec.fraction_bits));
                at += 2 * half;
            }
        }
    }
}

// The same words at the same place, from wherever the walk along the line begins.
TEST(NoiseSource, BelongsToThePlace) {
    Random random;
    const MachineSpec spec;
    for (const DitherShape shape : shapes) {
        const Dither dither{shape, 256, 0x12345678};
        for (int n = 0; n < 40; ++n) {
            const int y = static_cast<int>(random.between(0, 511));
            const int x = static_cast<int>(random.between(0, 511));
            NoiseSource walked(dither, spec, 0, y), begun(dither, spec, x, y);
            for (int k = 0; k < x; ++k) (void)walked.next();
            const DitherWords a = walked.next(), b = begun.next();
            ASSERT_EQ(a.x, b.x) << x << ',' << y;
            ASSERT_EQ(a.y, b.y) << x << ',' << y;
        }
        // A scan line's words follow those of the line above.
        NoiseSource above(dither, spec, 511, 7), below(dither, spec, 0, 8);
        (void)above.next();
        EXPECT_EQ(above.next().x, below.next().x);
    }
}

// Mean 0, variance size^2 / 12 / k, nothing outside half the size, X and Y uncorrelated.
// The taps' bytes of every number of taps, 2^30 bits on in the register, pixel after pixel.
TEST(TapNoise, EqualsTheRegistersBytes) {
    MachineSpec spec;
    spec.xy_bits = 5;
    for (int taps = 0; taps <= max_taps; ++taps) {
        TapNoise source(0x2bcdef01, taps, spec, 3, 2);
        fixed::NoiseRegister bits(0x2bcdef01);
        bits.jump(TapNoise::start + (2 * 32 + 3) * 16 * static_cast<std::uint64_t>(taps));
        for (int pixel = 0; pixel < 3; ++pixel) {
            const TapBytes bytes = source.next();
            for (std::size_t t = 0; t < static_cast<std::size_t>(taps); ++t) {
                ASSERT_EQ(bytes.x[t], bits.take(8)) << taps << " taps, tap " << t;
                ASSERT_EQ(bytes.y[t], bits.take(8)) << taps << " taps, tap " << t;
            }
        }
    }
}

TEST(NoiseSource, HasTheMomentsOfItsShape) {
    MachineSpec spec;
    spec.fraction_bits = 12;  // so that the word's own rounding does not show
    for (const DitherShape shape : shapes) {
        const Dither dither{shape, 256, 0x12345678};
        const int count = 1 << 16;
        double sum = 0, squares = 0, cross = 0, max = 0;
        for (int y = 0; y < count / 512; ++y) {
            NoiseSource source(dither, spec, 0, y);
            for (int x = 0; x < 512; ++x) {
                const DitherWords w = source.next();
                const double wx = w.x / 4096.0, wy = w.y / 4096.0;
                sum += wx + wy;
                squares += wx * wx + wy * wy;
                cross += wx * wy;
                max = std::max({max, std::abs(wx), std::abs(wy)});
            }
        }
        const double variance = 1.0 / 12 / uniforms(shape);
        EXPECT_NEAR(sum / (2 * count), 0, 5 * std::sqrt(variance / (2 * count)));
        EXPECT_NEAR(squares / (2 * count) / variance, 1, 0.02);
        EXPECT_NEAR(cross / count / variance, 0, 0.02);
        EXPECT_LE(max, 0.5);
    }
}

}  // namespace
}  // namespace umbra78::hw
