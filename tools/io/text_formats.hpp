// Text formats: JSON read and printed, and Markdown tables.
//
// JSON is nlohmann's. Its header takes five seconds to compile, so its parser and printer are
// called in text_formats.cpp alone.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace umbra78::tools {

// Throws nlohmann::json::exception if the text is not JSON.
nlohmann::ordered_json parse_json(std::string_view text);

// Both end with a newline. A string that is not UTF-8, as file names may be, is printed with U+FFFD
// in place of its wrong bytes.
std::string print(const nlohmann::ordered_json&);       // indented by two blanks a level
std::string print_line(const nlohmann::ordered_json&);  // on one line

// A table whose columns also line up in a terminal. The first row is the head. All rows have the
// same number of cells, and there is at least one row.
std::string markdown_table(const std::vector<std::vector<std::string>>& rows);

}  // namespace umbra78::tools
