#include "fixed/accumulate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/fixed/boundary.hpp"

namespace umbra78::fixed {
namespace {

using test::Int128;

TEST(AccumulatorShape, WidthsOfTheMachine) {
    static_assert(AccumulatorShape{16, 16, 1, 35}.bits_needed() == 32);
    static_assert(AccumulatorShape{16, 16, 4, 35}.bits_needed() == 34);
    static_assert(AccumulatorShape{16, 16, 15, 35}.closed());
    static_assert(!AccumulatorShape{16, 16, 16, 35}.closed());
    static_assert(AccumulatorShape{24, 17, 4, 64}.bits_needed() == 43);
    static_assert(AccumulatorShape{32, 32, 4, 64}.bits_needed() == 66);
}

// The needed width is exactly the width of the largest sum there is: it fits, and in one bit less
// it does not.
TEST(AccumulatorShape, NeededWidthIsTight) {
    for (int a = 1; a <= 24; ++a) {
        for (int b = 1; b <= 24; ++b) {
            for (int n = 1; n <= 40; ++n) {
                const AccumulatorShape shape{a, b, n, 64};
                const std::int64_t largest = n * min_signed(a) * min_signed(b);
                ASSERT_TRUE(fits(largest, shape.bits_needed())) << a << " " << b << " " << n;
                ASSERT_FALSE(fits(largest, shape.bits_needed() - 1)) << a << " " << b << " " << n;
            }
        }
    }
}

TEST(Accumulator, SumsExactlyInAnyOrder) {
    test::Random random;
    for (int i = 0; i < 5000; ++i) {
        std::vector<std::pair<std::int64_t, std::int64_t>> factors(
            static_cast<std::size_t>(random.between(1, 15)));
        Int128 exact = 0;
        for (auto& [a, b] : factors) {
            a = wrap(random.word(), 16);
            b = wrap(random.word(), 16);
            exact += a * b;
        }
        Accumulator forward({16, 16, 15, 35}), backward({16, 16, 15, 35});
        Accumulator<WideInt<2>> wide({16, 16, 15, 35});
        for (const auto& [a, b] : factors) {
            forward.multiply_add(a, b);
            wide.multiply_add(b, a);
        }
        std::reverse(factors.begin(), factors.end());
        for (const auto& [a, b] : factors) {
            backward.multiply_add(a, b);
        }
        ASSERT_EQ(Int128{forward.sum()}, exact);
        ASSERT_EQ(backward.sum(), forward.sum());
        ASSERT_EQ(wide.sum().to_int64(), forward.sum());
        ASSERT_EQ(Int128{forward.rounded(14, Rounding::half_even)},
                  test::model_round(exact, 1 << 14, Rounding::half_even));
    }
}

TEST(Accumulator, ExtremesBeyond64Bits) {
    Accumulator<WideInt<2>> wide({32, 32, 4, 66});
    for (int i = 0; i < 4; ++i) {
        wide.multiply_add(INT32_MIN, INT32_MIN);
    }
    EXPECT_EQ(wide.sum(), WideInt<2>(1) << 64);
    wide.clear();
    EXPECT_TRUE(wide.sum().is_zero());
    wide.multiply_add(INT32_MIN, INT32_MAX);
    EXPECT_EQ(wide.sum().to_int64(), std::int64_t{INT32_MIN} * INT32_MAX);
}

TEST(Accumulator, ContractsAreCompileErrorsAndTraps) {
    static_assert(test::is_constant([] { return Accumulator({16, 16, 4, 34}).sum(); }));
    static_assert(!test::is_constant([] { return Accumulator({16, 16, 4, 33}).sum(); }));
    static_assert(!test::is_constant([] { return Accumulator({32, 32, 4, 66}).sum(); }));
    EXPECT_DEATH(Accumulator({16, 16, 16, 35}), "");
    EXPECT_DEATH(Accumulator({32, 32, 4, 66}), "");
    EXPECT_DEATH(Accumulator({16, 16, 0, 35}), "");
    Accumulator two({16, 16, 2, 35});
    EXPECT_DEATH(two.multiply_add(32768, 1), "");
    EXPECT_DEATH(two.multiply_add(1, -32769), "");
    two.multiply_add(1, 1);
    two.multiply_add(1, 1);
    EXPECT_DEATH(two.multiply_add(1, 1), "");
    two.clear();
    two.multiply_add(-32768, 32767);
    EXPECT_EQ(two.sum(), std::int64_t{-32768} * 32767);
}

}  // namespace
}  // namespace umbra78::fixed
