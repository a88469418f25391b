// The square root by its definition: r^2 <= v < (r + 1)^2.
#include "fixed/root.hpp"

#include <gtest/gtest.h>

#include "tests/fixed/boundary.hpp"

namespace umbra78::fixed {
namespace {

using umbra78::test::UInt128;

// The definition: r^2 <= v < (r + 1)^2.
void expect_root(std::uint64_t v) {
    const UInt128 r = isqrt(v);
    ASSERT_TRUE(r * r <= v && v < (r + 1) * (r + 1)) << "isqrt(" << v << ") = " << isqrt(v);
}

// The values around r^2, where the root steps.
void expect_step_at(std::uint64_t r) {
    const std::uint64_t square = r * r;
    ASSERT_EQ(isqrt(square), r);
    ASSERT_EQ(isqrt(square + 2 * r), r);  // (r + 1)^2 - 1
    if (r != 0) {
        ASSERT_EQ(isqrt(square - 1), r - 1);
        ASSERT_EQ(isqrt(square + 1), r);
    }
}

TEST(IntegerRoot, Constants) {
    static_assert(isqrt(0) == 0 && isqrt(1) == 1 && isqrt(2) == 1 && isqrt(3) == 1);
    static_assert(isqrt(4) == 2 && isqrt(99) == 9 && isqrt(100) == 10);
    static_assert(isqrt(UINT64_MAX) == UINT32_MAX);
    static_assert(isqrt(std::uint64_t{UINT32_MAX} * UINT32_MAX - 1) == UINT32_MAX - 1);
}

// The one premise of the proof in the header: |table - sqrt(v)| < 1 on the whole of each interval.
TEST(IntegerRoot, TableIsWithinOne) {
    for (std::uint32_t i = 0; i < 192; ++i) {
        const std::uint32_t root = detail::root_table[i];
        const std::uint32_t low = (i + 64) << 8, high = (i + 65) << 8;
        EXPECT_LT((root - 1) * (root - 1), low) << "entry " << i;
        EXPECT_GE((root + 1) * (root + 1), high) << "entry " << i;
        EXPECT_GE(root, 128u);
    }
}

TEST(IntegerRoot, EveryRootOf16BitsAndEvery16BitWord) {
    for (std::uint64_t r = 0; r <= UINT16_MAX; ++r) {
        expect_step_at(r);
        expect_root(r);
    }
}

TEST(IntegerRoot, StepsUpToTheLast) {
    for (std::uint64_t r = UINT16_MAX; r <= UINT32_MAX; r += 4099) {
        expect_step_at(r);
    }
    for (std::uint64_t r = UINT32_MAX - 4096; r <= UINT32_MAX; ++r) {
        expect_step_at(r);
    }
}

// Both ends of each interval of the table, and every power of two, one to either side.
TEST(IntegerRoot, EdgesOfTheTable) {
    for (std::uint64_t top = 64; top < 256; ++top) {
        for (const std::uint64_t v : {top << 56, (top << 56) - 1, (top << 56) + 1}) {
            for (int shift = 0; shift < 64; ++shift) {
                expect_root(v >> shift);
            }
        }
    }
}

TEST(IntegerRoot, RandomWordsOfEveryLength) {
    test::Random random;
    for (int i = 0; i < 500000; ++i) {
        expect_root(random.bits() >> random.bits() % 64);
        expect_root(static_cast<std::uint64_t>(random.word()));
    }
}

}  // namespace
}  // namespace umbra78::fixed
