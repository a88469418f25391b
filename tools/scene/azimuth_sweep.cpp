#include "tools/scene/azimuth_sweep.hpp"

#include "fixed/decimal.hpp"
#include "fixed/rounding.hpp"
#include "tools/scene/scene_keys.hpp"
#include "tools/scene/table_reader.hpp"

#include <fmt/format.h>

#include <array>

namespace umbra78::tools {
namespace {

std::int64_t read_end(const std::string& where, const std::string& text, FirstError& error) {
    const TomlNode node{.kind = TomlNode::Kind::number, .where = where, .text = text};
    const auto read = fixed::parse_decimal(text, 0, 64);
    if (text.empty() || read.status == fixed::DecimalStatus::bad_character)
        report(error, node, "write two azimuths in degrees, such as -100:80");
    return read_number(node, "an azimuth", azimuth_range, error);
}

}  // namespace

std::string AzimuthSweep::at(int frame, int frames) const {
    std::int64_t word = from_q16;
    if (frames > 1)
        word += fixed::round_divide((to_q16 - from_q16) * (frame - 1), frames - 1,
                                    fixed::Rounding::half_even);
    std::array<char, fixed::longest_decimal> text;
    const int length = fixed::print_decimal(word, 16, text);
    return {text.data(), static_cast<std::size_t>(length)};
}

std::string AzimuthSweep::override_at(int frame, int frames) const {
    return fmt::format("{}.azimuth={}", view, at(frame, frames));
}

AzimuthSweep read_sweep(const std::string& view, const std::string& text, FirstError& error) {
    const std::string where = fmt::format("--{} {}", view, text);
    const std::size_t colon = text.find(':');
    const std::string from = text.substr(0, colon);
    const std::string to = colon == std::string::npos ? "" : text.substr(colon + 1);
    const std::int64_t first = read_end(where, from, error);
    return {view, first, read_end(where, to, error)};
}

}  // namespace umbra78::tools
