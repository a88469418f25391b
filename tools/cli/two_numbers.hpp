// Two numbers in one argument: a pixel, 80,180, or a size, 1280x720.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace umbra78::tools {

std::optional<std::pair<int, int>> two_numbers(std::string_view text, char between);

// A check of command_line.hpp: what is wrong with a pixel, or nothing.
std::string check_pixel(const std::string& text);

}  // namespace umbra78::tools
