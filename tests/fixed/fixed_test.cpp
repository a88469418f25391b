#include "fixed/fixed.hpp"

#include <gtest/gtest.h>

#include <string>
#include <type_traits>

#include "fixed/rational.hpp"
#include "tests/fixed/boundary.hpp"

namespace umbra78::fixed {
namespace {

using Pixel = Fixed<8, 7>;  // screen X and Y, centred
using Coefficient = Fixed<1, 14>;

template <int I, int F>
Rational value_of(Fixed<I, F> v) {
    return Rational(v.word()) / Rational(std::int64_t{1} << (F < 62 ? F : 62)) /
           Rational(std::int64_t{1} << (F < 62 ? 0 : F - 62));
}
template <class Number>
Number any(test::Random& random) {
    return Number::from_word(wrap(random.word(), Number::width));
}

TEST(Fixed, ResultTypesAreExact) {
    using Sum = decltype(Pixel() + Coefficient());
    using Product = decltype(Pixel() * Coefficient());
    static_assert(std::is_same_v<Sum, Fixed<9, 14>>);
    static_assert(std::is_same_v<decltype(Pixel() - Pixel()), Fixed<9, 7>>);
    static_assert(std::is_same_v<Product, Fixed<10, 21>>);
    static_assert(std::is_same_v<decltype(-Pixel()), Fixed<9, 7>>);
    static_assert(std::is_same_v<Pixel::Word, std::int16_t> && sizeof(Pixel) == 2);
    static_assert(std::is_same_v<Product::Word, std::int32_t> && sizeof(Fixed<40, 20>) == 8);
}

TEST(Fixed, NothingConvertsByItself) {
    static_assert(!std::is_convertible_v<int, Pixel> && std::is_constructible_v<Pixel, int>);
    static_assert(!std::is_convertible_v<Pixel, Fixed<9, 8>>);
    static_assert(std::is_constructible_v<Fixed<9, 8>, Pixel>);
    static_assert(!std::is_constructible_v<Pixel, double>);
    static_assert(!std::is_constructible_v<Pixel, bool>);
    static_assert(!std::is_convertible_v<Pixel, int>);
}

// The extremes of each operand type, and random ones, against rationals.
template <class A, class B>
void expect_arithmetic(A a, B b) {
    const Rational x = value_of(a), y = value_of(b);
    ASSERT_EQ(value_of(a + b), x + y);
    ASSERT_EQ(value_of(a - b), x - y);
    ASSERT_EQ(value_of(a * b), x * y);
    ASSERT_EQ(value_of(-a), -x);
    ASSERT_EQ(a < b, x < y);
    ASSERT_EQ(a == b, x == y);
    ASSERT_EQ(a >= b, x >= y);
}
template <class A, class B>
void expect_arithmetic_of_types(test::Random& random) {
    using LimitsA = std::numeric_limits<A>;
    using LimitsB = std::numeric_limits<B>;
    for (const A a : {LimitsA::lowest(), LimitsA::max(), A(), LimitsA::epsilon()}) {
        for (const B b : {LimitsB::lowest(), LimitsB::max(), B(), LimitsB::epsilon()}) {
            expect_arithmetic(a, b);
        }
    }
    for (int i = 0; i < 2000; ++i) {
        expect_arithmetic(any<A>(random), any<B>(random));
    }
}

TEST(Fixed, ArithmeticIsExactForEveryPairOfShapes) {
    test::Random random;
    expect_arithmetic_of_types<Pixel, Pixel>(random);
    expect_arithmetic_of_types<Pixel, Coefficient>(random);
    expect_arithmetic_of_types<Coefficient, Pixel>(random);
    expect_arithmetic_of_types<Fixed<0, 1>, Fixed<0, 15>>(random);
    expect_arithmetic_of_types<Fixed<31, 0>, Fixed<0, 31>>(random);
    expect_arithmetic_of_types<Fixed<30, 1>, Fixed<1, 29>>(random);
    expect_arithmetic_of_types<Fixed<15, 16>, Fixed<7, 8>>(random);
}

TEST(Fixed, NarrowingIsConvert) {
    test::Random random;
    for (int i = 0; i < 100000; ++i) {
        const auto wide = any<Fixed<20, 30>>(random);
        const Rounding r = random.rounding();
        for (const Overflow o :
             {Overflow::wrap, Overflow::saturate, Overflow::saturate_symmetric}) {
            ASSERT_EQ(wide.narrow_to<Pixel>(r, o).word(),
                      convert(wide.word(), signed_format(20, 30), signed_format(8, 7), r, o));
        }
    }
    constexpr auto third = Fixed<8, 24>::parse("0.33333333");
    static_assert(third.narrow_to<Pixel>(Rounding::floor, Overflow::trap).word() == 42);
    static_assert(third.narrow_to<Pixel>(Rounding::half_up, Overflow::trap).word() == 43);
}

TEST(Fixed, ConstructionIsExactOrTraps) {
    static_assert(Pixel(255).word() == 255 * 128 && Pixel(-256).word() == INT16_MIN);
    static_assert(Fixed<20, 14>(Pixel(3)) == Pixel(3));
    static_assert(!test::is_constant([] { return Pixel(256).word(); }));
    static_assert(!test::is_constant([] { return Pixel::from_word(32768).word(); }));
    static_assert(!test::is_constant([] { return Pixel::parse("256").word(); }));
    static_assert(!test::is_constant([] { return Pixel::parse("one").word(); }));
    EXPECT_DEATH(Pixel(256), "");
    EXPECT_DEATH(Pixel::from_word(-32769), "");
    EXPECT_DEATH(Pixel::parse(""), "");
}

TEST(Fixed, EveryPixelPrintsAndParsesBack) {
    for (std::int64_t word = INT16_MIN; word <= INT16_MAX; ++word) {
        const Pixel p = Pixel::from_word(word);
        std::array<char, longest_decimal> buffer{};
        const auto length = static_cast<std::size_t>(p.print(buffer));
        ASSERT_EQ(Pixel::parse({buffer.data(), length}), p) << word;
    }
    static_assert(Pixel::parse("-12.5") == Fixed<5, 1>::from_word(-25));
}

TEST(Fixed, NumericLimits) {
    using Limits = std::numeric_limits<Pixel>;
    static_assert(Limits::is_specialized && Limits::is_exact && Limits::is_signed);
    static_assert(!Limits::is_integer && std::numeric_limits<Fixed<8, 0>>::is_integer);
    static_assert(Limits::max().word() == INT16_MAX && Limits::lowest().word() == INT16_MIN);
    static_assert(Limits::min() == Limits::lowest() && Limits::epsilon().word() == 1);
    static_assert(Limits::digits == 15 && Limits::digits10 == 4);
    static_assert(std::numeric_limits<Fixed<31, 32>>::max().word() == INT64_MAX);
}

}  // namespace
}  // namespace umbra78::fixed
