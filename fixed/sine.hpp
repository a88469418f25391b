// Sine and cosine of an angle in degrees, correctly rounded.
//
//   sine   = nearest integer to 2^30 sin(degrees_q16 / 2^16 degrees)    in   Q15.16 degrees
//   cosine = nearest integer to 2^30 cos(degrees_q16 / 2^16 degrees)    out  Q1.30, 1.0 is 2^30
//
// These two lines are the whole specification: any correct program, in any language, gives these
// words. No value is a tie, because a sine of a rational number of degrees that is itself rational
// is 0, +-1/2 or +-1 (Niven). Of all angles (tests/fixed/long_sine_test.cpp) the closest to a tie
// is the sine of 236262/65536 degrees, which is 51 units of 2^-63 (2^-57.3) away from it; the
// evaluation below has an error of at most 3 units. (The 53-bit sine and cosine of libm, given the
// angle in radians and unreduced, get 5 of the 47 million words wrong.)
// In: any 32-bit word. There are no errors.
//
// Evaluation. The angle is reduced modulo 360 and folded into 0..45 degrees in integers, which
// is exact. There, with x in radians, y = x^2, all in U1.63:
//
//   sin x = x (1 - y/(2*3) (1 - y/(4*5) (1 - ... )))      to y^10 / 21!, the rest is < 2^-79
//   cos x =    1 - y/(1*2) (1 - y/(3*4) (1 - ... ))       to y^10 / 20!, the rest is < 2^-77
//
// Every step truncates, and its error is multiplied by at most 0.31 in the next one. The sum of the
// errors is less than 8 units of 2^-63, that is 2^-60, or 2^-30 of the result's last place.
#pragma once

#include <cstdint>

#include "fixed/rounding.hpp"
#include "fixed/wide_product.hpp"

namespace umbra78::fixed {

struct SineCosine {
    std::int32_t sine, cosine;
    friend constexpr bool operator==(const SineCosine&, const SineCosine&) = default;
};

namespace detail {

inline constexpr std::uint64_t one_u63 = std::uint64_t{1} << 63;

// a * b, all U1.63, 0..1
constexpr std::uint64_t multiply_u63(std::uint64_t a, std::uint64_t b) {
    const Word128 product = multiply_wide(a, b);
    return product.high << 1 | product.low >> 63;
}

// 1 - y/(first (first+1)) (1 - y/((first+2) (first+3)) (...))
constexpr std::uint64_t alternating_series(std::uint64_t y, unsigned first) {
    std::uint64_t sum = one_u63;
    for (unsigned pair = 10; pair-- > 0;) {
        const unsigned k = first + 2 * pair;
        sum = one_u63 - multiply_u63(y, sum) / (k * (k + 1));
    }
    return sum;
}

// Sine and cosine, U1.63, of an angle of 0..45 degrees in units of 2^-16 degree.
struct OctantU63 {
    std::uint64_t sine, cosine;
};
constexpr OctantU63 octant_sine_cosine(std::uint32_t angle) {
    // pi / (180 * 2^16) radians, U.85, to the nearest integer.
    constexpr std::uint64_t radians_u85 = 0x8EFA351294E9C8AE;
    const Word128 x_u85 = multiply_wide(angle, radians_u85);
    const std::uint64_t x = x_u85.high << 42 | x_u85.low >> 22;
    const std::uint64_t y = multiply_u63(x, x);
    return {multiply_u63(x, alternating_series(y, 2)), alternating_series(y, 1)};
}

// U1.63 to Q1.30, to the nearest.
constexpr std::int32_t round_u63_to_q30(std::uint64_t v) {
    return static_cast<std::int32_t>((v + (std::uint64_t{1} << 32)) >> 33);
}

}  // namespace detail

constexpr SineCosine sine_cosine(std::int32_t degrees_q16) {
    constexpr std::int32_t right_angle = 90 << 16;
    std::int32_t angle = degrees_q16 % (4 * right_angle);
    angle += angle < 0 ? 4 * right_angle : 0;
    const std::int32_t quadrant = angle / right_angle;
    angle %= right_angle;
    const bool upper_half = angle > right_angle / 2;  // fold at 45 degrees: swap sine and cosine
    const auto folded = static_cast<std::uint32_t>(upper_half ? right_angle - angle : angle);
    const detail::OctantU63 exact = detail::octant_sine_cosine(folded);
    const std::int32_t s = detail::round_u63_to_q30(upper_half ? exact.cosine : exact.sine);
    const std::int32_t c = detail::round_u63_to_q30(upper_half ? exact.sine : exact.cosine);
    switch (quadrant) {
        case 0: return {s, c};
        case 1: return {c, -s};
        case 2: return {-s, -c};
        default: return {-c, s};
    }
}

}  // namespace umbra78::fixed
