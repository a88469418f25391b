// Wide integers against 128-bit ones, and by the laws that need no wider type.
#include "fixed/wide_int.hpp"

#include <gtest/gtest.h>

#include "tests/fixed/boundary.hpp"

namespace umbra78::fixed {
namespace {

using test::Int128;
using Wide2 = WideInt<2>;  // has the tests' 128-bit type as its model
using Wide4 = WideInt<4>;

template <int Limbs>
WideInt<Limbs> from_128(Int128 v) {
    return (WideInt<Limbs>(static_cast<std::int64_t>(v >> 64)) << 64) +
           (WideInt<Limbs>(static_cast<std::int64_t>((v >> 1) & INT64_MAX)) << 1) +
           static_cast<std::int64_t>(v & 1);
}

// 128-bit words with long runs of equal bits, where carries travel.
Int128 word_128(test::Random& random) {
    const auto low = static_cast<Int128>(static_cast<std::uint64_t>(random.word()));
    return Int128{random.word()} * (Int128{1} << 64) + low;
}

void expect_same(Int128 a, Int128 b) {
    const Wide2 x = from_128<2>(a), y = from_128<2>(b);
    Int128 model = 0;
    if (!umbra78::test::sum_overflows(a, b, model)) {
        ASSERT_EQ(x + y, from_128<2>(model));
    }
    if (!umbra78::test::difference_overflows(a, b, model)) {
        ASSERT_EQ(x - y, from_128<2>(model));
    }
    if (!umbra78::test::product_overflows(a, b, model)) {
        ASSERT_EQ(x * y, from_128<2>(model));
        ASSERT_EQ(full_product(x, y), WideInt<4>(x * y));
        if (y.fits_int64()) {
            ASSERT_EQ(x * y.to_int64(), x * y);
            ASSERT_EQ(y.to_int64() * x, x * y);
        }
    }
    constexpr Int128 min = Int128{1} << 126;
    if (b != 0 && (b != -1 || a >= -min)) {
        ASSERT_EQ(x / y, from_128<2>(a / b));
        ASSERT_EQ(x % y, from_128<2>(a % b));
    }
    ASSERT_EQ(x < y, a < b);
    ASSERT_EQ(x == y, a == b);
    ASSERT_EQ(x <= y, a <= b);
    const int right = static_cast<int>(b & 127);
    ASSERT_EQ(x >> right, from_128<2>(a >> right));
}

TEST(WideInt, TwoLimbsAreTheBuiltIn128BitType) {
    test::Random random;
    for (int i = 0; i < 100000; ++i) {
        expect_same(word_128(random), word_128(random));
        expect_same(word_128(random), random.word());
        expect_same(random.word(), random.word());
    }
}

TEST(WideInt, BoundaryPairs) {
    for (const std::int64_t a : test::boundary_words) {
        for (const std::int64_t b : test::boundary_words) {
            expect_same(a, b);
            expect_same(Int128{a} * (Int128{1} << 64) + magnitude(b), b);
            expect_same(Int128{a} * (Int128{1} << 64), Int128{b} * (Int128{1} << 63));
        }
    }
}

// a = q b + r with |r| < |b| and the sign of a defines quotient and remainder, at any width.
TEST(WideInt, DivisionAtFourLimbs) {
    test::Random random;
    for (int i = 0; i < 50000; ++i) {
        const Wide4 b = from_128<4>(word_128(random)) >> static_cast<int>(random.between(0, 127));
        const Wide4 q = from_128<4>(word_128(random)) >> static_cast<int>(random.between(1, 127));
        if (b.is_zero()) {
            continue;
        }
        // Remainders 0, 1 and |b| - 1 are where a quotient digit is guessed wrong.
        for (const Wide4& r : {Wide4(0), Wide4(1), b.abs() - 1, b.abs() >> 1}) {
            const bool negative = b.is_negative() != q.is_negative();
            const Wide4 rest = r < b.abs() ? (negative ? -r : r) : Wide4(0);
            if (q.is_zero() && negative) {
                continue;
            }
            const auto [quotient, remainder] = Wide4::divide(q * b + rest, b);
            ASSERT_EQ(quotient, q);
            ASSERT_EQ(remainder, rest);
        }
    }
}

// (a + b)(a - b) = a^2 - b^2, and shifts are products by powers of two.
TEST(WideInt, RingIdentitiesAtFourLimbs) {
    test::Random random;
    for (int i = 0; i < 50000; ++i) {
        const Wide4 a = from_128<4>(word_128(random)) >> 2, b = from_128<4>(word_128(random)) >> 2;
        ASSERT_EQ((a + b) * (a - b), a * a - b * b);
        const auto n = static_cast<int>(random.between(0, 62));
        ASSERT_EQ(a << n, a * (std::int64_t{1} << n));
        ASSERT_EQ((a << n) >> n, a);
        const Wide4 floor = a >> n;
        const Wide4 rest = a - (floor << n);
        ASSERT_TRUE(!rest.is_negative() && rest < (Wide4(1) << n));
        ASSERT_EQ(-(-a), a);
        ASSERT_EQ(a.abs(), a.is_negative() ? -a : a);
    }
}

// Long products skip the limbs that are 0, and short ones are the middle of the full product.
TEST(WideInt, ProductsOfAnySizesAreOne) {
    test::Random random;
    const auto word = [&](int bits) {
        const Wide4 w = (from_128<4>(word_128(random)) << 126) + from_128<4>(word_128(random));
        return w >> (254 - bits);
    };
    for (int i = 0; i < 50000; ++i) {
        const WideInt<3> a(word(static_cast<int>(random.between(1, 191))));
        const Wide4 b = word(static_cast<int>(random.between(1, 254)));
        const WideInt<8> model = WideInt<8>(a) * WideInt<8>(b);
        ASSERT_EQ(full_product(a, b), WideInt<7>(model));
        ASSERT_EQ(full_product(b, a), WideInt<7>(model));
        const std::int64_t c = random.word();
        ASSERT_EQ(WideInt<5>(b) * c, WideInt<5>(full_product(b, WideInt<1>(c))));
        ASSERT_EQ(WideInt<8>(b) * c, WideInt<8>(b) * WideInt<8>(c));
    }
    const Wide4 least = -(Wide4(1) << 254) - (Wide4(1) << 254);
    EXPECT_EQ(full_product(least, least), WideInt<8>(1) << 510);
    EXPECT_EQ(full_product(least, WideInt<1>(INT64_MIN)), WideInt<5>(1) << 318);
    EXPECT_EQ(WideInt<5>(least) * INT64_MIN, WideInt<5>(1) << 318);
}

TEST(WideInt, LengthsAndConversions) {
    for (int n = 0; n < 255; ++n) {
        const Wide4 power = Wide4(1) << n;
        EXPECT_EQ(power.bit_length(), n + 1);
        EXPECT_EQ((-power).bit_length(), n + 1);
        EXPECT_EQ((power - 1).bit_length(), n);
        EXPECT_EQ(power.trailing_zeros(), n);
        EXPECT_EQ((-power).trailing_zeros(), n);
        EXPECT_EQ(power.fits_int64(), n < 63);
        EXPECT_EQ((-power).fits_int64(), n < 64);
        EXPECT_EQ(power.is_odd(), n == 0);
        EXPECT_EQ(Wide4(WideInt<8>(-power)), -power);
    }
    EXPECT_EQ(Wide4(0).bit_length(), 0);
    for (const std::int64_t v : test::boundary_words) {
        EXPECT_EQ(Wide4(v).to_int64(), v);
        EXPECT_EQ(WideInt<1>(Wide4(v)).to_int64(), v);
    }
}

TEST(WideInt, EveryOverflowTraps) {
    static_assert((Wide2(3) * 5 - 1).to_int64() == 14);
    static_assert(Wide2(-7) / 2 == -3 && Wide2(-7) % 2 == -1 && (Wide2(-7) >> 1) == -4);
    static_assert(!test::is_constant([] { return (WideInt<1>(INT64_MAX) + 1).to_int64(); }));
    static_assert(!test::is_constant([] { return (WideInt<1>(INT64_MIN) - 1).to_int64(); }));
    static_assert(!test::is_constant([] { return (-WideInt<1>(INT64_MIN)).to_int64(); }));
    const Wide2 max = ((Wide2(1) << 126) - 1) * 2 + 1, min = -max - 1;
    EXPECT_DEATH(max + 1, "sum overflow");
    EXPECT_DEATH(min - 1, "difference overflow");
    EXPECT_DEATH(-min, "negation overflow");
    EXPECT_DEATH(min * -1, "overflow");
    EXPECT_DEATH(min / -1, "result overflow");
    EXPECT_DEATH(max * 2, "overflow");
    EXPECT_DEATH(max * 3, "overflow");                            // a carry leaves the top limb
    EXPECT_DEATH((Wide2(1) << 64) * (Wide2(1) << 64), "does not fit");  // a whole limb does
    EXPECT_DEATH((Wide2(1) << 100) * (Wide2(1) << 100), "does not fit");
    EXPECT_DEATH(min * -1, "product overflow");
    EXPECT_DEATH((WideInt<5>(1) << 160) * (WideInt<5>(1) << 160), "product overflow");
    EXPECT_DEATH((WideInt<5>(1) << 160) * (WideInt<5>(1) << 159), "result overflow");
    EXPECT_DEATH(max << 1, "left shift overflow");
    EXPECT_DEATH(Wide2(1) << 127, "left shift overflow");
    EXPECT_DEATH(Wide2(1) << 128, "count outside");
    EXPECT_DEATH(Wide2(1) >> -1, "count outside");
    EXPECT_DEATH(Wide2(1) / 0, "division by zero");
    EXPECT_DEATH((Wide2(1) << 63).to_int64(), "does not fit 64");
    EXPECT_DEATH(WideInt<1>(Wide2(1) << 63), "does not fit");
    EXPECT_EQ(min * 1, min);
    EXPECT_EQ(min / 1, min);
    EXPECT_EQ((min >> 127).to_int64(), -1);
}

}  // namespace
}  // namespace umbra78::fixed
