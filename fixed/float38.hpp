// Float38: the floating-point word of the FPS AP-120B, exactly, in integers.
//
//   38 bits = 10-bit exponent, biased by 512 | 28-bit two's-complement mantissa, 27 of it fraction
//   value   = mantissa / 2^27 * 2^(exponent - 512)      normalised: 1/2 <= |mantissa / 2^27| < 1
//
// Format and convergent rounding (to nearest, ties to even), overflow to the signed maximum and
// underflow to 0: Floating Point Systems, AP Math Library Manual 860-7288-004, 1979, 1.3.2, 2.3.5,
// 2.3.8. Ours, for want of a source: every operation rounds its exact result once, whatever guard
// bits the adder had; every result is normalised; 0 has mantissa and exponent 0; the range is
// judged after rounding; x / 0 is the signed maximum, 0 / 0 is 0. hw/MACHINE.md, section 18.
#pragma once

#include <bit>
#include <compare>
#include <cstdint>

#include "fixed/overflow.hpp"
#include "fixed/rational.hpp"
#include "fixed/rounding.hpp"

namespace umbra78::fixed {

class Float38 {
public:
    static constexpr int mantissa_bits = 28, fraction_bits = 27;
    static constexpr int exponent_bias = 512, max_exponent = 1023;

    constexpr Float38() = default;  // 0

    // A word as it is, normalised or not.
    static constexpr Float38 from_parts(std::int32_t mantissa, int biased_exponent) {
        require(fits(mantissa, mantissa_bits), "Float38: mantissa wider than 28 bits");
        require(fits_unsigned(biased_exponent, 10), "Float38: exponent wider than 10 bits");
        Float38 f;
        f.mantissa_ = mantissa;
        f.exponent_ = static_cast<std::int16_t>(biased_exponent);
        return f;
    }
    // A 16-bit word as the host's transfer leaves it: the integer in the fraction's low end.
    static constexpr Float38 from_host(std::int16_t word) {
        return from_parts(word, exponent_bias + fraction_bits);
    }
    // word 2^scale, rounded once; |word| < 2^62.
    static constexpr Float38 from_scaled(std::int64_t word, int scale) {
        return rounded(word, scale);
    }
    static constexpr Float38 from_rational(const Rational& exact) {
        if (exact.is_zero()) return {};
        const int scale = exact.floor_log2() - (fraction_bits - 1);  // leaves 27 bits
        std::int64_t word = 0;
        exact.round_scaled(-scale, Rounding::half_even, word);
        return rounded(word, scale);  // rounds no more: 27 bits, or 2^27
    }
    static constexpr Float38 largest(bool negative) {
        constexpr std::int32_t all = (1 << fraction_bits) - 1;
        return from_parts(negative ? -all : all, max_exponent);
    }

    constexpr std::int32_t mantissa() const { return mantissa_; }
    constexpr int biased_exponent() const { return exponent_; }
    constexpr bool is_zero() const { return mantissa_ == 0; }
    constexpr bool is_negative() const { return mantissa_ < 0; }

    // The machine's 38 bits, exponent above mantissa.
    constexpr std::uint64_t bits() const {
        return static_cast<std::uint64_t>(exponent_) << mantissa_bits |
               static_cast<std::uint64_t>(wrap_unsigned(mantissa_, mantissa_bits));
    }

    // The same value with 1/2 <= |m| < 1, as the machine's "float" makes it from a host's word.
    constexpr Float38 normalised() const { return rounded(mantissa_, unit()); }

    friend constexpr Float38 operator+(const Float38& a, const Float38& b) {
        return sum(a.mantissa_, a.unit(), b.mantissa_, b.unit());
    }
    friend constexpr Float38 operator-(const Float38& a, const Float38& b) {
        return sum(a.mantissa_, a.unit(), -std::int64_t{b.mantissa_}, b.unit());
    }

    friend constexpr Float38 operator*(const Float38& a, const Float38& b) {
        return rounded(std::int64_t{a.mantissa_} * b.mantissa_, a.unit() + b.unit());
    }

    friend constexpr Float38 operator/(const Float38& a, const Float38& b) {
        if (a.is_zero()) return {};
        if (b.is_zero()) return largest(a.is_negative());
        // 28 bits each: the quotient has 34 or more, and a sticky bit says whether the division
        // leaves a remainder.
        const Magnitude n = a.left_justified(), d = b.left_justified();
        const std::uint64_t num = n.word << quotient_shift;
        const auto q = static_cast<std::int64_t>(num / d.word << 1 | (num % d.word != 0 ? 1 : 0));
        return rounded(a.is_negative() != b.is_negative() ? -q : q,
                       n.unit - d.unit - quotient_shift - 1);
    }

    // To an integer of `width` bits, to nearest even or as `r` says; what does not fit becomes the
    // largest word of its sign.
    constexpr std::int32_t fix(int width, Rounding r = Rounding::half_even) const {
        require(width >= 2 && width <= 32, "Float38: fixed to 2..32 bits");
        const int down = -unit();
        if (is_zero()) return 0;
        if (down < -width) return largest_word(is_negative(), width);
        const std::int64_t word = scale_shift(mantissa_, down, r);
        return static_cast<std::int32_t>(
            fits(word, width) ? word : largest_word(is_negative(), width));
    }

    // By value, exactly, normalised or not.
    friend constexpr std::strong_ordering operator<=>(const Float38& a, const Float38& b) {
        if (a.is_zero() || b.is_zero() || a.is_negative() != b.is_negative())
            return a.mantissa_ <=> b.mantissa_;
        const Magnitude x = a.left_justified(), y = b.left_justified();
        const auto order = x.unit != y.unit ? x.unit <=> y.unit : x.word <=> y.word;
        return a.is_negative() ? 0 <=> order : order;
    }
    friend constexpr bool operator==(const Float38& a, const Float38& b) {
        return (a <=> b) == 0;
    }

private:
    static constexpr int quotient_shift = 34;
    static constexpr int guard = 32;

    // The power of two of the mantissa's last bit.
    constexpr int unit() const { return exponent_ - exponent_bias - fraction_bits; }

    static constexpr std::int32_t largest_word(bool negative, int width) {
        return static_cast<std::int32_t>(negative ? -max_signed(width) : max_signed(width));
    }

    // word 2^scale, normalised, rounded to 27 bits of fraction, brought into range.
    static constexpr Float38 rounded(std::int64_t word, int scale) {
        if (word == 0) return {};
        const int drop = static_cast<int>(std::bit_width(magnitude(word))) - fraction_bits;
        std::int64_t m = drop > 0 ? round_shift(word, drop, Rounding::half_even)
                                  : scale_shift(word, drop, Rounding::half_even);
        int exponent = scale + drop + fraction_bits + exponent_bias;
        if (magnitude(m) == std::uint64_t{1} << fraction_bits) {  // a carry out of the fraction
            m /= 2;
            ++exponent;
        }
        if (exponent > max_exponent) return largest(word < 0);
        if (exponent < 0) return {};
        return from_parts(static_cast<std::int32_t>(m), exponent);
    }

    // |value| = word 2^unit, word of exactly 28 bits; not 0.
    struct Magnitude {
        std::uint64_t word;
        int unit;
    };
    constexpr Magnitude left_justified() const {
        const std::uint64_t m = magnitude(mantissa_);
        const int up = mantissa_bits - static_cast<int>(std::bit_width(m));
        return {m << up, unit() - up};
    }

    // a 2^unit_a + b 2^unit_b, of mantissas. The one with the smaller unit is shifted right to the
    // other's unit, with 32 guard bits and a sticky bit for everything below them. The floor of the
    // sum with that bit rounds as the exact sum does.
    static constexpr Float38 sum(std::int64_t a, int unit_a, std::int64_t b, int unit_b) {
        if (a == 0) return rounded(b, unit_b);
        if (b == 0) return rounded(a, unit_a);
        if (unit_a < unit_b) return sum(b, unit_b, a, unit_a);
        constexpr std::int64_t up = std::int64_t{1} << guard;
        const int apart = unit_a - unit_b < 62 ? unit_a - unit_b : 62;
        const std::int64_t aligned = floor_shift(b * up, apart);
        const bool lost = (b * up & ((std::int64_t{1} << apart) - 1)) != 0;
        return rounded(2 * (a * up + aligned) + (lost ? 1 : 0), unit_a - guard - 1);
    }

    std::int32_t mantissa_ = 0;
    std::int16_t exponent_ = 0;  // biased
};

}  // namespace umbra78::fixed
