#include "tools/cli/two_numbers.hpp"

#include <fmt/format.h>

#include <charconv>

namespace umbra78::tools {

std::optional<std::pair<int, int>> two_numbers(std::string_view text, char between) {
    std::pair<int, int> two;
    const char* const end = text.data() + text.size();
    const auto a = std::from_chars(text.data(), end, two.first);
    if (a.ec != std::errc{} || a.ptr == end || *a.ptr != between) return {};
    const auto b = std::from_chars(a.ptr + 1, end, two.second);
    if (b.ec != std::errc{} || b.ptr != end) return {};
    return two;
}

std::string check_pixel(const std::string& text) {
    if (two_numbers(text, ',')) return "";
    return fmt::format("'{}' is not a pixel; write x,y as in 80,180", text);
}

}  // namespace umbra78::tools
