#include "tools/study/vary.hpp"

#include "fixed/decimal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <unordered_set>

namespace umbra78::tools::study {
namespace {

constexpr int max_decimals = 12;
constexpr std::int64_t max_values = 100'000;

[[noreturn]] void fail(const std::string& text, std::string_view wrong) {
    throw SceneError(fmt::format("--vary {}: {}; write key=first:last:step as in bias=0:256:32, "
                                 "or key=value,value as in lookup=nearest,bilinear", text, wrong));
}

// How many digits stand after the point.
int decimals_of(std::string_view text) {
    const std::size_t point = text.find('.');
    if (point == std::string_view::npos) return 0;
    return static_cast<int>(std::count_if(text.begin() + static_cast<std::ptrdiff_t>(point) + 1,
                                          text.end(), [](char c) { return c != '_'; }));
}

// The number in units of 10^-decimals, exactly: with as many decimals it is a whole number.
std::int64_t scaled(const std::string& text, const std::string& number, int decimals) {
    constexpr int bits = 62;  // the difference of two such words fits 63
    const fixed::DecimalResult read =
        fixed::parse_decimal(fmt::format("{}e{}", number, decimals), 0, bits);
    if (read.status == fixed::DecimalStatus::out_of_range) fail(text, "the numbers are too long");
    if (read.status != fixed::DecimalStatus::ok)
        fail(text, fmt::format("'{}' is not a number", number));
    return read.value;
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

// The pieces of the text between the marks. A mark between brackets does not count.
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
    int decimals = 0;
    for (const std::string& end : ends) decimals = std::max(decimals, decimals_of(end));
    if (decimals > max_decimals)
        fail(text, fmt::format("the numbers have more than {} decimals", max_decimals));
    const std::int64_t first = scaled(text, ends[0], decimals),
                       last = scaled(text, ends[1], decimals),
                       step = scaled(text, ends[2], decimals);
    if (step == 0 || (last != first && (last < first) != (step < 0)))
        fail(text, "the step does not lead from the first value to the last");
    const std::int64_t steps = (last - first) / step;
    if (steps >= max_values) fail(text, fmt::format("{} values are too many", steps + 1));
    std::vector<std::string> values;
    for (std::int64_t k = 0; k <= steps; ++k) values.push_back(print(first + k * step, decimals));
    return values;
}

}  // namespace

GridKey parse_vary(const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0) fail(text, "there is no key");
    const std::string key = text.substr(0, equals), rest = text.substr(equals + 1);
    if (const auto ends = cut(rest, ':'); ends.size() > 1) return {key, range(text, ends)};
    GridKey axis{key, cut(rest, ',')};
    std::unordered_set<std::string> seen;
    for (const std::string& value : axis.second) {
        if (value.empty()) fail(text, "a value is missing");
        if (!seen.insert(value).second) fail(text, fmt::format("'{}' is given twice", value));
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
