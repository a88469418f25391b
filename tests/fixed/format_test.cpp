#include "fixed/format.hpp"

#include <gtest/gtest.h>

#include "tests/fixed/boundary.hpp"

namespace umbra78::fixed {
namespace {

using test::Int128;

Int128 low_word(Format f) {
    return f.is_signed ? -(Int128{1} << (f.integer_bits + f.fraction_bits)) : Int128{0};
}
Int128 high_word(Format f) { return (Int128{1} << (f.integer_bits + f.fraction_bits)) - 1; }

Format any_format(test::Random& random) {
    const bool is_signed = random.between(0, 1) == 1;
    const auto value_bits = static_cast<int>(random.between(1, 63));
    const auto fraction = static_cast<int>(random.between(0, value_bits));
    return {value_bits - fraction, fraction, is_signed};
}

TEST(Format, Intervals) {
    static_assert(signed_format(8, 7).width() == 16);
    static_assert(signed_format(8, 7).min_word() == INT16_MIN);
    static_assert(signed_format(8, 7).max_word() == INT16_MAX);
    static_assert(unsigned_format(0, 16).max_word() == UINT16_MAX);
    static_assert(unsigned_format(9, 7).min_word() == 0);
    static_assert(signed_format(0, 0).min_word() == -1 && signed_format(0, 0).max_word() == 0);
    static_assert(signed_format(63, 0).valid() && !signed_format(63, 1).valid());
    static_assert(unsigned_format(63, 0).valid() && !unsigned_format(32, 32).valid());
    static_assert(!unsigned_format(0, 0).valid() && !signed_format(-1, 8).valid());
    test::Random random;
    for (int i = 0; i < 1000; ++i) {
        const Format f = any_format(random);
        ASSERT_TRUE(f.valid());
        ASSERT_EQ(Int128{f.min_word()}, low_word(f));
        ASSERT_EQ(Int128{f.max_word()}, high_word(f));
        const std::int64_t v = random.word();
        ASSERT_EQ(f.holds(v), v >= low_word(f) && v <= high_word(f));
    }
}

// Round the exact value at the target's quantum, then bring it into the target's interval.
Int128 model_convert(std::int64_t word, Format from, Format to, Rounding r, Overflow o) {
    const Int128 scaled = Int128{word} * (Int128{1} << to.fraction_bits);
    const Int128 rounded = test::model_round(scaled, Int128{1} << from.fraction_bits, r);
    const Int128 low = low_word(to), high = high_word(to);
    if (o == Overflow::wrap) {
        const Int128 modulus = high - low + 1;
        return low + ((rounded - low) % modulus + modulus) % modulus;
    }
    const Int128 bottom = o == Overflow::saturate_symmetric && to.is_signed ? -high : low;
    return rounded < bottom ? bottom : rounded > high ? high : rounded;
}

TEST(Convert, RandomFormatsWordsAndModes) {
    test::Random random;
    for (int i = 0; i < 300000; ++i) {
        const Format from = any_format(random), to = any_format(random);
        const std::int64_t word = from.narrow_word(random.word(), Overflow::wrap);
        const Rounding r = random.rounding();
        if (from.fraction_bits == 63 || to.fraction_bits == 63) {
            continue;  // beyond the model's 126 bits
        }
        for (const Overflow o :
             {Overflow::wrap, Overflow::saturate, Overflow::saturate_symmetric}) {
            ASSERT_EQ(Int128{convert(word, from, to, r, o)}, model_convert(word, from, to, r, o))
                << word << " Q" << from.integer_bits << "." << from.fraction_bits << " to Q"
                << to.integer_bits << "." << to.fraction_bits << (to.is_signed ? "" : " unsigned")
                << " overflow " << static_cast<int>(o);
        }
    }
}

TEST(Convert, Every16BitWordFromQ8_7) {
    for (std::int64_t v = INT16_MIN; v <= INT16_MAX; ++v) {
        for (const Format to : {signed_format(8, 7), signed_format(4, 3), signed_format(1, 14),
                                unsigned_format(9, 7), unsigned_format(8, 0)}) {
            for (const Rounding r : test::all_roundings) {
                ASSERT_EQ(
                    Int128{convert(v, signed_format(8, 7), to, r, Overflow::saturate)},
                    model_convert(v, signed_format(8, 7), to, r, Overflow::saturate))
                    << v;
            }
        }
    }
}

constexpr Format q8_7 = signed_format(8, 7), q1_14 = signed_format(1, 14);
constexpr auto up = Rounding::half_up;

TEST(Convert, TrapsWhereItShould) {
    static_assert(convert(128, q8_7, q1_14, up, Overflow::trap) == 1 << 14);
    static_assert(
        !test::is_constant([] { return convert(256, q8_7, q1_14, up, Overflow::trap); }));
    EXPECT_DEATH(convert(256, q8_7, q1_14, up, Overflow::trap), "");
    EXPECT_DEATH(convert(40000, q8_7, q1_14, up, Overflow::wrap), "");
    EXPECT_DEATH(convert(0, q8_7, signed_format(40, 40), up, Overflow::wrap), "");
    // Beyond 64 bits on the way.
    const Format wide = signed_format(63, 0), fine = signed_format(0, 63);
    EXPECT_DEATH(convert(2, wide, fine, up, Overflow::trap), "");
    EXPECT_EQ(convert(2, wide, fine, up, Overflow::saturate), INT64_MAX);
    EXPECT_EQ(convert(-2, wide, fine, up, Overflow::saturate_symmetric), -INT64_MAX);
    EXPECT_EQ(convert(-2, wide, fine, up, Overflow::saturate), INT64_MIN);
    EXPECT_EQ(convert(3, wide, fine, up, Overflow::wrap), INT64_MIN);
    EXPECT_EQ(convert(INT64_MIN, fine, wide, up, Overflow::trap), -1);
    EXPECT_EQ(convert(INT64_MAX, fine, wide, up, Overflow::trap), 1);
}

}  // namespace
}  // namespace umbra78::fixed
