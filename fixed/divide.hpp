// The divider: the quotient of two exact integers, rounded once, with a certificate.
//
//   value = round(num * 2^shift / den)      any 64-bit num, 1 <= den < 2^63, |shift| <= 62
//
// The dividend has up to 126 bits. Where there is no quotient the status says so, and no value has
// a special meaning: den <= 0 (a point behind the eye), and a result of more than `bits` bits,
// 1..63, signed. Another shift or width is a broken precondition.
//
// Certificate. A quotient q rounded to nearest, whatever becomes of ties, satisfies
//
//   2 |q den - num 2^shift| <= den
//
// which certificate_holds() checks exactly, without dividing.
#pragma once

#include <cstdint>

#include "fixed/overflow.hpp"
#include "fixed/rounding.hpp"
#include "fixed/wide_int.hpp"
#include "fixed/wide_product.hpp"

namespace umbra78::fixed {

enum class DivideStatus : std::uint8_t { ok, divisor_not_positive, overflow };

// value is 0 when the divisor is not positive, the saturated word on overflow.
struct Quotient {
    std::int64_t value;
    DivideStatus status;
    friend constexpr bool operator==(const Quotient&, const Quotient&) = default;
};

namespace detail {

// The exact |num| * 2^shift / den as floor and what is left, remainder / divisor < 1.
struct ExactQuotient {
    std::uint64_t floor, remainder, divisor;
    bool huge;  // the floor does not fit 64 bits
};

constexpr ExactQuotient divide_magnitude(std::uint64_t num, std::uint64_t den, int shift) {
    if (shift >= 0) {
        const Word128 dividend = multiply_wide(num, std::uint64_t{1} << shift);
        if (dividend.high >= den) {
            return {0, 0, den, true};
        }
        const QuotientRemainder q = divide_wide(dividend, den);
        return {q.quotient, q.remainder, den, false};
    }
    // num / den / 2^down: of the first division's remainder only whether it is 0 matters, which one
    // sticky bit below the quotient's bits keeps.
    const int down = -shift;
    const std::uint64_t q = num / den;
    const std::uint64_t low_bits = q & ((std::uint64_t{1} << down) - 1);
    const std::uint64_t sticky = q * den != num ? 1 : 0;
    return {q >> down, low_bits << 1 | sticky, std::uint64_t{2} << down, false};
}

}  // namespace detail

constexpr Quotient divide(std::int64_t num, std::int64_t den, int shift, int bits,
                          Rounding r = Rounding::half_up) {
    require(shift >= -62 && shift <= 62, "divide: shift outside -62..62");
    require(bits >= 1 && bits <= 63, "divide: result width outside 1..63");
    if (den <= 0) {
        return {0, DivideStatus::divisor_not_positive};
    }
    std::int64_t value = 0;
    const bool negative = num < 0;
    if (shift >= 0 && fits(num, 64 - shift)) [[likely]] {
        value = round_divide(static_cast<std::int64_t>(static_cast<std::uint64_t>(num) << shift),
                             den, r);
    } else {
        const auto exact =
            detail::divide_magnitude(magnitude(num), static_cast<std::uint64_t>(den), shift);
        if (exact.huge || exact.floor > std::uint64_t{1} << 62) {  // beyond every width allowed
            return {negative ? min_signed(bits) : max_signed(bits), DivideStatus::overflow};
        }
        const bool below = negative && exact.remainder != 0;  // the floor of a negative value
        const auto truncated = static_cast<std::int64_t>(exact.floor);
        const std::int64_t floor = negative ? -truncated - (below ? 1 : 0) : truncated;
        const std::uint64_t rem = below ? exact.divisor - exact.remainder : exact.remainder;
        const bool odd = (floor & 1) != 0;
        value = floor + (rounds_up(negative, odd, 2 * rem, exact.divisor, r) ? 1 : 0);
    }
    if (!fits(value, bits)) {
        return {saturate(value, bits), DivideStatus::overflow};
    }
    return {value, DivideStatus::ok};
}

// 2 |q den - num 2^shift| <= den, exactly, for any operands; false for den <= 0.
constexpr bool certificate_holds(std::int64_t num, std::int64_t den, int shift, std::int64_t q) {
    require(shift >= -62 && shift <= 62, "certificate: shift outside -62..62");
    if (den <= 0) {
        return false;
    }
    if (shift >= 0 && fits(num, 64 - shift)) [[likely]] {  // a frame's words stay within 64 bits
        const auto dividend =
            static_cast<std::int64_t>(static_cast<std::uint64_t>(num) << shift);
        std::int64_t product = 0, residual = 0;
        if (!__builtin_mul_overflow(q, den, &product) &&
            !__builtin_sub_overflow(product, dividend, &residual)) {
            return magnitude(residual) <= static_cast<std::uint64_t>(den) / 2;
        }
    }
    using Wide = WideInt<4>;  // 63 + 63 + 62 + 2 bits at most
    const int up = shift > 0 ? shift : 0, down = shift < 0 ? -shift : 0;
    const Wide divisor = Wide(den) << down;
    const Wide residual = Wide(q) * divisor - (Wide(num) << up);
    return (residual.abs() << 1) <= divisor;
}

}  // namespace umbra78::fixed
