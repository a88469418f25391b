// Every rounding mode against a model that searches for the nearest integer.
#include "fixed/rounding.hpp"

#include <gtest/gtest.h>

#include "tests/fixed/boundary.hpp"

namespace umbra78::fixed {
namespace {

using test::Int128;

// The table of the header: -1.5, -0.5, 0.5, 1.5, 2.25 in every mode.
TEST(Rounding, TableOfTheHeader) {
    constexpr std::array<std::array<std::int64_t, 5>, 7> expected{{{-2, -1, 0, 1, 2},
                                                                   {-1, 0, 1, 2, 3},
                                                                   {-1, 0, 0, 1, 2},
                                                                   {-1, 0, 1, 2, 2},
                                                                   {-1, 0, 0, 1, 2},
                                                                   {-2, -1, 1, 2, 2},
                                                                   {-2, 0, 0, 2, 2}}};
    constexpr std::array<std::int64_t, 5> quarters{-6, -2, 2, 6, 9};
    for (std::size_t mode = 0; mode < 7; ++mode) {
        for (std::size_t i = 0; i < 5; ++i) {
            EXPECT_EQ(round_shift(quarters[i], 2, test::all_roundings[mode]), expected[mode][i])
                << "mode " << mode << ", " << quarters[i] << "/4";
        }
    }
}

TEST(RoundShift, BoundaryWordsAtEveryShift) {
    for (const std::int64_t v : test::boundary_words) {
        for (int n = 0; n <= 62; ++n) {
            for (const Rounding r : test::all_roundings) {
                ASSERT_EQ(Int128{round_shift(v, n, r)},
                          test::model_round(v, Int128{1} << n, r))
                    << v << " >> " << n << " mode " << static_cast<int>(r);
            }
        }
    }
}

TEST(RoundShift, Every16BitWord) {
    for (std::int64_t v = INT16_MIN; v <= INT16_MAX; ++v) {
        for (const int n : {0, 1, 2, 7, 15, 16, 17}) {
            for (const Rounding r : test::all_roundings) {
                ASSERT_EQ(Int128{round_shift(v, n, r)},
                          test::model_round(v, Int128{1} << n, r))
                    << v << " >> " << n << " mode " << static_cast<int>(r);
            }
        }
    }
}

TEST(RoundShift, RandomWords) {
    test::Random random;
    for (int i = 0; i < 300000; ++i) {
        const std::int64_t v = random.word();
        const auto n = static_cast<int>(random.between(0, 62));
        const Rounding r = random.rounding();
        ASSERT_EQ(Int128{round_shift(v, n, r)}, test::model_round(v, Int128{1} << n, r))
            << v << " >> " << n << " mode " << static_cast<int>(r);
    }
}

// Every 16-bit word at every shift; the boundary words of the wider types.
TEST(FloorShift, EqualsTheModel) {
    static_assert(floor_shift(-1, 5) == -1 && floor_shift(std::int64_t{-33}, 5) == -2);
    static_assert(std::is_same_v<decltype(floor_shift(std::int16_t{1}, 1)), std::int16_t>);
    for (int v = INT16_MIN; v <= INT16_MAX; ++v) {
        for (int n = 0; n <= 15; ++n) {
            const Int128 expected = test::model_round(v, Int128{1} << n, Rounding::floor);
            ASSERT_EQ(Int128{floor_shift(static_cast<std::int16_t>(v), n)}, expected) << v << n;
            ASSERT_EQ(Int128{floor_shift(v, n)}, expected) << v << " >> " << n;
        }
    }
    for (const std::int64_t v : test::boundary_words) {
        for (int n = 0; n <= 63; ++n) {
            ASSERT_EQ(Int128{floor_shift(v, n)},
                      test::model_round(v, Int128{1} << n, Rounding::floor))
                << v << " >> " << n;
        }
    }
}

TEST(ScaleShift, EqualsTheModelAtEveryRightShift) {
    for (const std::int64_t v : test::boundary_words) {
        for (int n = 0; n <= 124; ++n) {
            for (const Rounding r : test::all_roundings) {
                ASSERT_EQ(Int128{scale_shift(v, n, r)},
                          test::model_round(v, Int128{1} << n, r))
                    << v << " >> " << n << " mode " << static_cast<int>(r);
            }
        }
        EXPECT_EQ(scale_shift(v, INT32_MAX, Rounding::floor), v < 0 ? -1 : 0);
        EXPECT_EQ(scale_shift(v, INT32_MAX, Rounding::half_away), 0);
    }
}

TEST(ScaleShift, LeftIsExactOrTraps) {
    test::Random random;
    for (int i = 0; i < 100000; ++i) {
        const std::int64_t v = random.word();
        const auto n = static_cast<int>(random.between(0, 63));
        const Int128 exact = Int128{v} * (Int128{1} << n);
        if (exact >= INT64_MIN && exact <= INT64_MAX) {
            ASSERT_EQ(Int128{scale_shift(v, -n, Rounding::floor)}, exact) << v << " << " << n;
        }
    }
    EXPECT_EQ(scale_shift(0, INT32_MIN, Rounding::floor), 0);
    EXPECT_EQ(scale_shift(-1, -63, Rounding::floor), INT64_MIN);
    EXPECT_DEATH(scale_shift(1, -63, Rounding::floor), "left shift does not fit");
    EXPECT_DEATH(scale_shift(-1, -64, Rounding::floor), "left shift does not fit");
    EXPECT_DEATH(scale_shift(INT64_MAX, -1, Rounding::floor), "left shift does not fit");
    EXPECT_DEATH(scale_shift(INT64_MIN, -1, Rounding::floor), "left shift does not fit");
}

TEST(RoundDivide, BoundaryPairs) {
    for (const std::int64_t num : test::boundary_words) {
        for (const std::int64_t den : test::boundary_words) {
            if (den == 0 || (num == INT64_MIN && den == -1)) {
                continue;
            }
            for (const Rounding r : test::all_roundings) {
                // The model wants a positive divisor; num/den = -num/-den.
                const Int128 sign = den < 0 ? -1 : 1;
                ASSERT_EQ(Int128{round_divide(num, den, r)},
                          test::model_round(num * sign, den * sign, r))
                    << num << " / " << den << " mode " << static_cast<int>(r);
            }
        }
    }
}

TEST(RoundDivide, SmallPairsAndRandomPairs) {
    test::Random random;
    for (std::int64_t num = -128; num < 128; ++num) {
        for (std::int64_t den = -128; den < 128; ++den) {
            for (const Rounding r : test::all_roundings) {
                if (den != 0) {
                    const Int128 sign = den < 0 ? -1 : 1;
                    ASSERT_EQ(Int128{round_divide(num, den, r)},
                              test::model_round(num * sign, den * sign, r))
                        << num << " / " << den << " mode " << static_cast<int>(r);
                }
            }
        }
    }
    for (int i = 0; i < 200000; ++i) {
        const std::int64_t num = random.word(), den = random.word();
        const Rounding r = random.rounding();
        if (den != 0 && (num != INT64_MIN || den != -1)) {
            const Int128 sign = den < 0 ? -1 : 1;
            ASSERT_EQ(Int128{round_divide(num, den, r)},
                      test::model_round(num * sign, den * sign, r))
                << num << " / " << den << " mode " << static_cast<int>(r);
        }
    }
}

// Of |quotient| <= 1/2 only ties decide; den = -2^63 is its own hardest case.
TEST(RoundDivide, ByTheLeastWord) {
    EXPECT_EQ(round_divide(std::int64_t{1} << 62, INT64_MIN, Rounding::half_up), 0);
    EXPECT_EQ(round_divide(std::int64_t{1} << 62, INT64_MIN, Rounding::half_away), -1);
    EXPECT_EQ(round_divide(INT64_MIN, INT64_MIN, Rounding::floor), 1);
    EXPECT_EQ(round_divide(INT64_MAX, INT64_MIN, Rounding::to_zero), 0);
    EXPECT_EQ(round_divide(INT64_MAX, INT64_MIN, Rounding::floor), -1);
}

TEST(Rounding, ContractsAreCompileErrorsAndTraps) {
    constexpr auto f = Rounding::floor;
    static_assert(test::is_constant([] { return round_shift(5, 62, f); }));
    static_assert(!test::is_constant([] { return round_shift(5, 63, f); }));
    static_assert(!test::is_constant([] { return round_shift(5, -1, f); }));
    static_assert(!test::is_constant([] { return scale_shift(5, -62, f); }));
    static_assert(!test::is_constant([] { return round_divide(5, 0, f); }));
    EXPECT_DEATH(round_shift(5, 63, f), "shift outside 0..62");
    EXPECT_DEATH(round_shift(5, -1, f), "shift outside 0..62");
    EXPECT_DEATH(round_divide(5, 0, f), "division by zero");
    EXPECT_DEATH(round_divide(INT64_MIN, -1, f), "does not fit");
}

TEST(Magnitude, OfTheBoundaryWords) {
    for (const std::int64_t v : test::boundary_words) {
        EXPECT_EQ(Int128{magnitude(v)}, v < 0 ? -Int128{v} : Int128{v});
    }
}

}  // namespace
}  // namespace umbra78::fixed
