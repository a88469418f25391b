// Exact fractions: the field laws, orders, the one rounding, and values that grow too large.
#include "fixed/rational.hpp"

#include <gtest/gtest.h>

#include "tests/fixed/boundary.hpp"

namespace umbra78::fixed {
namespace {

using test::Int128;

Rational fraction(test::Random& random) {
    std::int64_t den = random.word();
    den = den == 0 ? 1 : den;
    return {random.word(), den};
}

TEST(Rational, Constants) {
    static_assert(Rational(1, 3) + Rational(1, 6) == Rational(1, 2));
    static_assert(Rational(1, 3) - Rational(1, 2) == Rational(-1, 6));
    static_assert(Rational(2, 3) * Rational(9, -4) == Rational(-3, 2));
    static_assert(Rational(2, 3) / Rational(-4, 9) == Rational(-3, 2));
    static_assert(Rational(-1, 2) == Rational(1, -2) && Rational(1, -2) < 0);
    static_assert(Rational(1, 3) < Rational(334, 1000) && Rational(1, 3) > Rational(333, 1000));
    static_assert(Rational(0, -5) == 0 && Rational(0, -5).is_zero());
}

TEST(Rational, FieldIdentitiesHoldExactly) {
    test::Random random;
    for (int i = 0; i < 3000; ++i) {
        const Rational a = fraction(random), b = fraction(random), c = fraction(random);
        ASSERT_EQ((a + b) * c, a * c + b * c);
        ASSERT_EQ(a - b, -(b - a));
        ASSERT_EQ(a + b - b, a);
        if (!b.is_zero()) {
            ASSERT_EQ(a / b * b, a);
        }
        ASSERT_EQ(a < b, (a - b).is_negative());
        ASSERT_FALSE(a.denominator().is_negative());
    }
}

TEST(Rational, ComparisonAgainstCrossProducts) {
    for (const std::int64_t a : test::boundary_words) {
        for (const std::int64_t b : test::boundary_words) {
            const Int128 left = Int128{a} * 3, right = Int128{b} * 7;  // a/7 against b/3
            EXPECT_EQ(Rational(a, 7) < Rational(b, 3), left < right);
            EXPECT_EQ(Rational(a, 7) == Rational(b, 3), left == right);
        }
    }
}

// Unreduced, 1 + 1/2 + ... + 1/200 has the denominator 200!, of 1246 bits; reduced, lcm(1..200).
TEST(Rational, GrowsAndIsReduced) {
    Rational sum = 0;
    for (std::int64_t i = 1; i <= 200; ++i) {
        sum += Rational(1, i);
    }
    EXPECT_LE(sum.denominator().bit_length(), 300);
    for (std::int64_t i = 200; i >= 1; --i) {
        sum -= Rational(1, i);
    }
    EXPECT_TRUE(sum.is_zero());
    EXPECT_EQ(Rational(6, 4).reduced().numerator().to_int64(), 3);
    EXPECT_EQ(Rational(-35, 21).reduced().numerator().to_int64(), -5);
    EXPECT_EQ(Rational(-35, 21).reduced().denominator().to_int64(), 3);
    EXPECT_EQ(Rational(0, 21).reduced().denominator().to_int64(), 1);
}

TEST(Rational, FloorLog2) {
    for (int n = 0; n < 62; ++n) {
        const std::int64_t power = std::int64_t{1} << n;
        EXPECT_EQ(Rational(power).floor_log2(), n);
        EXPECT_EQ(Rational(-power).floor_log2(), n);
        EXPECT_EQ(Rational(1, power).floor_log2(), -n);
        EXPECT_EQ(Rational(power, power + 1).floor_log2(), -1);
        EXPECT_EQ(Rational(power + 1, power).floor_log2(), n == 0 ? 1 : 0);
    }
    EXPECT_EQ(Rational(1, 3).floor_log2(), -2);
    EXPECT_EQ(Rational(INT64_MIN).floor_log2(), 63);
    EXPECT_DEATH((void)Rational(0).floor_log2(), "logarithm of 0");
}

TEST(RoundScaled, EqualsTheModelInEveryMode) {
    test::Random random;
    int fitted = 0;
    for (int i = 0; i < 60000; ++i) {
        const std::int64_t num = random.word(), den = random.between(1, INT32_MAX);
        const auto shift = static_cast<int>(random.between(-62, 62));
        const Rounding r = random.rounding();
        const Int128 n = shift > 0 ? Int128{num} * (Int128{1} << shift) : Int128{num};
        const Int128 d = shift < 0 ? Int128{den} * (Int128{1} << -shift) : Int128{den};
        const Int128 exact = test::model_round(n, d, r);
        const bool fit = exact >= INT64_MIN && exact <= INT64_MAX;
        std::int64_t got = 42;
        ASSERT_EQ(Rational(num, den).round_scaled(shift, r, got), fit)
            << num << "/" << den << " 2^" << shift;
        ASSERT_EQ(Int128{got}, fit ? exact : Int128{42}) << num << "/" << den << " 2^" << shift;
        fitted += fit ? 1 : 0;
    }
    EXPECT_GT(fitted, 20000);
}

TEST(RoundScaled, AtTheEdges) {
    std::int64_t out = 0;
    EXPECT_TRUE(Rational(INT64_MAX).round_scaled(0, Rounding::half_up, out));
    EXPECT_EQ(out, INT64_MAX);
    EXPECT_TRUE(Rational(INT64_MIN).round_scaled(0, Rounding::half_up, out));
    EXPECT_EQ(out, INT64_MIN);
    EXPECT_FALSE((Rational(INT64_MAX) + Rational(1, 2)).round_scaled(0, Rounding::half_up, out));
    EXPECT_TRUE((Rational(INT64_MAX) + Rational(1, 2)).round_scaled(0, Rounding::floor, out));
    EXPECT_TRUE((Rational(INT64_MIN) - Rational(1, 2)).round_scaled(0, Rounding::half_up, out));
    EXPECT_FALSE((Rational(INT64_MIN) - Rational(1, 2)).round_scaled(0, Rounding::floor, out));
    // Far below one quantum, and far beyond every word.
    for (const Rounding r : test::all_roundings) {
        for (const std::int64_t sign : {-1, 1}) {
            ASSERT_TRUE(Rational(sign, 3).round_scaled(-100000, r, out));
            EXPECT_EQ(Int128{out}, test::model_round(sign, 1000, r));
        }
        EXPECT_FALSE(Rational(1, 3).round_scaled(100000, r, out));
        EXPECT_TRUE(Rational(0).round_scaled(100000, r, out));
        EXPECT_EQ(out, 0);
    }
    // 511 bits above 511 bits, scaled up: the operands of the division are the longest there are.
    const Rational::Int longest = (Rational::Int(1) << 510) - 1;
    EXPECT_TRUE(Rational(longest - 1, longest).round_scaled(62, Rounding::ceiling, out));
    EXPECT_EQ(out, std::int64_t{1} << 62);
    EXPECT_TRUE(Rational(longest - 1, longest).round_scaled(62, Rounding::floor, out));
    EXPECT_EQ(out, (std::int64_t{1} << 62) - 1);
}

TEST(Rational, DivisionByZeroIsACompileErrorAndATrap) {
    static_assert(!test::is_constant([] { return Rational(1, 0).is_zero(); }));
    static_assert(!test::is_constant([] { return (Rational(1) / Rational(0)).is_zero(); }));
    EXPECT_DEATH(Rational(1, 0), "division by zero");
    EXPECT_DEATH((void)(Rational(1) / Rational(0)), "division by zero");
}

}  // namespace
}  // namespace umbra78::fixed
