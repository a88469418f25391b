// JSON read and written, in one file: nlohmann's parser takes five seconds to compile in each.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <string_view>

namespace umbra78::tools {

// Throws nlohmann::json::exception.
nlohmann::ordered_json parse_json(std::string_view text);

std::string print(const nlohmann::ordered_json&);       // two blanks of indent, a newline
std::string print_line(const nlohmann::ordered_json&);  // on one line, a newline

}  // namespace umbra78::tools
