// Dither words against words from an independent program, and their exact distribution.
#include "fixed/dither.hpp"

#include <gtest/gtest.h>

#include "fixed/noise.hpp"
#include "tests/fixed/boundary.hpp"

namespace umbra78::fixed {
namespace {

TEST(SumOfUniforms, IsTheSumOfTheLowBytes) {
    test::Random random;
    for (int i = 0; i < 100000; ++i) {
        const std::uint64_t bits = i == 0 ? ~std::uint64_t{0} : random.bits();
        int sum = 0;
        for (int k = 1; k <= 8; ++k) {
            sum += static_cast<int>(bits >> (8 * (k - 1)) & 0xff);
            ASSERT_EQ(sum_of_uniforms(bits, k), sum) << std::hex << bits << " k " << k;
        }
    }
    EXPECT_DEATH(sum_of_uniforms(0, 0), "1..8 uniforms a word");
    EXPECT_DEATH(sum_of_uniforms(0, 9), "1..8 uniforms a word");
}

// Made by an independent program in exact rational arithmetic, from the header's equations.
TEST(DitherWord, First16OfSeed1978) {
    struct Case {
        int uniforms, fraction_bits;
        std::int32_t size_q8, amplitude;
        std::array<int, 16> words;
    };
    const std::array<Case, 3> cases{{
        {1, 7, 256, 16384,
         {29, -60, -64, 0, 19, -62, -64, -44, 53, -63, 0, -61, 53, -64, -44, 18}},
        {4, 7, 256, 4096,
         {-24, -38, -18, -9, 2, -20, -7, -38, -9, 17, -3, -25, -1, -17, -7, -9}},
        {12, 10, 384, 16384,
         {-316, -109, -219, -47, -102, -29, -141, 2, -4, -33, -191, -12, -120, 64, -82, 7}},
    }};
    for (const Case& c : cases) {
        ASSERT_EQ(dither_amplitude(c.uniforms, c.size_q8, c.fraction_bits), c.amplitude);
        NoiseRegister noise(1978);
        for (const int expected : c.words) {
            int sum = 0;
            for (int left = c.uniforms; left > 0; left -= 8) {
                const int now = left < 8 ? left : 8;
                sum += sum_of_uniforms(noise.take(8 * now), now);
            }
            EXPECT_EQ(dither_word(sum, c.uniforms, c.amplitude), expected) << c.uniforms;
        }
    }
}

// A size of one texel stays within half a texel for every shape, comes within 1/64 of it, and is
// symmetric but for the half-up ties. Without fraction bits half a texel rounds up to one.
TEST(DitherWord, StaysWithinHalfATexel) {
    for (int k = 1; k <= max_uniforms; ++k) {
        for (int fraction_bits = 0; fraction_bits <= 14; ++fraction_bits) {
            const std::int32_t amplitude = dither_amplitude(k, 256, fraction_bits);
            const int half = ((1 << fraction_bits) + 1) / 2;
            EXPECT_EQ(dither_amplitude(k, 0, fraction_bits), 0);
            for (int sum = 0; sum <= 255 * k; ++sum) {
                const int word = dither_word(sum, k, amplitude);
                ASSERT_TRUE(word >= -half && word <= half)
                    << "k " << k << " sum " << sum << " word " << word;
                const int mirrored = dither_word(255 * k - sum, k, amplitude);
                ASSERT_TRUE(word == -mirrored || word == 1 - mirrored);
            }
            EXPECT_GE(dither_word(255 * k, k, amplitude), half - half / 64 - 1);
        }
    }
}

TEST(DitherAmplitude, IsTheNearest) {
    test::Random random;
    for (int i = 0; i < 100000; ++i) {
        const auto k = static_cast<int>(random.between(1, 12));
        const auto size = static_cast<std::int32_t>(random.between(0, 65535));
        const auto bits = static_cast<int>(random.between(0, 14));
        const test::Int128 exact = test::model_round(
            test::Int128{size} << (bits + 16), test::Int128{256} * 512 * k, Rounding::half_up);
        ASSERT_EQ(test::Int128{dither_amplitude(k, size, bits)}, exact);
    }
}

template <class Count>
WideInt<4> wide(const Count& count) {
    if constexpr (std::is_same_v<Count, std::uint64_t>) {
        return (WideInt<4>(static_cast<std::int64_t>(count >> 1)) << 1) +
               static_cast<std::int64_t>(count & 1);
    } else {
        return WideInt<4>(count);
    }
}

// Total 2^(8K), symmetric, mean 255 K / 2 and variance K (2^16 - 1) / 12: all exactly.
template <int K>
void expect_distribution() {
    const auto counts = sum_counts<K>();
    WideInt<4> total = 0, moment2 = 0;
    for (std::size_t s = 0; s < counts.size(); ++s) {
        const auto centred = 2 * static_cast<std::int64_t>(s) - 255 * K;
        total += wide(counts[s]);
        moment2 += wide(counts[s]) * (centred * centred);
        ASSERT_EQ(counts[s], counts[counts.size() - 1 - s]) << "K " << K << " sum " << s;
    }
    EXPECT_EQ(total, WideInt<4>(1) << (8 * K)) << "K " << K;
    EXPECT_EQ(moment2 * 3, (WideInt<4>(K * 65535)) << (8 * K)) << "K " << K;  // (2 sigma)^2
    EXPECT_EQ(counts[0], SumCount<K>(1));
    EXPECT_EQ(counts[1], SumCount<K>(K));
}

TEST(SumCounts, MomentsAreExact) {
    expect_distribution<1>();
    expect_distribution<2>();
    expect_distribution<3>();
    expect_distribution<4>();
    expect_distribution<7>();
    expect_distribution<8>();
    expect_distribution<12>();
}

TEST(SumCounts, EqualsCountingAllDrawsOfTwoAndThreeBytes) {
    static_assert(sum_counts<2>()[255] == 256 && sum_counts<2>()[254] == 255);
    const auto two = sum_counts<2>();
    const auto three = sum_counts<3>();
    std::array<std::uint64_t, 511> counted2{};
    std::array<std::uint64_t, 766> counted3{};
    for (std::uint64_t draw = 0; draw < (1u << 24); ++draw) {
        ++counted3[static_cast<std::size_t>(sum_of_uniforms(draw, 3))];
        if (draw < (1u << 16)) {
            ++counted2[static_cast<std::size_t>(sum_of_uniforms(draw, 2))];
        }
    }
    EXPECT_EQ(counted2, two);
    EXPECT_EQ(counted3, three);
}

}  // namespace
}  // namespace umbra78::fixed
