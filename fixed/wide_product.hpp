// The 64 x 64 -> 128 bit product and the 128 / 64 bit quotient, from which all wider arithmetic is
// made.
//
// The portable forms use 32-bit halves only, so they are the same on a Cortex-M3. Where the
// compiler has a 128-bit type the product uses it; a test holds the two equal bit for bit.
// A quotient of more than 64 bits, and so a division by 0, is a broken precondition.
#pragma once

#include <bit>
#include <cstdint>

#include "fixed/trap.hpp"

namespace umbra78::fixed {

// high * 2^64 + low
struct Word128 {
    std::uint64_t high = 0, low = 0;
    friend constexpr bool operator==(const Word128&, const Word128&) = default;
};

// Schoolbook on 32-bit halves. middle is at most (2^32-1)^2 + 2 (2^32-1) = 2^64 - 1: no carry out.
constexpr Word128 multiply_wide_portable(std::uint64_t a, std::uint64_t b) {
    constexpr std::uint64_t low_half = 0xffffffff;
    const std::uint64_t a0 = a & low_half, a1 = a >> 32;
    const std::uint64_t b0 = b & low_half, b1 = b >> 32;
    const std::uint64_t bottom = a0 * b0;
    const std::uint64_t cross = a1 * b0 + (bottom >> 32);
    const std::uint64_t middle = a0 * b1 + (cross & low_half);
    return {a1 * b1 + (cross >> 32) + (middle >> 32), middle << 32 | (bottom & low_half)};
}

constexpr Word128 multiply_wide(std::uint64_t a, std::uint64_t b) {
#ifdef __SIZEOF_INT128__
    __extension__ using Native = unsigned __int128;
    const Native product = static_cast<Native>(a) * b;
    return {static_cast<std::uint64_t>(product >> 64), static_cast<std::uint64_t>(product)};
#else
    return multiply_wide_portable(a, b);
#endif
}

// Modulo 2^128.
constexpr Word128 add_wide(Word128 a, Word128 b) {
    const std::uint64_t low = a.low + b.low;
    return {a.high + b.high + (low < a.low ? 1 : 0), low};
}

struct QuotientRemainder {
    std::uint64_t quotient, remainder;
};

namespace detail {

// One 32-bit digit of a quotient: numerator / divisor with divisor normalized (bit 63 set) and
// numerator = upper * 2^32 + next, upper < divisor. Knuth, TAOCP 4.3.1, algorithm D, step D3.
constexpr QuotientRemainder divide_digit(std::uint64_t upper, std::uint64_t next,
                                         std::uint64_t divisor) {
    const std::uint64_t d1 = divisor >> 32, d0 = divisor & 0xffffffff;
    std::uint64_t digit = upper / d1;
    std::uint64_t rest = upper % d1;
    // The estimate is too large by at most 2. It is at most 2^32 + 1, so digit * d0 < 2^64.
    while (rest >> 32 == 0 && digit * d0 > (rest << 32 | next)) {
        --digit;
        rest += d1;
    }
    return {digit, (upper << 32 | next) - digit * divisor};  // exact modulo 2^64
}

}  // namespace detail

// numerator / divisor for numerator.high < divisor, so that the quotient fits 64 bits.
constexpr QuotientRemainder divide_wide(Word128 numerator, std::uint64_t divisor) {
    require(numerator.high < divisor, "divide_wide: quotient does not fit 64 bits");
    if (numerator.high == 0) {
        return {numerator.low / divisor, numerator.low % divisor};
    }
    const int shift = std::countl_zero(divisor);
    const std::uint64_t d = divisor << shift;
    const std::uint64_t upper =
        shift == 0 ? numerator.high : numerator.high << shift | numerator.low >> (64 - shift);
    const std::uint64_t low = numerator.low << shift;
    const auto first = detail::divide_digit(upper, low >> 32, d);
    const auto second = detail::divide_digit(first.remainder, low & 0xffffffff, d);
    return {first.quotient << 32 | second.quotient, second.remainder >> shift};
}

}  // namespace umbra78::fixed
