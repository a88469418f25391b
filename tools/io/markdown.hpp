// A Markdown table whose columns line up in a terminal too.
#pragma once

#include <string>
#include <vector>

namespace umbra78::tools {

// The first row is the head; all rows are equally long.
std::string markdown_table(const std::vector<std::vector<std::string>>& rows);

}  // namespace umbra78::tools
