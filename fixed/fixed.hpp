// Fixed<I, F>: a signed fixed-point number whose format is known when the program is compiled.
//
//   value = word / 2^F       Q I.F, that is I + F + 1 bits, -2^I .. 2^I - 2^-F
//
// Arithmetic is exact: the result type is as wide as the operation needs, so nothing rounds and
// nothing overflows, and a result that would need more than 64 bits does not compile.
//
//   a + b, a - b   Fixed<max(I) + 1, max(F)>
//   a * b          Fixed<I + J + 1, F + G>        (the 1 is for -2^I * -2^J)
//   -a             Fixed<I + 1, F>
//
// Bits are lost only in narrow_to<Target>(rounding, overflow), which names how. There is no
// implicit conversion at all; widening is an explicit construction.
#pragma once

#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>
#include <type_traits>

#include "fixed/decimal.hpp"
#include "fixed/format.hpp"

namespace umbra78::fixed {

template <int I, int F>
class Fixed {
    static_assert(I >= 0, "Fixed<I, F>: the integer bits (without the sign) cannot be negative");
    static_assert(F >= 0, "Fixed<I, F>: the fraction bits cannot be negative");
    static_assert(I + F >= 1, "Fixed<I, F>: a sign bit alone is not a number");
    static_assert(I + F <= 63, "Fixed<I, F>: more than 64 bits; narrow_to() an operand first");

public:
    static constexpr int integer_bits = I, fraction_bits = F, width = I + F + 1;
    static constexpr Format format{I, F, true};
    using Word = std::conditional_t<
        (width <= 16), std::int16_t,
        std::conditional_t<(width <= 32), std::int32_t, std::int64_t>>;

    constexpr Fixed() = default;

    // The integer v; traps if it does not fit. No other type is silently made an integer first.
    template <std::signed_integral Integer>
    constexpr explicit Fixed(Integer v)
        : Fixed(from_word(scale_shift(v, -F, Rounding::floor))) {}

    // The same value in a format that holds all of the other.
    template <int J, int G>
    constexpr explicit Fixed(Fixed<J, G> other) : Fixed(from_word(widened(other))) {
        static_assert(I >= J, "integer bits would be lost: use narrow_to<>(rounding, overflow)");
        static_assert(F >= G, "fraction bits would be lost: use narrow_to<>(rounding, overflow)");
    }

    // word / 2^F; traps if the word does not fit.
    static constexpr Fixed from_word(std::int64_t word) {
        Fixed result;
        result.word_ = static_cast<Word>(trap_overflow(word, width));
        return result;
    }
    constexpr Word word() const { return word_; }

    template <class Target>
    constexpr Target narrow_to(Rounding rounding, Overflow overflow) const {
        return Target::from_word(convert(word_, format, Target::format, rounding, overflow));
    }

    // Decimal text, rounded half to even; traps unless the text is a number in range.
    static constexpr Fixed parse(std::string_view text) {
        static_assert(F <= 48, "decimals are parsed to 48 fraction bits at most");
        const DecimalResult result = parse_decimal(text, F, width);
        require(result.status == DecimalStatus::ok, "Fixed: not a number of this format");
        return from_word(result.value);
    }
    // The exact decimal; returns its length.
    constexpr int print(std::span<char> out) const {
        static_assert(F <= 60, "decimals are printed from 60 fraction bits at most");
        return print_decimal(word_, F, out);
    }

    constexpr auto operator-() const {
        using Result = Fixed<I + 1, F>;
        return Result::from_word(-static_cast<std::int64_t>(word_));
    }
    template <int J, int G>
    friend constexpr auto operator+(Fixed a, Fixed<J, G> b) {
        using Result = Fixed<(I > J ? I : J) + 1, (F > G ? F : G)>;
        return Result::from_word(Result::widened(a) + Result::widened(b));
    }
    template <int J, int G>
    friend constexpr auto operator-(Fixed a, Fixed<J, G> b) {
        using Result = Fixed<(I > J ? I : J) + 1, (F > G ? F : G)>;
        return Result::from_word(Result::widened(a) - Result::widened(b));
    }
    template <int J, int G>
    friend constexpr auto operator*(Fixed a, Fixed<J, G> b) {
        using Result = Fixed<I + J + 1, F + G>;
        return Result::from_word(std::int64_t{a.word()} * std::int64_t{b.word()});
    }

    // Values are compared, so 1.5 equals 1.5 in any two formats.
    template <int J, int G>
    friend constexpr std::strong_ordering operator<=>(Fixed a, Fixed<J, G> b) {
        using Common = Fixed<(I > J ? I : J), (F > G ? F : G)>;
        return Common::widened(a) <=> Common::widened(b);
    }
    template <int J, int G>
    friend constexpr bool operator==(Fixed a, Fixed<J, G> b) {
        return (a <=> b) == 0;
    }

    // The word of a value at this format's fraction bits, G <= F.
    template <int J, int G>
    static constexpr std::int64_t widened(Fixed<J, G> v) {
        return std::int64_t{v.word()} * (std::int64_t{1} << (F - G));
    }

private:
    Word word_ = 0;
};

}  // namespace umbra78::fixed

template <int I, int F>
class std::numeric_limits<umbra78::fixed::Fixed<I, F>> {
    using Number = umbra78::fixed::Fixed<I, F>;

public:
    static constexpr bool is_specialized = true;
    static constexpr bool is_signed = true, is_integer = F == 0, is_exact = true;
    static constexpr bool is_bounded = true, is_modulo = false, traps = true;
    static constexpr bool has_infinity = false, has_quiet_NaN = false, has_signaling_NaN = false;
    static constexpr bool is_iec559 = false, tinyness_before = false;
    static constexpr std::float_round_style round_style = std::round_indeterminate;
    static constexpr int radix = 2, digits = I + F, digits10 = (I + F) * 3 / 10;
    static constexpr int max_digits10 = 0;
    static constexpr int min_exponent = 0, min_exponent10 = 0;
    static constexpr int max_exponent = 0, max_exponent10 = 0;

    static constexpr Number max() noexcept { return Number::from_word(Number::format.max_word()); }
    static constexpr Number lowest() noexcept {
        return Number::from_word(Number::format.min_word());
    }
    static constexpr Number min() noexcept { return lowest(); }  // as for the integers
    static constexpr Number epsilon() noexcept { return Number::from_word(1); }  // one quantum
    static constexpr Number round_error() noexcept { return Number(); }
    static constexpr Number infinity() noexcept { return Number(); }
    static constexpr Number quiet_NaN() noexcept { return Number(); }
    static constexpr Number signaling_NaN() noexcept { return Number(); }
    static constexpr Number denorm_min() noexcept { return epsilon(); }
};
