#include "tools/io/text_formats.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace umbra78::tools {

using nlohmann::ordered_json;

ordered_json parse_json(std::string_view text) { return ordered_json::parse(text); }

std::string print(const ordered_json& json) {
    return json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

std::string print_line(const ordered_json& json) {
    return json.dump(-1, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

std::string markdown_table(const std::vector<std::vector<std::string>>& rows) {
    std::vector<std::size_t> widths(rows.front().size());
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
