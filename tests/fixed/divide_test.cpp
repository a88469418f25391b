// The divider against a model that searches for the quotient, and its certificate.
#include "fixed/divide.hpp"

#include <gtest/gtest.h>

#include "tests/fixed/boundary.hpp"

namespace umbra78::fixed {
namespace {

using test::Int128;

// num 2^shift / den with both sides made integers. |num| 2^62 < 2^126.
Int128 model_quotient(std::int64_t num, std::int64_t den, int shift, Rounding r) {
    const Int128 n = shift > 0 ? Int128{num} * (Int128{1} << shift) : Int128{num};
    const Int128 d = shift < 0 ? Int128{den} * (Int128{1} << -shift) : Int128{den};
    return test::model_round(n, d, r);
}

void expect_quotient(std::int64_t num, std::int64_t den, int shift, int bits, Rounding r) {
    const Quotient got = divide(num, den, shift, bits, r);
    if (den <= 0) {
        ASSERT_EQ(got, (Quotient{0, DivideStatus::divisor_not_positive}));
        return;
    }
    const Int128 exact = model_quotient(num, den, shift, r);
    const Int128 high = (Int128{1} << (bits - 1)) - 1, low = -high - 1;
    const bool fit = exact >= low && exact <= high;
    ASSERT_EQ(Int128{got.value}, exact < low ? low : exact > high ? high : exact)
        << num << " 2^" << shift << " / " << den << " in " << bits << " bits, mode "
        << static_cast<int>(r);
    ASSERT_EQ(got.status, fit ? DivideStatus::ok : DivideStatus::overflow)
        << num << " 2^" << shift << " / " << den << " in " << bits << " bits";
}

TEST(Divide, BoundaryPairsAtEveryShift) {
    for (const std::int64_t num : test::boundary_words) {
        for (const std::int64_t den : test::boundary_words) {
            for (const int shift :
                 {-62, -61, -33, -32, -31, -2, -1, 0, 1, 2, 7, 31, 32, 33, 61, 62}) {
                for (const Rounding r : test::all_roundings) {
                    expect_quotient(num, den, shift, 63, r);
                }
                expect_quotient(num, den, shift, 16, Rounding::half_up);
                expect_quotient(num, den, shift, 1, Rounding::half_up);
            }
        }
    }
}

TEST(Divide, Every16BitDividendBySmallDivisors) {
    for (std::int64_t num = INT16_MIN; num <= INT16_MAX; ++num) {
        for (const std::int64_t den : {1, 2, 3, 4, 6, 7, 255, 32767}) {
            for (const int shift : {-3, 0, 7}) {
                expect_quotient(num, den, shift, 16, Rounding::half_up);
                expect_quotient(num, den, shift, 16, Rounding::half_even);
            }
        }
    }
}

TEST(Divide, RandomOperands) {
    test::Random random;
    for (int i = 0; i < 400000; ++i) {
        expect_quotient(random.word(), random.word(), static_cast<int>(random.between(-62, 62)),
                        static_cast<int>(random.between(1, 63)), random.rounding());
    }
}

// Exact ties and their neighbours: num 2^shift = (2q + 1) den / 2 + {-1, 0, 1}.
TEST(Divide, TiesAndTheirNeighbours) {
    test::Random random;
    for (int i = 0; i < 200000; ++i) {
        const std::int64_t q = random.word() >> 33, den = 2 * random.between(1, 1 << 29);
        const std::int64_t tie = q * den + den / 2;
        const auto up = static_cast<int>(random.between(0, 2));
        for (const std::int64_t num : {tie - 1, tie, tie + 1}) {
            expect_quotient(num, den, 0, 63, random.rounding());
            expect_quotient(num, den << up, up, 63, random.rounding());  // the same quotient
        }
    }
}

// The fast and the wide path give the same quotient of the same fraction: scaling num and den by
// 2^k pushes num 2^shift beyond 64 bits and changes nothing.
TEST(Divide, WidePathEqualsFastPath) {
    test::Random random;
    for (int i = 0; i < 200000; ++i) {
        const std::int64_t num = random.word() >> 40, den = random.between(1, 1 << 24);
        const Rounding r = random.rounding();
        ASSERT_EQ(divide(num, den, 24, 48, r), divide(num << 38, den << 38, 24, 48, r))
            << num << " / " << den;
    }
}

// The integers at most half a divisor away are the two ways to round to nearest, and no others.
bool model_certificate(std::int64_t num, std::int64_t den, int shift, std::int64_t q) {
    return den > 0 && (q == model_quotient(num, den, shift, Rounding::half_to_zero) ||
                       q == model_quotient(num, den, shift, Rounding::half_away));
}

TEST(Certificate, HoldsForEveryQuotientToNearestAndForNoOther) {
    test::Random random;
    int checked = 0;
    for (int i = 0; i < 200000; ++i) {
        const std::int64_t num = random.word(), den = random.word();
        const auto shift = static_cast<int>(random.between(-62, 62));
        const Quotient q = divide(num, den, shift, 63, Rounding::half_even);
        if (q.status != DivideStatus::ok) {
            continue;
        }
        ++checked;
        ASSERT_TRUE(certificate_holds(num, den, shift, q.value))
            << num << " 2^" << shift << " / " << den;
        for (const std::int64_t other : {q.value - 1, q.value + 1, random.word()}) {
            ASSERT_EQ(certificate_holds(num, den, shift, other),
                      model_certificate(num, den, shift, other))
                << num << " 2^" << shift << " / " << den << " = " << other << "?";
        }
    }
    EXPECT_GT(checked, 20000);
}

TEST(Certificate, TiesHaveTwoAndExactQuotientsOne) {
    static_assert(certificate_holds(5, 2, 0, 2) && certificate_holds(5, 2, 0, 3));
    static_assert(!certificate_holds(5, 2, 0, 1) && !certificate_holds(5, 2, 0, 4));
    static_assert(certificate_holds(6, 2, 0, 3) && !certificate_holds(6, 2, 0, 2));
    static_assert(certificate_holds(-5, 2, -1, -1) && !certificate_holds(-5, 2, -1, -2));
    static_assert(!certificate_holds(0, 0, 0, 0) && !certificate_holds(0, -1, 0, 0));
    // Products that leave 64 bits, and would agree modulo 2^64.
    EXPECT_FALSE(certificate_holds(0, std::int64_t{1} << 62, 0, 4));
    EXPECT_FALSE(certificate_holds(INT64_MIN, INT64_MAX, 0, 1));
    EXPECT_TRUE(certificate_holds(INT64_MIN, INT64_MAX, 0, -1));
    // -2^125 / (2^63 - 1) = -2^62 - 1/2 - 2^-64 - ...: the nearest is the lower one, just.
    EXPECT_FALSE(certificate_holds(INT64_MIN, INT64_MAX, 62, -(std::int64_t{1} << 62)));
    EXPECT_TRUE(certificate_holds(INT64_MIN, INT64_MAX, 62, -(std::int64_t{1} << 62) - 1));
}

TEST(Divide, ContractsAreCompileErrorsAndTraps) {
    static_assert(divide(1, 3, 8, 16) == Quotient{85, DivideStatus::ok});
    static_assert(divide(1, 0, 8, 16) == Quotient{0, DivideStatus::divisor_not_positive});
    static_assert(divide(-300, 1, 8, 16) == Quotient{-32768, DivideStatus::overflow});
    static_assert(!test::is_constant([] { return divide(1, 3, 63, 16).value; }));
    static_assert(!test::is_constant([] { return divide(1, 3, -63, 16).value; }));
    static_assert(!test::is_constant([] { return divide(1, 3, 0, 64).value; }));
    static_assert(!test::is_constant([] { return divide(1, 3, 0, 0).value; }));
    EXPECT_DEATH(divide(1, 3, 63, 16), "shift outside");
    EXPECT_DEATH(divide(1, 3, 0, 64), "width outside");
    EXPECT_DEATH(certificate_holds(1, 3, 63, 0), "shift outside");
}

}  // namespace
}  // namespace umbra78::fixed
