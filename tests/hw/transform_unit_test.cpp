// The transform unit against the slow model, its divide's certificate, what rounding first
// costs, the named statuses and the closed-form costs.
#include "hw/transform_unit.hpp"

#include "tests/hw/transform_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace umbra78::hw {
namespace {

using namespace test;

TEST(TransformUnit, AffineRowsAreExactSumsRoundedOnce) {
    Random random;
    for (int n = 0; n < 20000; ++n) {
        const MachineSpec spec = random_spec(random);
        const MatrixWords m = random_matrix(random, spec, true);
        const Words v = random_words(random, spec.word_bits());
        const Point p = TransformUnit(spec, m)(v);
        const std::array<std::int64_t, 3> out{p.x, p.y, p.z};
        for (std::size_t r = 0; r < 3; ++r) {
            const int shift = out_fractions(spec)[r] + m.exponent[r] -
                              (spec.coefficient_bits - 2) - spec.input_fraction();
            const Int128 expected = model_scale(model_sum(m, r, v, spec), shift,
                                                spec.transform_rounding);
            ASSERT_TRUE(expected == out[r]) << "case " << n << ", row " << r << ": unit "
                                            << out[r] << ", model "
                                            << static_cast<std::int64_t>(expected);
        }
        ASSERT_EQ(p.status, DivideStatus::ok);
    }
}

// One product that an accumulator of 22 bits cuts: 3 x 5000 in steps of 2^13, by each rounding.
TEST(TransformUnit, AShortAccumulatorLosesLowBits) {
    MachineSpec spec;
    EXPECT_EQ(spec.dropped_bits(), 0);
    spec.max_accumulator_bits = 22;
    EXPECT_EQ(spec.dropped_bits(), 13);
    EXPECT_EQ(spec.built_bits(), 22);
    MatrixWords m;
    m.word[0] = {3, 0, 0, 0};
    const std::pair<Rounding, std::int64_t> expected[] = {
        {Rounding::floor, 1}, {Rounding::ceiling, 2}, {Rounding::half_up, 2}};
    for (const auto& [rounding, steps] : expected) {
        spec.product_rounding = rounding;
        EXPECT_EQ(accumulate(m, Row::x, {5000, 0, 0}, 0, product_cut(spec)), steps << 13);
    }
    EXPECT_EQ(accumulate(m, Row::x, {5000, 0, 0}, 0), 15000);
}

// Q1.14 times Q8.7 is the identity matrix's word: screen words come out as they went in.
TEST(TransformUnit, TheIdentityIsTheIdentity) {
    RationalMatrix identity;
    for (std::size_t k = 0; k < 4; ++k) identity[k][k] = 1;
    MatrixWords m;
    const MachineSpec spec;
    ASSERT_EQ(load_matrix(identity, spec, screen_words(spec), m), LoadStatus::ok);
    const TransformUnit unit(spec, m);
    for (std::int32_t w = -32768; w <= 32767; ++w) {
        const Point p = unit({w, -w / 2, 32767 - (w & 0x7fff)});
        ASSERT_EQ(p.x, w);
        ASSERT_EQ(p.y, -w / 2);
        ASSERT_EQ(p.z, 32767 - (w & 0x7fff));
    }
}

// 2 |q acc_w - acc_r 2^shift| <= acc_w for each quotient, the statuses where there is none.
TEST(TransformUnit, EachQuotientCarriesItsCertificate) {
    Random random;
    int quotients = 0, behind = 0, overflows = 0;
    for (int n = 0; n < 30000; ++n) {
        MachineSpec spec = random_spec(random);
        spec.transform_rounding = random.bits() % 2 == 0 ? Rounding::half_up : Rounding::half_even;
        MatrixWords m = random_matrix(random, spec, false);
        if (n % 2 == 0)  // a w of moderate size, as views have it
            for (std::size_t c = 0; c < 3; ++c) m.word[3][c] /= 64;
        const Words v = random_words(random, spec.word_bits());
        const Point p = TransformUnit(spec, m)(v);
        const Int128 w = model_sum(m, 3, v, spec);
        if (w <= 0) {
            ASSERT_EQ(p.status, DivideStatus::divisor_not_positive);
            ++behind;
            continue;
        }
        const std::array<std::int64_t, 3> out{p.x, p.y, p.z};
        const std::array<int, 3> bits{spec.xy_bits + spec.fraction_bits + 1,
                                      spec.xy_bits + spec.fraction_bits + 1, spec.z_bits + 1};
        bool overflow = false;
        for (std::size_t r = 0; r < 3; ++r) {
            const int shift = divide_shift(m, static_cast<Row>(r), out_fractions(spec)[r]);
            const Int128 x = model_sum(m, r, v, spec);
            const Int128 num = x * power_of_two(std::max(shift, 0));
            const Int128 den = w * power_of_two(std::max(-shift, 0));
            const Int128 limit = power_of_two(bits[r] - 1);
            const Int128 q = model_round(num, den, spec.transform_rounding);
            if (q < -limit || q >= limit) {
                overflow = true;
                ASSERT_EQ(out[r], static_cast<std::int64_t>(q < 0 ? -limit : limit - 1));
                continue;
            }
            ASSERT_TRUE(q == out[r]) << "case " << n << ", row " << r;
            const Int128 residual = out[r] * den - num;
            ASSERT_TRUE(2 * (residual < 0 ? -residual : residual) <= den);
            ASSERT_TRUE(fixed::certificate_holds(static_cast<std::int64_t>(x),
                                                 static_cast<std::int64_t>(w), shift, out[r]));
            ++quotients;
        }
        ASSERT_EQ(p.status, overflow ? DivideStatus::overflow : DivideStatus::ok) << "case " << n;
        overflows += overflow ? 1 : 0;
    }
    EXPECT_GT(quotients, 10000);
    EXPECT_GT(behind, 5000);
    EXPECT_GT(overflows, 2000);
}

// Error of a quotient in units of its last place, doubled so that a half is an integer.
std::int64_t doubled_error(std::int64_t q, Int128 num, Int128 den) {
    const Int128 residual = 2 * (q * den - num);
    return static_cast<std::int64_t>((residual < 0 ? -residual : residual) / den);
}

// DESIGN, decision 1: exact accumulators stay within 1/2 LSB; x and w rounded first do not.
TEST(TransformUnit, RoundingFirstCosts) {
    Random random;
    const MachineSpec exact;
    MachineSpec first = exact;
    first.divide_order = DivideOrder::round_first;
    std::int64_t worst_exact = 0, worst_first = 0, sum_first = 0, points = 0;
    for (int n = 0; n < 100000; ++n) {
        MatrixWords m = random_matrix(random, exact, false);
        m.exponent.fill(0);
        // |x| and w below 1/4: w's row is small, and still the quotient is a screen coordinate.
        for (auto& row : m.word)
            for (std::int32_t& c : row) c /= 1 << 10;
        const Words v = random_words(random, exact.word_bits());
        const Point a = TransformUnit(exact, m)(v), b = TransformUnit(first, m)(v);
        if (a.status != DivideStatus::ok || b.status != DivideStatus::ok) continue;
        const Int128 num = model_sum(m, 0, v, exact) * power_of_two(7);
        const Int128 den = model_sum(m, 3, v, exact);
        worst_exact = std::max(worst_exact, doubled_error(a.x, num, den));
        const std::int64_t error = doubled_error(b.x, num, den);
        worst_first = std::max(worst_first, error);
        sum_first += error;
        ++points;
    }
    std::cout << "[ measured ] " << points << " quotients: worst error " << worst_exact
              << "/2 LSB exact, " << worst_first / 2 << " LSB rounded first, mean "
              << sum_first / 2 / points << '\n';
    EXPECT_GT(points, 10000);
    EXPECT_LE(worst_exact, 1);
    EXPECT_GT(worst_first, 2 * 64);
}

TEST(TransformUnit, NamesWhatIsNoQuotient) {
    const MachineSpec spec;
    MatrixWords m;
    m.affine = false;
    m.word[0] = {1 << 14, 0, 0, 0};
    m.word[3] = {0, 0, 1 << 14, 0};  // w = z
    const TransformUnit unit(spec, m);
    EXPECT_EQ(unit({100, 0, 0}).status, DivideStatus::divisor_not_positive) << "in the eye's plane";
    EXPECT_EQ(unit({100, 0, -1}).status, DivideStatus::divisor_not_positive) << "behind the eye";
    EXPECT_EQ(unit({512, 0, 1}).status, DivideStatus::overflow) << "512 px: twice the frame's edge";
    EXPECT_EQ(unit({-512, 0, 1}).status, DivideStatus::ok) << "-512 px is the smallest word";
    EXPECT_EQ(unit({-512, 0, 1}).x, -512 * 128);
    EXPECT_EQ(unit({300, 0, 128}).x, 300) << "300/128 px over w = 1";
}

// Row by row: 9 products where both views are affine, 16 where not, in passes of 16 x 16 bits.
TEST(TransformUnit, CostsAreTheClosedForms) {
    const auto cycles = [](int multipliers, int coefficient_bits, int z_bits, bool affine) {
        MachineSpec m;
        m.multipliers = multipliers;
        m.coefficient_bits = coefficient_bits;
        m.z_bits = z_bits;
        return transform_cycles(m, affine);
    };
    EXPECT_EQ(cycles(1, 16, 16, true), 9);
    EXPECT_EQ(cycles(1, 16, 16, false), 16);
    EXPECT_EQ(cycles(4, 16, 16, true), 3);
    EXPECT_EQ(cycles(4, 16, 16, false), 4);
    EXPECT_EQ(cycles(16, 16, 16, true), 1);
    EXPECT_EQ(cycles(4, 24, 16, false), 8) << "24-bit coefficients take two passes";
    EXPECT_EQ(cycles(4, 24, 20, false), 16) << "and wider words two each";
}

}  // namespace
}  // namespace umbra78::hw
