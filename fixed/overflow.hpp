// Overflow: what happens to an exact value that is stored in a word of `bits` bits.
//
//   signed word    -2^(bits-1) .. 2^(bits-1) - 1     1 <= bits <= 64
//   unsigned word  0 .. 2^bits - 1                   1 <= bits <= 63 (values are int64 here)
//
//   wrap                 v mod 2^bits, as an adder without an overflow flag
//   saturate             the nearest word of the interval
//   saturate_symmetric   the same on -(2^(bits-1) - 1) .. 2^(bits-1) - 1, so that negation closes
//   trap                 the caller claims that it fits; a wrong claim is a broken precondition
//
// Each is a function of its own. narrow() chooses one at run time, for a machine's settings.
#pragma once

#include <cstdint>

#include "fixed/rounding.hpp"
#include "fixed/trap.hpp"

namespace umbra78::fixed {

enum class Overflow : std::uint8_t { wrap, saturate, saturate_symmetric, trap };

// The largest and smallest word of `bits` bits.
constexpr std::int64_t max_signed(int bits) {
    require(bits >= 1 && bits <= 64, "signed width outside 1..64");
    return static_cast<std::int64_t>((std::uint64_t{1} << (bits - 1)) - 1);
}
constexpr std::int64_t min_signed(int bits) { return -max_signed(bits) - 1; }
constexpr std::int64_t max_unsigned(int bits) {
    require(bits >= 1 && bits <= 63, "unsigned width outside 1..63");
    return static_cast<std::int64_t>((std::uint64_t{1} << bits) - 1);
}

// v clamped to low..high.
constexpr std::int64_t clamp(std::int64_t v, std::int64_t low, std::int64_t high) {
    return v < low ? low : v > high ? high : v;
}

constexpr std::int64_t wrap(std::int64_t v, int bits) {
    require(bits >= 1 && bits <= 64, "signed width outside 1..64");
    const int unused = 64 - bits;
    return floor_shift(static_cast<std::int64_t>(static_cast<std::uint64_t>(v) << unused), unused);
}
constexpr std::int64_t wrap_unsigned(std::int64_t v, int bits) { return v & max_unsigned(bits); }

constexpr bool fits(std::int64_t v, int bits) { return wrap(v, bits) == v; }
constexpr bool fits_unsigned(std::int64_t v, int bits) { return wrap_unsigned(v, bits) == v; }

constexpr std::int64_t saturate(std::int64_t v, int bits) {
    return clamp(v, min_signed(bits), max_signed(bits));
}
constexpr std::int64_t saturate_symmetric(std::int64_t v, int bits) {
    return clamp(v, -max_signed(bits), max_signed(bits));
}
constexpr std::int64_t saturate_unsigned(std::int64_t v, int bits) {
    return clamp(v, 0, max_unsigned(bits));
}

constexpr std::int64_t trap_overflow(std::int64_t v, int bits) {
    require(fits(v, bits), "value does not fit the signed word");
    return v;
}
constexpr std::int64_t trap_overflow_unsigned(std::int64_t v, int bits) {
    require(fits_unsigned(v, bits), "value does not fit the unsigned word");
    return v;
}

constexpr std::int64_t narrow(std::int64_t v, int bits, Overflow overflow) {
    switch (overflow) {
        case Overflow::wrap: return wrap(v, bits);
        case Overflow::saturate: return saturate(v, bits);
        case Overflow::saturate_symmetric: return saturate_symmetric(v, bits);
        case Overflow::trap: return trap_overflow(v, bits);
    }
    trap("narrow: unknown overflow mode");
}

// An unsigned interval has no negative side, so symmetric saturation is saturation.
constexpr std::int64_t narrow_unsigned(std::int64_t v, int bits, Overflow overflow) {
    switch (overflow) {
        case Overflow::wrap: return wrap_unsigned(v, bits);
        case Overflow::saturate:
        case Overflow::saturate_symmetric: return saturate_unsigned(v, bits);
        case Overflow::trap: return trap_overflow_unsigned(v, bits);
    }
    trap("narrow_unsigned: unknown overflow mode");
}

}  // namespace umbra78::fixed
