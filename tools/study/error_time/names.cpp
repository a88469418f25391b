// Short names of settings for the report of error against run time.
#include "tools/study/error_time/error_time.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

namespace umbra78::tools::study {
namespace {

// A setting in a word or two.
std::string word_of(const std::string& key, const std::string& value) {
    if (key == "xy_bits") return value + " bits";
    if (key == "z_bits") return "Z " + value;
    if (key == "coefficient_bits") return value + "-bit coefficients";
    if (key == "form") return value == "correct" ? "correct form" : "post-process";
    if (key == "dither") return value == "none" ? "no dither" : value + " dither";
    if (key == "dequantize") return value == "0" ? "unfiltered" : "edges dequantized";
    if (key == "low_pass") return value == "0" ? "" : "low-passed";
    if (key == "lookup" || key == "profile") return value;
    if (key == "sampling") return value + " sampling";
    if (key == "bias_unit") return value;
    return fmt::format("{} {}", key, value);
}

}  // namespace

std::string short_name(const Row& row, std::span<const Row> all) {
    std::vector<std::string> words;
    const auto add = [&](const std::string& key) {
        const std::string value = row.text(key);
        const auto alike = std::count_if(all.begin(), all.end(),
                                         [&](const Row& r) { return r.text(key) == value; });
        // What most rows share is left out, except what the main grid varies.
        constexpr std::array<std::string_view, 4> said{"xy_bits", "lookup", "dither",
                                                       "dequantize"};
        const bool is_said = std::find(said.begin(), said.end(), key) != said.end();
        const auto rows = static_cast<std::ptrdiff_t>(all.size());
        if (value.empty() || alike == rows || (!is_said && 2 * alike > rows)) return;
        std::string word = word_of(key, value);
        if (key == "bias") word += " " + row.text("bias_unit");
        if (!word.empty()) words.push_back(word);
    };
    // Overrides, extra columns and settings: all columns before the figures.
    for (const auto& [key, value] : row.cells()) {
        if (key == "status") break;
        if (key != "case" && key != "name" && key != "arithmetic" && key != "clock_ns") add(key);
    }
    if (words.empty()) return row.text("name");
    return fmt::format("{}", fmt::join(words, ", "));
}

}  // namespace umbra78::tools::study
