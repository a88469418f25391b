// Rounding: the only owner of right shifts of signed values and of divisions that lose bits.
//
//   floor_shift(v, n)      floor(v / 2^n)    0 <= n < the width of v; one instruction
//   round_shift(v, n, r)   v / 2^n           0 <= n <= 62, any v, no intermediate overflow
//   scale_shift(v, n, r)   v / 2^n           any n; n < 0 is an exact left shift, or a trap
//   round_divide(a, b, r)  a / b             b != 0; traps on -2^63 / -1
//
// The last three take the floor first, q = floor(x) with the remainder 0 <= x - q < 1, and then
// decide whether x is rounded up to q + 1, by comparing twice the remainder with the divisor:
//
//   mode           goes up when ...           example -1.5  -0.5   0.5   1.5   (2.25)
//   floor          never                              -2    -1     0     1     2
//   ceiling        the remainder is not 0             -1     0     1     2     3
//   to_zero        ... and x is negative              -1     0     0     1     2
//   half_up        2 rem >= divisor                   -1     0     1     2     2
//   half_to_zero   2 rem > divisor, = if x < 0        -1     0     0     1     2
//   half_away      2 rem > divisor, = if x >= 0       -2    -1     1     2     2
//   half_even      2 rem > divisor, = if q is odd     -2     0     0     2     2
//
// C++20 defines >> of a negative value as the floor. Elsewhere in the core >> has unsigned operands
// only, so that a shift that rounds is always named; tests/guards/tokens.sh checks it.
#pragma once

#include <concepts>
#include <cstdint>

#include "fixed/trap.hpp"

namespace umbra78::fixed {

enum class Rounding : std::uint8_t {
    floor,
    ceiling,
    to_zero,
    half_up,
    half_to_zero,
    half_away,
    half_even,
};

// floor(v / 2^n). n is not checked: the value is a pixel's, and n a constant of the frame.
template <std::signed_integral Int>
constexpr Int floor_shift(Int v, int n) {
    return static_cast<Int>(v >> n);  // guard: the one signed shift
}

// Whether x = floor + remainder/divisor rounds to floor + 1. twice_remainder < 2 divisor <= 2^64.
// Every mode is one threshold, so a mode known at compile time costs one comparison.
constexpr bool rounds_up(bool negative, bool floor_is_odd, std::uint64_t twice_remainder,
                         std::uint64_t divisor, Rounding r) {
    constexpr std::uint64_t never = UINT64_MAX;
    std::uint64_t threshold = never;
    switch (r) {
        case Rounding::floor: break;
        case Rounding::ceiling: threshold = 0; break;
        case Rounding::to_zero: threshold = negative ? 0 : never; break;
        case Rounding::half_up: threshold = divisor - 1; break;
        case Rounding::half_to_zero: threshold = divisor - (negative ? 1u : 0u); break;
        case Rounding::half_away: threshold = divisor - (negative ? 0u : 1u); break;
        case Rounding::half_even: threshold = divisor - (floor_is_odd ? 1u : 0u); break;
    }
    return twice_remainder > threshold;
}

// v / 2^n. The result cannot overflow: for n = 0 nothing is rounded, else |result| <= 2^62.
constexpr std::int64_t round_shift(std::int64_t v, int n, Rounding r) {
    require(n >= 0 && n <= 62, "round_shift: shift outside 0..62");
    const std::uint64_t divisor = std::uint64_t{1} << n;
    const std::int64_t floor = floor_shift(v, n);
    const std::uint64_t remainder = static_cast<std::uint64_t>(v) & (divisor - 1);
    return floor + (rounds_up(v < 0, (floor & 1) != 0, 2 * remainder, divisor, r) ? 1 : 0);
}

// v / 2^n for any n. Left shifts (n < 0) are exact.
constexpr std::int64_t scale_shift(std::int64_t v, int n, Rounding r) {
    if (n >= 0 && n <= 62) [[likely]] {
        return round_shift(v, n, r);
    }
    if (n > 62) {
        // Shift in two steps and keep the lost bits as one sticky bit, far below the half. From
        // n = 65 on |v / 2^n| <= 1/4, and only its sign and whether it is zero still matter.
        const int first = n < 65 ? n - 62 : 3;
        const std::int64_t lost = v & ((std::int64_t{1} << first) - 1);
        return round_shift(floor_shift(v, first) | (lost != 0 ? 1 : 0), 62, r);
    }
    if (v == 0) {
        return 0;
    }
    require(n >= -63, "scale_shift: left shift does not fit 64 bits");
    const auto shifted = static_cast<std::int64_t>(static_cast<std::uint64_t>(v) << -n);
    require(floor_shift(shifted, -n) == v, "scale_shift: left shift does not fit 64 bits");
    return shifted;
}

// |v| as an unsigned word: exact for -2^63 too.
constexpr std::uint64_t magnitude(std::int64_t v) {
    return v < 0 ? 0 - static_cast<std::uint64_t>(v) : static_cast<std::uint64_t>(v);
}

// num / den, den != 0 of either sign.
constexpr std::int64_t round_divide(std::int64_t num, std::int64_t den, Rounding r) {
    require(den != 0, "round_divide: division by zero");
    require(den != -1 || num != INT64_MIN, "round_divide: quotient 2^63 does not fit");
    const std::int64_t truncated = num / den;  // towards zero
    const std::int64_t left = num % den;       // sign of num
    const bool negative = (num < 0) != (den < 0);
    const bool below = left != 0 && negative;  // then the floor is one less
    const std::int64_t floor = truncated - (below ? 1 : 0);
    const std::uint64_t divisor = magnitude(den);
    const std::uint64_t remainder = below ? divisor - magnitude(left) : magnitude(left);
    return floor + (rounds_up(negative, (floor & 1) != 0, 2 * remainder, divisor, r) ? 1 : 0);
}

}  // namespace umbra78::fixed
