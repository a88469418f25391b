// Decimal text to fixed-point words and back, exactly: the way numbers enter and leave a scene.
//
//   number = ["+" | "-"] digits ["." digits] [("e" | "E") ["+" | "-"] digits]
//   digits = digit { ["_"] digit }                          (the floats of TOML 1.0)
//
//   parse_decimal  word = number * 2^fraction_bits, one rounding, half to even, of the exact
//                  value, however many digits there are
//   print_decimal  the exact decimal of word / 2^fraction_bits, every digit of it and no more:
//                  "0.0000152587890625" for 1 at 16 fraction bits, "-2.5", "3"
//
// What parse needs to know of a number is its integer part, its first 64 decimals and whether
// anything follows: a tie at 48 fraction bits has 49 decimals. So no buffer grows with the text.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "fixed/overflow.hpp"
#include "fixed/rounding.hpp"
#include "fixed/trap.hpp"
#include "fixed/wide_int.hpp"

namespace umbra78::fixed {

enum class DecimalStatus : std::uint8_t { ok, empty, bad_character, out_of_range };

// value is 0 unless the status is ok.
struct DecimalResult {
    std::int64_t value;
    DecimalStatus status;
    friend constexpr bool operator==(const DecimalResult&, const DecimalResult&) = default;
};

namespace detail {

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

// A cursor over the text that eats what the grammar allows.
struct DecimalReader {
    std::string_view text;
    std::size_t at = 0;

    constexpr bool done() const { return at == text.size(); }
    constexpr bool eat(char c) {
        const bool here = !done() && text[at] == c;
        at += here ? 1 : 0;
        return here;
    }
    constexpr bool eat_sign() { return eat('-') || (eat('+'), false); }  // true for minus

    // digits: calls visit(value) for each, false if there is none or an underscore stands alone.
    template <typename Visit>
    constexpr bool eat_digits(Visit visit) {
        do {
            if (done() || !is_digit(text[at])) {
                return false;
            }
            while (!done() && is_digit(text[at])) {
                visit(text[at++] - '0');
            }
        } while (eat('_'));
        return true;
    }
};

// |number| = integer + decimals / 10^64, and something smaller than 10^-64 if inexact.
struct DecimalParts {
    using Wide = WideInt<6>;
    static constexpr std::int64_t highest_place = 18, lowest_place = -64;
    static constexpr Wide unit = [] {  // 10^64
        Wide power = 1;
        for (std::int64_t place = 0; place > lowest_place; --place) {
            power = power * 10;
        }
        return power;
    }();
    std::uint64_t integer = 0;
    Wide decimals = 0;
    bool inexact = false, too_large = false;

    // The digit of weight 10^place; places come in descending order, down to the lowest.
    constexpr void append(int digit, std::int64_t place) {
        if (place > highest_place) {
            too_large = too_large || digit != 0;
        } else if (place >= 0) {
            integer = integer * 10 + static_cast<std::uint64_t>(digit);
        } else if (place >= lowest_place) {
            decimals = decimals * 10 + digit;
        } else {
            inexact = inexact || digit != 0;
        }
    }

    // number * 2^fraction_bits, half to even.
    constexpr Wide round(int fraction_bits) const {
        const Wide whole = (Wide(static_cast<std::int64_t>(integer >> 1)) << 1) +
                           static_cast<std::int64_t>(integer & 1);
        auto [word, rest] = Wide::divide((whole * unit + decimals) << fraction_bits, unit);
        const auto half = (rest << 1) <=> unit;
        if (half > 0 || (half == 0 && (inexact || word.is_odd()))) {
            word += 1;
        }
        return word;
    }
};

}  // namespace detail

// 0 <= fraction_bits <= 48, 1 <= bits <= 64.
constexpr DecimalResult parse_decimal(std::string_view text, int fraction_bits, int bits) {
    require(fraction_bits >= 0 && fraction_bits <= 48, "decimal: 0..48 fraction bits");
    if (text.empty()) {
        return {0, DecimalStatus::empty};
    }
    // First the grammar and the exponent, which decides where the first digit stands.
    detail::DecimalReader reader{text};
    const bool negative = reader.eat_sign();
    const std::size_t first_digit = reader.at;
    std::int64_t place = -1, exponent = 0;
    bool good = reader.eat_digits([&](int) { ++place; });
    if (reader.eat('.')) {
        good = reader.eat_digits([](int) {}) && good;
    }
    const std::size_t end_of_digits = reader.at;
    if (reader.eat('e') || reader.eat('E')) {
        constexpr std::int64_t enough = INT64_MAX / 100;  // no text has so many digits
        const bool down = reader.eat_sign();
        good = reader.eat_digits([&](int digit) {
            exponent = exponent < enough ? exponent * 10 + digit : enough;
        }) && good;
        exponent = down ? -exponent : exponent;
    }
    if (!good || !reader.done()) {
        return {0, DecimalStatus::bad_character};
    }
    // Then the digits, and zeros down to the last place that is looked at.
    detail::DecimalParts parts;
    place += exponent;
    for (std::size_t at = first_digit; at < end_of_digits; ++at) {
        if (detail::is_digit(text[at])) {
            parts.append(text[at] - '0', place--);
        }
    }
    for (place = place > parts.highest_place ? parts.highest_place : place;
         place >= parts.lowest_place; --place) {
        parts.append(0, place);
    }
    const WideInt<6> rounded = parts.round(fraction_bits);
    const WideInt<6> word = negative ? -rounded : rounded;
    if (parts.too_large || !word.fits_int64() || !fits(word.to_int64(), bits)) {
        return {0, DecimalStatus::out_of_range};
    }
    return {word.to_int64(), DecimalStatus::ok};
}

// Sign, 19 digits, point, 60 decimals: room for every word.
inline constexpr std::size_t longest_decimal = 81;

// 0 <= fraction_bits <= 60. Returns the length; traps if `out` is too short.
constexpr int print_decimal(std::int64_t value, int fraction_bits, std::span<char> out) {
    require(fraction_bits >= 0 && fraction_bits <= 60, "decimal: 0..60 fraction bits");
    std::size_t length = 0;
    const auto put = [&](char c) {
        require(length < out.size(), "print_decimal: buffer too short");
        out[length++] = c;
    };
    if (value < 0) {
        put('-');
    }
    std::uint64_t integer = magnitude(value) >> fraction_bits;
    const std::uint64_t fraction_mask = (std::uint64_t{1} << fraction_bits) - 1;
    std::uint64_t power = 1;  // the highest power of ten in the integer part
    while (integer / power >= 10) {
        power *= 10;
    }
    for (; power != 0; power /= 10) {
        put(static_cast<char>('0' + integer / power));
        integer %= power;
    }
    std::uint64_t fraction = magnitude(value) & fraction_mask;
    if (fraction != 0) {
        put('.');
    }
    while (fraction != 0) {  // fraction < 2^60, so ten times it fits
        fraction *= 10;
        put(static_cast<char>('0' + (fraction >> fraction_bits)));
        fraction &= fraction_mask;
    }
    return static_cast<int>(length);
}

}  // namespace umbra78::fixed
