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
// A tie at 48 fraction bits has 49 decimals, so the value of a number is decided by its integer
// part, its first 64 decimals and whether anything but zeros follows them: no buffer grows with
// the text. Numbers of up to 18 digits, nearly all of those in a scene, are read in 64-bit words
// (ShortDecimal: 350 instructions); all others in 384-bit words (DecimalParts: 25 000).
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

// A cursor over the text that reads what the grammar allows.
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

// |number| = digits / 10^decimals, where both fit 18 digits and the word 62 bits.
struct ShortDecimal {
    static constexpr int max_digits = 18;

    // 10^n, 0 <= n <= 18.
    static constexpr std::uint64_t power_of_ten(std::int64_t n) {
        std::uint64_t power = 1;
        for (; n > 0; --n) {
            power *= 10;
        }
        return power;
    }

    // Takes the digits of `text` and 10^exponent. False where the number is not short.
    constexpr bool read(std::string_view text, std::int64_t exponent) {
        constexpr std::uint64_t limit = power_of_ten(max_digits);
        std::int64_t after_point = 0;
        bool point = false;
        for (const char c : text) {
            point = point || c == '.';
            if (is_digit(c)) {
                if (digits >= limit / 10) {
                    return false;
                }
                digits = digits * 10 + static_cast<std::uint64_t>(c - '0');
                after_point += point ? 1 : 0;
            }
        }
        decimals = digits == 0 ? 0 : after_point - exponent;
        for (; decimals < 0 && digits < limit / 10; ++decimals) {
            digits *= 10;
        }
        return decimals >= 0 && decimals <= max_digits;
    }

    // number * 2^fraction_bits, half to even: the integer part, then a bit at a time of the rest.
    // False where the word might not fit 62 bits.
    constexpr bool round(int fraction_bits, std::int64_t& rounded) const {
        const std::uint64_t divisor = power_of_ten(decimals);
        std::uint64_t word = digits / divisor, rest = digits % divisor;
        if (word >> (62 - fraction_bits) != 0) {
            return false;
        }
        for (int bit = 0; bit < fraction_bits; ++bit) {  // rest < 10^18 < 2^60
            rest *= 2;
            const bool one = rest >= divisor;
            rest -= one ? divisor : 0;
            word = word * 2 + (one ? 1 : 0);
        }
        const bool up = rounds_up(false, (word & 1) != 0, 2 * rest, divisor, Rounding::half_even);
        rounded = static_cast<std::int64_t>(word + (up ? 1 : 0));
        return true;
    }

    std::uint64_t digits = 0;
    std::int64_t decimals = 0;
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

// parse_decimal; without `use_short` every number takes the long way, which tests compare.
template <bool use_short>
constexpr DecimalResult parse_decimal(std::string_view text, int fraction_bits, int bits) {
    require(fraction_bits >= 0 && fraction_bits <= 48, "decimal: 0..48 fraction bits");
    if (text.empty()) {
        return {0, DecimalStatus::empty};
    }
    // The grammar and the exponent, which decides the first digit's place.
    DecimalReader reader{text};
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
    const std::string_view number = text.substr(first_digit, end_of_digits - first_digit);
    if constexpr (use_short) {
        ShortDecimal decimal;
        std::int64_t word = 0;
        if (decimal.read(number, exponent) && decimal.round(fraction_bits, word)) {
            word = negative ? -word : word;
            if (!fits(word, bits)) {
                return {0, DecimalStatus::out_of_range};
            }
            return {word, DecimalStatus::ok};
        }
    }
    // The digits, and zeros down to the last place that is looked at.
    DecimalParts parts;
    place += exponent;
    for (const char c : number) {
        if (is_digit(c)) {
            parts.append(c - '0', place--);
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

}  // namespace detail

// The word nearest to the number times 2^fraction_bits, half to even. Not a number, or a word of
// more than `bits` bits: the status says so. Traps unless 0 <= fraction_bits <= 48 and
// 1 <= bits <= 64.
constexpr DecimalResult parse_decimal(std::string_view text, int fraction_bits, int bits) {
    return detail::parse_decimal<true>(text, fraction_bits, bits);
}

// The length of the longest decimal: sign, 19 digits, point, 60 decimals.
inline constexpr std::size_t longest_decimal = 81;

// Writes the decimal without a final zero byte and returns its length. Traps unless
// 0 <= fraction_bits <= 60, and if `out` is too short.
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
