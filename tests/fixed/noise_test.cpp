// The noise register against one that shifts a bit at a time; jumps and the 64-bit stream.
#include "fixed/noise.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "tests/fixed/boundary.hpp"

namespace umbra78::fixed {
namespace {

// The recurrence itself, one bit at a time.
std::vector<bool> model_bits(std::uint32_t seed, std::size_t count) {
    std::vector<bool> b(count);
    for (std::size_t n = 0; n < count; ++n) {
        b[n] = n < 31 ? (seed >> n & 1) != 0 : b[n - 31] != b[n - 28];
    }
    return b;
}
std::uint64_t model_word(const std::vector<bool>& b, std::size_t at, int count) {
    std::uint64_t word = 0;
    for (int i = 0; i < count; ++i) {
        word |= std::uint64_t{b[at + static_cast<std::size_t>(i)]} << i;
    }
    return word;
}

std::uint32_t any_seed(test::Random& random) {
    return static_cast<std::uint32_t>(random.between(1, NoiseRegister::period));
}

TEST(NoiseRegister, FirstWordsOfSeed1978) {
    NoiseRegister noise(1978);
    EXPECT_EQ(noise.take(64), 0x280003a6800007bau);
    EXPECT_EQ(noise.take(64), 0xa32800ea068001e9u);
    EXPECT_EQ(noise.take(64), 0x9369283a6ba6807bu);
    EXPECT_EQ(noise.take(64), 0x3a492326a082069eu);
    noise.jump(1000 - 256);
    EXPECT_EQ(noise.state(), 0x5d232807u);
}

TEST(NoiseRegister, TakesTheRecurrencesBits) {
    test::Random random;
    for (int round = 0; round < 50; ++round) {
        const std::uint32_t seed = any_seed(random);
        const std::vector<bool> b = model_bits(seed, 8000);
        NoiseRegister noise(seed);
        for (std::size_t at = 0; at < 7900;) {
            ASSERT_EQ(noise.state(), model_word(b, at, 31)) << "seed " << seed << " bit " << at;
            const auto count = static_cast<int>(random.between(0, 64));
            ASSERT_EQ(noise.take(count), model_word(b, at, count))
                << "seed " << seed << " bit " << at << " count " << count;
            at += static_cast<std::size_t>(count);
        }
    }
}

TEST(NoiseRegister, JumpIsSteppingSoFar) {
    const std::uint32_t seed = 0x2bad5eed;
    const std::vector<bool> b = model_bits(seed, 70000);
    for (std::size_t at = 0; at <= UINT16_MAX; ++at) {
        NoiseRegister noise(seed);
        noise.jump(at);
        ASSERT_EQ(noise.state(), model_word(b, at, 31)) << "jump of " << at;
    }
}

TEST(NoiseRegister, JumpsAdd) {
    test::Random random;
    for (int i = 0; i < 5000; ++i) {
        const std::uint64_t a = random.bits() >> 1, b = random.bits() >> 1;
        NoiseRegister once(any_seed(random));
        NoiseRegister twice = once;
        once.jump(a + b);
        twice.jump(a);
        twice.jump(b);
        ASSERT_EQ(once, twice) << a << " + " << b;
    }
}

// 2^31 - 1 is prime (Euler 1772). So if a nonzero state comes back after that many bits, and not
// after one, its period is exactly that.
TEST(NoiseRegister, PeriodIs2To31Less1) {
    constexpr NoiseRegister start(1978);
    static_assert([] {
        NoiseRegister noise(1978);
        noise.jump(NoiseRegister::period);
        return noise == NoiseRegister(1978);
    }());
    NoiseRegister noise = start;
    noise.jump(1);
    EXPECT_NE(noise, start);
    noise.jump(NoiseRegister::period - 1);
    EXPECT_EQ(noise, start);
    noise.jump(NoiseRegister::period * 1000003);
    EXPECT_EQ(noise, start);
}

TEST(NoiseStream64, EqualsTheRegister) {
    test::Random random;
    for (int round = 0; round < 50; ++round) {
        NoiseRegister noise(any_seed(random));
        NoiseStream64 stream(noise);
        for (int i = 0; i < 1000; ++i) {
            ASSERT_EQ(stream.next64(), noise.take(64)) << "round " << round << " word " << i;
        }
    }
}

TEST(NoiseRegister, ContractsAreCompileErrorsAndTraps) {
    static_assert(test::is_constant([] { return NoiseRegister(1).state(); }));
    static_assert(!test::is_constant([] { return NoiseRegister(0).state(); }));
    static_assert(!test::is_constant([] { return NoiseRegister(0x80000000).state(); }));
    static_assert(!test::is_constant([] { return NoiseRegister(1).take(65); }));
    EXPECT_DEATH(NoiseRegister(0), "nonzero 31-bit");
    EXPECT_DEATH(NoiseRegister(1).take(-1), "0..64 bits a call");
}

}  // namespace
}  // namespace umbra78::fixed
