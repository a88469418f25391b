// What the tests of this room share: the boundary words, a seeded source of words near them, the
// slow model of rounding, and a check whether an expression is a constant.
#pragma once

#include <array>
#include <cstdint>
#include <cstdlib>
#include <iostream>

#include "fixed/rounding.hpp"
#include "tests/support/int128.hpp"

namespace umbra78::fixed::test {

using umbra78::test::Int128;

// Words at which carries, signs and widths change.
inline constexpr std::array<std::int64_t, 35> boundary_words{
    INT64_MIN,                     // magnitude and negation do not fit
    INT64_MIN + 1,                 // the smallest word that can be negated
    -0x7fffffff00000001,           // all ones above, one below
    -(std::int64_t{1} << 62) - 1,  // just outside a 63-bit word
    -(std::int64_t{1} << 62),      // the smallest 63-bit word
    -(std::int64_t{1} << 62) + 1,
    std::int64_t{INT32_MIN} - 1,   // just outside a 32-bit word
    INT32_MIN,                     // the smallest 32-bit word
    INT32_MIN + 1,
    INT16_MIN - 1,                 // just outside a 16-bit word
    INT16_MIN,                     // the smallest 16-bit word
    INT16_MIN + 1,
    -3,                            // -1.5 at one fraction bit: a tie below zero
    -2,
    -1,                            // all ones
    0,
    1,
    2,
    3,                             // a tie above zero
    0x5555,                        // alternating bits
    INT16_MAX - 1,
    INT16_MAX,                     // the largest 16-bit word
    INT16_MAX + 1,
    UINT16_MAX,                    // the largest unsigned 16-bit word
    UINT16_MAX + 1,
    0x55555555,
    INT32_MAX - 1,
    INT32_MAX,                     // the largest 32-bit word
    std::int64_t{INT32_MAX} + 1,
    UINT32_MAX,                    // a carry out of the low half
    std::int64_t{UINT32_MAX} + 1,
    (std::int64_t{1} << 62) - 1,   // the largest 63-bit word
    std::int64_t{1} << 62,
    INT64_MAX - 1,
    INT64_MAX,                     // adding anything overflows
};

inline constexpr std::array<Rounding, 7> all_roundings{
    Rounding::floor,        Rounding::ceiling,   Rounding::to_zero,  Rounding::half_up,
    Rounding::half_to_zero, Rounding::half_away, Rounding::half_even};

// UMBRA78_SEED, or 1978. Printed, so that a failure can be repeated.
inline std::uint64_t seed_of_this_run() {
    const char* text = std::getenv("UMBRA78_SEED");
    const std::uint64_t seed = text != nullptr ? std::strtoull(text, nullptr, 0) : 1978;
    std::cout << "[     seed ] UMBRA78_SEED=" << seed << '\n';
    return seed;
}

// Steele, Lea and Flood's splitmix64: the same words from every library and compiler.
class Random {
public:
    Random() : state_(seed_of_this_run()) {}

    std::uint64_t bits() {
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15;
        z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9;
        z = (z ^ z >> 27) * 0x94d049bb133111eb;
        return z ^ z >> 31;
    }
    // low .. high, both included.
    std::int64_t between(std::int64_t low, std::int64_t high) {
        const auto base = static_cast<std::uint64_t>(low);
        const std::uint64_t span = static_cast<std::uint64_t>(high) - base;
        const std::uint64_t draw = span == UINT64_MAX ? bits() : bits() % (span + 1);
        return static_cast<std::int64_t>(base + draw);
    }
    // Any length is as likely as any other; one draw in four lies at a boundary.
    std::int64_t word() {
        if (bits() % 4 == 0) {
            const auto base = static_cast<std::uint64_t>(
                boundary_words[bits() % boundary_words.size()]);
            return static_cast<std::int64_t>(base + bits() % 5 - 2);
        }
        return static_cast<std::int64_t>(bits()) >> (bits() % 64);
    }
    Rounding rounding() { return all_roundings[bits() % all_roundings.size()]; }

private:
    std::uint64_t state_;
};

// num / den by the definition of each mode: among the integers near the quotient, the one that
// the mode's name asks for. Shares nothing with the code under test. den > 0, |num| < 2^126.
inline Int128 model_round(Int128 num, Int128 den, Rounding r) {
    const auto distance = [&](Int128 c) { return c * den > num ? c * den - num : num - c * den; };
    const Int128 near = num / den;
    Int128 below = near + 1, above = near - 1;
    while (below * den > num) --below;
    while (above * den < num) ++above;
    const bool tie = distance(below) == distance(above);  // or exact, then below == above
    const Int128 best = distance(below) < distance(above) ? below : above;
    const Int128 towards_zero = num < 0 ? above : below;
    const Int128 from_zero = num < 0 ? below : above;
    switch (r) {
        case Rounding::floor: return below;
        case Rounding::ceiling: return above;
        case Rounding::to_zero: return towards_zero;
        case Rounding::half_up: return tie ? above : best;
        case Rounding::half_to_zero: return tie ? towards_zero : best;
        case Rounding::half_away: return tie ? from_zero : best;
        case Rounding::half_even: return tie ? (below % 2 == 0 ? below : above) : best;
    }
    std::abort();
}

// is_constant([] { return f(bad); }): false if evaluating it at compile time reaches a trap.
template <class Lambda, int = (static_cast<void>(Lambda{}()), 0)>
constexpr bool is_constant(Lambda) {
    return true;
}
constexpr bool is_constant(...) { return false; }

}  // namespace umbra78::fixed::test
