#include "tools/models/obj_corner.hpp"

#include <fmt/format.h>

#include <charconv>

namespace umbra78::tools {
namespace {

void report_corner(const ModelWord& word, const std::string& name, FirstError& error) {
    report_at(error, name, word.line, shown(word.text) + " is no corner; write v, v/t, v//n or "
                                                         "v/t/n, numbers from 1, or from -1 back");
}

std::int64_t read_number(std::string_view text, std::size_t known, const ModelWord& word,
                         const std::string& name, FirstError& error) {
    std::int64_t value = 0;
    const auto [stop, status] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (stop != text.data() + text.size() || status != std::errc{} || value == 0)
        report_corner(word, name, error);
    if (value > 0) return value - 1;
    value += static_cast<std::int64_t>(known);
    if (value < 0)
        report_at(error, name, word.line,
                  fmt::format("{} goes back beyond the first; only {} stand before it",
                              shown(word.text), known));
    return value;
}

}  // namespace

ObjCorner read_corner(const ModelWord& word, std::size_t vertices, std::size_t normals,
                      const std::string& name, FirstError& error) {
    std::array<std::string_view, 3> parts{};
    std::size_t part = 0, begin = 0;
    for (std::size_t at = 0; at <= word.text.size(); ++at) {
        if (at < word.text.size() && word.text[at] != '/') continue;
        if (part < 3) parts[part] = word.text.substr(begin, at - begin);
        ++part, begin = at + 1;
    }
    if (part > 3) report_corner(word, name, error);
    ObjCorner corner{.line = word.line};
    corner.vertex = read_number(parts[0], vertices, word, name, error);
    constexpr std::size_t any = SIZE_MAX / 2;  // texture's vertices are not looked at
    if (!parts[1].empty()) read_number(parts[1], any, word, name, error);
    if (!parts[2].empty()) corner.normal = read_number(parts[2], normals, word, name, error);
    return corner;
}

ModelPoint point_at(const std::vector<ModelPoint>& all, std::int64_t number, const char* what,
                    int line, const std::string& name, FirstError& error) {
    if (number >= 0 && number < static_cast<std::int64_t>(all.size()))
        return all[static_cast<std::size_t>(number)];
    report_at(error, name, line, fmt::format("{} {} is named; there are {}: correct the number",
                                             what, number + 1, all.size()));
    return {};
}

}  // namespace umbra78::tools
