// Float38 against exact rationals, rounded by a model that searches for the nearest word.
#include "fixed/float38.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "tests/fixed/boundary.hpp"

namespace umbra78::fixed {
namespace {

// Wide enough for the sum of any two words, 1023 binades apart.
using Wide = WideInt<24>;


constexpr int lowest_unit = -512 - 27;

// The value in units of the smallest bit that any word has.
Wide in_min_units(const Float38& f) {
    return Wide(f.mantissa()) << f.biased_exponent();
}

// num / den times 2^scale as a word, by the definition: among all words of the binade, the
// nearest, a tie to the even mantissa. Shares nothing with the code under test.
Float38 model(const Wide& num, const Wide& den, int scale) {
    if (num.is_zero()) return {};
    const bool negative = num.is_negative() != den.is_negative();
    const Wide n = num.abs(), d = den.abs();
    // The exponent e of the value's binade, 2^(e-1) <= value < 2^e, by trial.
    int e = n.bit_length() - d.bit_length() - 2;
    const auto below = [&](int k) { return k >= 0 ? n < (d << k) : (n << -k) < d; };
    while (!below(e)) ++e;
    // value / 2^(e - 27) lies in 2^26 .. 2^27.
    const int unit = e - 27;
    const Wide up = unit < 0 ? n << -unit : n, down = unit > 0 ? d << unit : d;
    std::int64_t m = (up / down).to_int64();
    const Wide twice_rest = (up % down) << 1;
    if (twice_rest > down || (twice_rest == down && m % 2 == 1)) ++m;
    e += scale;
    if (m == 1 << 27) {
        m = 1 << 26;
        ++e;
    }
    if (e > 511) return Float38::from_parts(negative ? 1 - (1 << 27) : (1 << 27) - 1, 1023);
    if (e < -512) return {};
    return Float38::from_parts(static_cast<std::int32_t>(negative ? -m : m), e + 512);
}

Float38 model_sum(const Float38& a, const Float38& b) {
    return model(in_min_units(a) + in_min_units(b), 1, lowest_unit);
}
Float38 model_difference(const Float38& a, const Float38& b) {
    return model(in_min_units(a) - in_min_units(b), 1, lowest_unit);
}
Float38 model_product(const Float38& a, const Float38& b) {
    return model(Wide(a.mantissa()) * Wide(b.mantissa()), 1,
                 a.biased_exponent() + b.biased_exponent() + 2 * lowest_unit);
}
Float38 model_quotient(const Float38& a, const Float38& b) {
    if (a.is_zero()) return {};
    if (b.is_zero())
        return Float38::from_parts(a.is_negative() ? 1 - (1 << 27) : (1 << 27) - 1, 1023);
    return model(a.mantissa(), b.mantissa(), a.biased_exponent() - b.biased_exponent());
}

void expect_same(const char* what, const Float38& a, const Float38& b, const Float38& got,
                 const Float38& expected) {
    ASSERT_EQ(got.bits(), expected.bits())
        << std::hex << a.bits() << what << b.bits() << ": " << got.bits() << ", model "
        << expected.bits();
}
void expect_all(const Float38& a, const Float38& b) {
    expect_same(" + ", a, b, a + b, model_sum(a, b));
    expect_same(" - ", a, b, a - b, model_difference(a, b));
    expect_same(" * ", a, b, a * b, model_product(a, b));
    expect_same(" / ", a, b, a / b, model_quotient(a, b));
    ASSERT_EQ(a <=> b, in_min_units(a) <=> in_min_units(b))
        << std::hex << a.bits() << " " << b.bits();
}

// Mantissas at which carries, signs and normalisation change; and exponents at the range's ends.
const std::vector<std::int32_t> mantissas{
    0,
    1,                       // unnormalised, the smallest
    0x5555555 >> 1,          // alternating
    (1 << 26) - 1,           // just unnormalised
    1 << 26,                 // 1/2, the smallest normalised
    (1 << 26) + 1,
    (1 << 27) - 2,
    (1 << 27) - 1,           // the largest
    -1,
    -(1 << 26) + 1,
    -(1 << 26),
    -(1 << 26) - 1,
    -(1 << 27) + 1,          // the smallest normalised
    -(1 << 27),              // -1: a mantissa the two's complement has and no result is given
};
const std::vector<int> exponents{0,   1,   2,   26,  27,  28,   484, 485,
                                 511, 512, 513, 540, 1000, 1022, 1023};

std::vector<Float38> boundary() {
    std::vector<Float38> all;
    for (const std::int32_t m : mantissas)
        for (const int e : exponents) all.push_back(Float38::from_parts(m, e));
    return all;
}

TEST(Float38, BoundariesAgreeWithTheModel) {
    const std::vector<Float38> all = boundary();
    for (const Float38& a : all)
        for (const Float38& b : all) expect_all(a, b);
}

Float38 any(test::Random& random) {
    const auto m = static_cast<std::int32_t>(random.between(-(1 << 27), (1 << 27) - 1));
    const int shorter = random.bits() % 4 == 0 ? static_cast<int>(random.between(0, 27)) : 0;
    return Float38::from_parts(m >> shorter, static_cast<int>(random.between(0, 1023)));
}

TEST(Float38, RandomWordsAgreeWithTheModel) {
    test::Random random;
    for (int i = 0; i < 60000; ++i) {
        const Float38 a = any(random);
        Float38 b = any(random);
        if (i % 4 != 0) {  // close enough to meet in the adder
            const auto e = a.biased_exponent() + random.between(-34, 34);
            b = Float38::from_parts(b.mantissa(), static_cast<int>(clamp(e, 0, 1023)));
        }
        expect_all(a, b);
    }
}

// Every alignment distance, with operands chosen for ties and for long cancellations.
TEST(Float38, EveryAlignmentAgreesWithTheModel) {
    for (int apart = 0; apart <= 70; ++apart) {
        for (const std::int32_t m : mantissas) {
            for (const std::int32_t n : mantissas) {
                const Float38 a = Float38::from_parts(m, 600);
                const Float38 b = Float38::from_parts(n, 600 - apart);
                expect_all(a, b);
                expect_all(b, a);
            }
        }
    }
}

TEST(Float38, EveryHostWordFloatsExactlyAndComesBack) {
    for (std::int32_t w = INT16_MIN; w <= INT16_MAX; ++w) {
        const Float38 raw = Float38::from_host(static_cast<std::int16_t>(w));
        const Float38 f = raw.normalised();
        ASSERT_EQ(raw.mantissa(), w);
        ASSERT_EQ(raw, f);
        ASSERT_EQ(f.bits(), model(w, 1, 0).bits()) << w;
        ASSERT_EQ(f.fix(16), w);
        ASSERT_EQ(raw.fix(16), w);
        ASSERT_EQ((raw * Float38::from_scaled(1, -7)).bits(), model(w, 128, 0).bits()) << w;
    }
}

// Halves, and quarters around them, of every 16-bit word.
TEST(Float38, FixRoundsConvergentlyOrTowardZero) {
    for (std::int32_t w = 4 * INT16_MIN; w <= 4 * INT16_MAX + 3; ++w) {
        const Float38 f = Float38::from_scaled(w, -2);
        const auto nearest =
            static_cast<std::int64_t>(test::model_round(w, 4, Rounding::half_even));
        ASSERT_EQ(f.fix(16), nearest <= 32767 ? nearest : 32767) << w;
        ASSERT_EQ(f.fix(16, Rounding::to_zero), w / 4) << w;
    }
    EXPECT_EQ(Float38::from_scaled(-32769, 0).fix(16), -32767) << "the signed maximum";
    EXPECT_EQ(Float38::largest(false).fix(32), INT32_MAX);
    EXPECT_EQ(Float38::largest(true).fix(16), -32767);
    EXPECT_EQ(Float38::from_parts(1 << 26, 0).fix(16), 0);
    EXPECT_EQ(Float38::from_parts(-(1 << 26), 0).fix(16, Rounding::to_zero), 0);
}

TEST(Float38, RationalsAreRoundedOnce) {
    test::Random random;
    for (int i = 0; i < 20000; ++i) {
        const std::int64_t num = random.word(), den = random.between(1, INT64_MAX);
        ASSERT_EQ(Float38::from_rational(Rational(num, den)).bits(),
                  model(num, den, 0).bits())
            << num << " / " << den;
    }
    static_assert(Float38::from_rational(Rational(1, 3)).mantissa() == 89478485);
    static_assert(Float38::from_rational(Rational(1, 3)).biased_exponent() == 511);
    // Halfway between two words: to the even one.
    constexpr std::int64_t odd = (1 << 26) + 1;
    static_assert(Float38::from_rational(Rational(2 * odd + 1, 2)).mantissa() == odd + 1);
    static_assert(Float38::from_rational(Rational(2 * odd - 1, 2)).mantissa() == odd - 1);
    static_assert(Float38::from_rational(Rational((1 << 28) - 1, 2)).mantissa() == 1 << 26);
}

// All pairs of eight-bit mantissas, three exponents apart at most: every tie and carry of so short
// numbers, brought to the word's low end by a third addend.
TEST(Float38, ShortMantissasExhaustively) {
    const Float38 big = Float38::from_scaled(1, 24);
    for (int m = -128; m < 128; ++m) {
        for (int n = -128; n < 128; ++n) {
            const Float38 a = Float38::from_scaled(m, -5), b = Float38::from_scaled(n, -3);
            ASSERT_EQ((a + b).bits(), model(m + 4 * n, 32, 0).bits());
            ASSERT_EQ((a * b).bits(), model(m * n, 256, 0).bits());
            ASSERT_EQ(((big + a) + b).bits(), model_sum(model_sum(big, a), b).bits());
            if (n != 0) {
                ASSERT_EQ((a / b).bits(), model(m, 4 * n, 0).bits());
            }
        }
    }
}

TEST(Float38, RangeEndsAtTheSignedMaximumAndAtZero) {
    constexpr Float38 max = Float38::largest(false), min = Float38::from_parts(1 << 26, 0);
    static_assert((max + max).bits() == max.bits() && (max * max).bits() == max.bits());
    static_assert((Float38() - max - max).bits() == Float38::largest(true).bits());
    static_assert((min * min).is_zero() && (min * min).bits() == 0);
    static_assert((min / max).is_zero() && (max / min).bits() == max.bits());
    static_assert((max / Float38()).bits() == max.bits() && (Float38() / Float38()).bits() == 0);
    static_assert((Float38::largest(true) / Float38()).bits() == Float38::largest(true).bits());
    static_assert(!test::is_constant([] { return Float38::from_parts(1 << 27, 0); }));
    static_assert(!test::is_constant([] { return Float38::from_parts(0, 1024); }));
}

}  // namespace
}  // namespace umbra78::fixed
