#include "tools/study/vary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <optional>

namespace umbra78::tools::study {
namespace {

constexpr int max_decimals = 12;
constexpr std::int64_t max_values = 100'000;

[[noreturn]] void fail(const std::string& text, std::string_view wrong) {
    throw SceneError(fmt::format("--vary {}: {}; write key=first:last:step as in bias=0:256:32, "
                                 "or key=value,value as in lookup=nearest,bilinear", text, wrong));
}

struct Decimal {
    std::int64_t digits = 0;
    int decimals = 0;
};

std::optional<Decimal> read_decimal(std::string_view text) {
    Decimal read;
    const bool negative = text.starts_with('-');
    if (negative) text.remove_prefix(1);
    bool behind_point = false, any = false;
    for (const char letter : text) {
        if (letter == '.' && !behind_point) {
            behind_point = true;
            continue;
        }
        if (letter < '0' || letter > '9') return {};
        if (read.digits > 1'000'000'000'000 || read.decimals == max_decimals) return {};
        read.digits = read.digits * 10 + (letter - '0');
        read.decimals += behind_point;
        any = true;
    }
    if (!any) return {};
    if (negative) read.digits = -read.digits;
    return read;
}

// In units of 10^-decimals; nothing where that is too large a number.
std::optional<std::int64_t> scaled(const Decimal& d, int decimals) {
    std::int64_t word = d.digits;
    for (int k = d.decimals; k < decimals; ++k)
        if (__builtin_mul_overflow(word, 10, &word)) return {};
    return word;
}

std::string print(std::int64_t word, int decimals) {
    std::string digits = fmt::format("{:0>{}}", std::abs(word), decimals + 1);
    if (decimals > 0) {
        digits.insert(digits.size() - static_cast<std::size_t>(decimals), ".");
        while (digits.ends_with('0')) digits.pop_back();
        if (digits.ends_with('.')) digits.pop_back();
    }
    return (word < 0 ? "-" : "") + digits;
}

// Cut at `mark`, but not between brackets.
std::vector<std::string> cut(std::string_view text, char mark) {
    std::vector<std::string> pieces(1);
    int depth = 0;
    for (const char letter : text) {
        depth += (letter == '[') - (letter == ']');
        if (letter == mark && depth == 0) {
            pieces.emplace_back();
        } else {
            pieces.back() += letter;
        }
    }
    return pieces;
}

std::vector<std::string> range(const std::string& text, const std::vector<std::string>& ends) {
    if (ends.size() != 3) fail(text, "a range has a first value, a last one and a step");
    std::array<Decimal, 3> read;
    int decimals = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto number = read_decimal(ends[k]);
        if (!number) fail(text, fmt::format("'{}' is no number", ends[k]));
        read[k] = *number;
        decimals = std::max(decimals, number->decimals);
    }
    const auto first = scaled(read[0], decimals), last = scaled(read[1], decimals),
               step = scaled(read[2], decimals);
    if (!first || !last || !step) fail(text, "the numbers are too long");
    if (*step == 0 || (*last - *first) / *step < 0 || ((*last < *first) != (*step < 0) &&
                                                       *last != *first))
        fail(text, "the step does not lead from the first value to the last");
    const std::int64_t steps = (*last - *first) / *step;
    if (steps >= max_values) fail(text, fmt::format("{} values are too many", steps + 1));
    std::vector<std::string> values;
    for (std::int64_t k = 0; k <= steps; ++k) values.push_back(print(*first + k * *step, decimals));
    return values;
}

}  // namespace

GridKey parse_vary(const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0) fail(text, "there is no key");
    const std::string key = text.substr(0, equals), rest = text.substr(equals + 1);
    if (const auto ends = cut(rest, ':'); ends.size() > 1) return {key, range(text, ends)};
    GridKey axis{key, cut(rest, ',')};
    auto& values = axis.second;
    for (std::size_t k = 0; k < values.size(); ++k) {
        if (values[k].empty()) fail(text, "a value is missing");
        if (std::find(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(k),
                      values[k]) != values.begin() + static_cast<std::ptrdiff_t>(k))
            fail(text, fmt::format("'{}' is there twice", values[k]));
    }
    return axis;
}

void check_vary(const Request& request) {
    for (std::size_t k = 0; k < request.vary.size(); ++k) {
        const auto& [key, values] = request.vary[k];
        for (std::size_t other = 0; other < k; ++other)
            if (request.vary[other].first == key)
                throw SceneError(fmt::format(
                    "--vary {}: it is given twice; write all its values in one --vary", key));
        for (const std::string& value : values) {
            std::vector<std::string> set;
            for (const auto& [other, first] : request.vary)
                set.push_back(other + "=" + (other == key ? value : first.front()));
            try {
                scene_of(request, {{}, set, {}});
            } catch (const SceneError& error) {
                std::string what = error.what();
                if (what.starts_with("--set ")) what.replace(0, 6, "--vary ");
                throw SceneError(what);
            }
        }
    }
}

}  // namespace umbra78::tools::study
