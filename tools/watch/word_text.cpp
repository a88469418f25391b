#include "tools/watch/word_text.hpp"

#include "fixed/decimal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>

namespace umbra78::tools {
namespace {

int magnitude_bits(std::int64_t value) {
    return static_cast<int>(
        std::bit_width(static_cast<std::uint64_t>(value < 0 ? ~value : value)));
}

}  // namespace

MachineWord signed_word(std::int64_t value, int bits, int fraction) {
    return {value, std::max(bits, magnitude_bits(value) + 1), fraction, true};
}

MachineWord unsigned_word(std::int64_t value, int bits, int fraction) {
    return {value, std::max(bits, magnitude_bits(value)), fraction, false};
}

// print_decimal has at most 60 places; more places, and words whose unit is above 1, are printed
// with a power of two.
std::string real_text(const MachineWord& word) {
    if (word.fraction < 0 || word.fraction > 60)
        return fmt::format("{} x 2^{}", word.value, -word.fraction);
    std::array<char, fixed::longest_decimal> text;
    const int length = fixed::print_decimal(word.value, word.fraction, text);
    return {text.data(), static_cast<std::size_t>(length)};
}

std::string format_text(const MachineWord& word) {
    const int whole = word.bits - word.fraction - (word.has_sign ? 1 : 0);
    return fmt::format("{}Q{}.{}", word.has_sign ? "" : "U", whole, word.fraction);
}

std::string hex_text(const MachineWord& word) {
    const std::uint64_t mask = word.bits >= 64 ? ~std::uint64_t{0}
                                               : (std::uint64_t{1} << word.bits) - 1;
    return fmt::format("{:0{}x}", static_cast<std::uint64_t>(word.value) & mask,
                       (word.bits + 3) / 4);
}

std::string decimal_text(WideWord value) {
    const bool negative = value.is_negative();
    std::string digits;
    for (value = value.abs(); !value.is_zero() || digits.empty(); value = value / WideWord(10))
        digits.push_back(static_cast<char>('0' + (value % WideWord(10)).to_int64()));
    if (negative) digits.push_back('-');
    return {digits.rbegin(), digits.rend()};
}

}  // namespace umbra78::tools
