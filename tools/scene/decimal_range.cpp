#include "tools/scene/decimal_range.hpp"

#include "fixed/decimal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>

namespace umbra78::tools {
namespace {

constexpr std::int64_t max_values = 100'000;
constexpr int word_bits = 63;  // the difference of two words fits 64 bits

// word / 10^decimals.
std::string print(std::int64_t word, std::size_t decimals) {
    std::string digits = fmt::format("{:0>{}}", word < 0 ? -word : word, decimals + 1);
    if (decimals > 0) {
        digits.insert(digits.size() - decimals, ".");
        while (digits.back() == '0') digits.pop_back();
        if (digits.back() == '.') digits.pop_back();
    }
    return (word < 0 ? "-" : "") + digits;
}

std::size_t decimals_of(std::string_view number) {
    const std::size_t point = std::min(number.find('.'), number.size() - 1);
    std::size_t decimals = 0;
    for (const char letter : number.substr(point + 1)) decimals += letter != '_';
    return decimals;
}

}  // namespace

DecimalRange read_decimal_range(std::string_view text) {
    using fixed::DecimalStatus;
    std::array<std::string_view, 3> numbers;
    std::size_t count = 0, decimals = 0;
    for (std::size_t from = 0; from <= text.size(); ++count) {
        const std::size_t colon = std::min(text.find(':', from), text.size());
        if (count < numbers.size()) numbers[count] = text.substr(from, colon - from);
        from = colon + 1;
    }
    if (count != numbers.size()) return {{}, "a range has a first value, a last one and a step"};

    // A number that already has an exponent cannot take another one, and so is refused.
    for (const std::string_view number : numbers) {
        const std::string integer = fmt::format("{}e0", number);
        if (fixed::parse_decimal(integer, 0, 64).status == DecimalStatus::bad_character)
            return {{}, fmt::format("'{}' is not a number", number)};
        decimals = std::max(decimals, decimals_of(number));
    }
    std::array<std::int64_t, 3> words;
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        const std::string integer = fmt::format("{}e{}", numbers[k], decimals);
        const auto [word, status] = fixed::parse_decimal(integer, 0, word_bits);
        if (status != DecimalStatus::ok) return {{}, "the numbers are too long"};
        words[k] = word;
    }

    const auto [first, last, step] = words;
    if (step == 0 || (first != last && (first < last) != (step > 0)))
        return {{}, "the step does not lead from the first value to the last"};
    // From a value to itself any step leads, in no steps.
    const std::int64_t steps = (last - first) / step;
    if (steps >= max_values) return {{}, fmt::format("{} values are too many", steps + 1)};
    DecimalRange range;
    for (std::int64_t k = 0; k <= steps; ++k)
        range.values.push_back(print(first + k * step, decimals));
    return range;
}

}  // namespace umbra78::tools
