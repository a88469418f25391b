#include "tools/io/markdown.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace umbra78::tools {

std::string markdown_table(const std::vector<std::vector<std::string>>& rows) {
    std::vector<std::size_t> widths(rows.at(0).size());
    for (const auto& row : rows)
        for (std::size_t c = 0; c < widths.size(); ++c)
            widths[c] = std::max(widths[c], row[c].size());
    std::string text, rule;
    for (const std::size_t width : widths) rule += fmt::format("|{:-<{}}", "", width + 2);
    for (const auto& row : rows) {
        for (std::size_t c = 0; c < widths.size(); ++c)
            text += fmt::format("| {:<{}} ", row[c], widths[c]);
        text += "|\n";
        if (&row == &rows.front()) text += rule + "|\n";
    }
    return text;
}

}  // namespace umbra78::tools
