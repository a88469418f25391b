// load_matrix: the smallest exponent that holds the row, words rounded once, and closure.
#include "tests/hw/transform_model.hpp"

#include <gtest/gtest.h>

namespace umbra78::hw {
namespace {

using namespace test;

constexpr WordFormat words_1978{16, 7};

// Rows without a fourth column, so that the unit's scaling of it stays out of the way.
RationalMatrix matrix_of(const std::array<Rational, 3>& row) {
    RationalMatrix m;
    m[0] = {row[0], row[1], row[2], 0};
    m[1] = {0, 1, 0, 0};
    m[2] = {0, 0, 1, 0};
    m[3] = {0, 0, 0, 1};
    return m;
}

TEST(LoadMatrix, WordsAndExponentsOfKnownRows) {
    struct Case {
        Rational c;
        int exponent;
        std::int32_t word;
    };
    const std::array<Case, 9> cases{{
        {1, 0, 1 << 14},
        {2, 1, 1 << 14},
        {-2, 0, -(1 << 15)},                   // the smallest word
        {Rational(1, 2), -1, 1 << 14},
        {Rational(-1, 2), -2, -(1 << 15)},
        {Rational(65535, 32768), 1, 1 << 14},  // 2 - 2^-15 rounds up to 2: one exponent more
        {Rational(32767, 16384), 0, 32767},    // the largest word
        {Rational(1, 3), -2, 21845},           // 1/3 2^16 = 21845.33
        {0, 0, 0},
    }};
    for (const Case& c : cases) {
        MatrixWords m;
        ASSERT_EQ(load_matrix(matrix_of({c.c, 0, 0}), {}, words_1978, m), LoadStatus::ok);
        EXPECT_EQ(m.exponent[0], c.exponent);
        EXPECT_EQ(m.word[0][0], c.word);
        EXPECT_TRUE(m.affine);
    }
}

// The model tries every exponent from the smallest one on.
TEST(LoadMatrix, TakesTheSmallestExponentThatFits) {
    Random random;
    for (int n = 0; n < 4000; ++n) {
        const MachineSpec spec = random_spec(random);
        const auto denominator = random.between(1, 1 << 20);
        std::array<std::int64_t, 3> row{};
        for (std::int64_t& c : row) {
            c = random.between(-(1 << 30), 1 << 30) >> random.between(0, 30);
            if (random.bits() % 4 == 0)
                c = -denominator * (std::int64_t{1} << random.between(0, 8));
        }
        if (row[0] == 0 && row[1] == 0 && row[2] == 0) continue;
        MatrixWords m;
        ASSERT_EQ(load_matrix(matrix_of({Rational(row[0], denominator),
                                         Rational(row[1], denominator),
                                         Rational(row[2], denominator)}),
                              spec, screen_words(spec), m),
                  LoadStatus::ok);
        const Int128 limit = power_of_two(spec.coefficient_bits - 1);
        for (int e = min_exponent; e <= m.exponent[0]; ++e) {
            bool fits = true;
            for (std::size_t k = 0; k < 3; ++k) {
                const int shift = spec.coefficient_bits - 2 - e;
                const Int128 num = Int128{row[k]} * power_of_two(shift > 0 ? shift : 0);
                const Int128 den = Int128{denominator} * power_of_two(shift < 0 ? -shift : 0);
                const Int128 word = model_round(num, den, spec.coefficient_rounding);
                if (word < -limit || word >= limit) fits = false;
                if (e < m.exponent[0]) continue;
                ASSERT_TRUE(word == m.word[0][k]) << "case " << n;
            }
            ASSERT_EQ(fits, e == m.exponent[0]) << "case " << n << ", exponent " << e;
        }
    }
}

TEST(LoadMatrix, NamesARowOutOfRange) {
    MatrixWords m;
    const Rational limit(std::int64_t{1} << 32);  // words reach below 2 2^31
    EXPECT_EQ(load_matrix(matrix_of({limit - Rational(1 << 20), 0, 0}), {}, words_1978, m),
              LoadStatus::ok);
    EXPECT_EQ(m.exponent[0], max_exponent);
    EXPECT_EQ(load_matrix(matrix_of({limit, 0, 0}), {}, words_1978, m),
              LoadStatus::exponent_out_of_range);
    EXPECT_EQ(load_matrix(matrix_of({-limit, 0, 0}), {}, words_1978, m), LoadStatus::ok);
    // A row too small for the smallest exponent becomes small words, or zero; that is no error.
    const Rational small(1, std::int64_t{1} << 45);
    EXPECT_EQ(load_matrix(matrix_of({small, 0, 0}), {}, words_1978, m), LoadStatus::ok);
    EXPECT_EQ(m.exponent[0], min_exponent);
    EXPECT_EQ(m.word[0][0], 1);
}

// The fourth column holds a translation in units of one_word: +-256 pixels at exponent 0.
TEST(LoadMatrix, TheFourthColumnIsScaledToOneWord) {
    RationalMatrix exact = matrix_of({1, 0, 0});
    const TransformUnit unit = [&](std::int64_t translation_px) {
        exact[0][3] = translation_px;
        MatrixWords m;
        EXPECT_EQ(load_matrix(exact, {}, words_1978, m), LoadStatus::ok);
        EXPECT_EQ(m.exponent[0], translation_px == 256 ? 1 : 0) << translation_px;
        return TransformUnit({}, m);
    }(-256);
    EXPECT_EQ(unit({5 << 7, 0, 0}).x, (5 - 256) * 128);
    exact[0][3] = 255;
    MatrixWords m;
    ASSERT_EQ(load_matrix(exact, {}, words_1978, m), LoadStatus::ok);
    EXPECT_EQ(m.exponent[0], 0);
    EXPECT_EQ(TransformUnit({}, m)({-(5 << 7), 1, 1}).x, (255 - 5) * 128);
}

// An affine matrix given with another w than 1 is divided by it; a scale is a scale.
TEST(LoadMatrix, AnAffineMatrixIsDividedByItsW) {
    RationalMatrix exact = matrix_of({3, -5, Rational(1, 7)});
    MatrixWords plain, scaled;
    ASSERT_EQ(load_matrix(exact, {}, words_1978, plain), LoadStatus::ok);
    for (auto& row : exact)
        for (Rational& c : row) c *= Rational(-22, 7);
    ASSERT_EQ(load_matrix(exact, {}, words_1978, scaled), LoadStatus::ok);
    EXPECT_EQ(plain.word, scaled.word);
    EXPECT_EQ(plain.exponent, scaled.exponent);
}

// Closure: with every word at its minimum or maximum no sum exceeds accumulator_bits, and no shift
// after it overflows at any exponent.
TEST(LoadMatrix, CornerProductsStayWithinTheAccumulator) {
    for (int xy = 4; xy <= 12; xy += 4) {
        for (const int z : {4, 12, 16, 24}) {
            for (const int coefficient : {8, 16, 24, 32}) {
                MachineSpec m;
                m.xy_bits = xy;
                m.z_bits = z;
                m.coefficient_bits = coefficient;
                m.fraction_bits = 12;
                ASSERT_EQ(check(m), SpecStatus::ok);
                const Int128 limit = power_of_two(m.accumulator_bits() - 1);
                const std::int64_t c = std::int64_t{1} << (coefficient - 1);
                const std::int64_t w = std::int64_t{1} << (m.word_bits() - 1);
                for (int corner = 0; corner < 128; ++corner) {
                    const auto pick = [&](int bit, std::int64_t half) {
                        return static_cast<std::int32_t>((corner >> bit & 1) != 0 ? half - 1
                                                                                  : -half);
                    };
                    MatrixWords matrix;
                    for (auto& row : matrix.word)
                        row = {pick(0, c), pick(1, c), pick(2, c), pick(3, c)};
                    matrix.exponent.fill(max_exponent);
                    const Words v{pick(4, w), pick(5, w), pick(6, w)};
                    const Int128 sum = model_sum(matrix, 0, v, m);
                    ASSERT_TRUE(-limit <= sum && sum < limit);
                    ASSERT_TRUE(sum == accumulate(matrix, Row::x, v, m.one_word()));
                    (void)TransformUnit(m, matrix).affine(v);
                }
            }
        }
    }
}

// The divider shifts by at most 62 places, whatever the widths: rows too far from W are refused.
TEST(LoadMatrix, RefusesWhatTheDividerCannotDivide) {
    MachineSpec spec;
    spec.xy_bits = 4;
    spec.z_bits = 24;  // 20 fraction bits
    const auto power = [](int n) {
        return n < 0 ? Rational(1, std::int64_t{1} << -n) : Rational(std::int64_t{1} << n);
    };
    for (int apart = -62; apart <= 62; ++apart) {
        const int row = apart / 2, w = row - apart;
        if (row < min_exponent || w < min_exponent || w > max_exponent) continue;
        RationalMatrix exact = matrix_of({0, 0, 0});
        exact[0] = exact[2] = {power(row), 0, 0, 0};
        exact[3] = {power(w), 0, 0, 0};
        MatrixWords m;
        const LoadStatus status = load_matrix(exact, spec, screen_words(spec), m);
        const bool near = apart >= -42 && apart <= 42;
        ASSERT_EQ(status, near ? LoadStatus::ok : LoadStatus::exponent_out_of_range) << apart;
        if (status == LoadStatus::ok) (void)TransformUnit(spec, m).divided({1, 1, 1});
    }
    RationalMatrix no_w = matrix_of({1, 0, 0});
    no_w[3] = {};
    MatrixWords m;
    EXPECT_EQ(load_matrix(no_w, spec, screen_words(spec), m), LoadStatus::exponent_out_of_range);
}

}  // namespace
}  // namespace umbra78::hw
