// Format: the shape of a fixed-point word when it is a knob, known at run time only.
//
//   value = word / 2^fraction_bits
//   Qm.n  signed    m + n + 1 bits   -2^m .. 2^m - 2^-n      m does not count the sign
//   Um.n  unsigned  m + n bits         0  .. 2^m - 2^-n
//
// Words are carried as int64, so a signed format has at most 64 bits and an unsigned one 63.
// convert() is the only way from one format to another: it names its rounding and its overflow,
// rounds first and narrows then, and is exact where the target is finer and wide enough.
#pragma once

#include <cstdint>

#include "fixed/overflow.hpp"
#include "fixed/rounding.hpp"
#include "fixed/trap.hpp"

namespace umbra78::fixed {

struct Format {
    int integer_bits = 0;
    int fraction_bits = 0;
    bool is_signed = true;

    constexpr int width() const { return integer_bits + fraction_bits + (is_signed ? 1 : 0); }

    // Whether this is a format at all. The other members expect it.
    constexpr bool valid() const {
        return integer_bits >= 0 && integer_bits <= 63 && fraction_bits >= 0 &&
               fraction_bits <= 63 && width() >= 1 && width() <= (is_signed ? 64 : 63);
    }

    constexpr std::int64_t min_word() const { return is_signed ? min_signed(width()) : 0; }
    constexpr std::int64_t max_word() const {
        return is_signed ? max_signed(width()) : max_unsigned(width());
    }
    constexpr bool holds(std::int64_t word) const {
        return is_signed ? fits(word, width()) : fits_unsigned(word, width());
    }
    // An exact word of any size, already at fraction_bits, made to fit.
    constexpr std::int64_t narrow_word(std::int64_t word, Overflow overflow) const {
        return is_signed ? narrow(word, width(), overflow)
                         : narrow_unsigned(word, width(), overflow);
    }

    friend constexpr bool operator==(const Format&, const Format&) = default;
};

constexpr Format signed_format(int integer_bits, int fraction_bits) {
    return {integer_bits, fraction_bits, true};
}
constexpr Format unsigned_format(int integer_bits, int fraction_bits) {
    return {integer_bits, fraction_bits, false};
}

constexpr std::int64_t convert(std::int64_t word, Format from, Format to, Rounding rounding,
                               Overflow overflow) {
    require(from.valid() && to.valid(), "convert: not a format");
    require(from.holds(word), "convert: word outside its own format");
    const int coarser = from.fraction_bits - to.fraction_bits;
    if (coarser >= 0) {
        return to.narrow_word(scale_shift(word, coarser, rounding), overflow);
    }
    const int finer = -coarser;
    const auto shifted = static_cast<std::int64_t>(static_cast<std::uint64_t>(word) << finer);
    if (fits(word, 64 - finer) || overflow == Overflow::wrap) {
        return to.narrow_word(shifted, overflow);
    }
    // The exact word needs more than 64 bits, so it is outside every format, and saturates as any
    // other word that is outside on its side.
    require(overflow != Overflow::trap, "convert: value does not fit");
    return to.narrow_word(word < 0 ? INT64_MIN : INT64_MAX, overflow);
}

}  // namespace umbra78::fixed
