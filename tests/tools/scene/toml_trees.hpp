// The tree of a TOML document in lines, all arrays read, so that trees can be compared.
#pragma once

#include "tools/scene/toml_text.hpp"

#include <string>

namespace umbra78::tools::test {

inline void print_tree(const TomlNode& node, int depth, std::string& out) {
    out.append(static_cast<std::size_t>(depth), ' ');
    out += node.where + " " + std::to_string(static_cast<int>(node.kind)) + " '" + node.key +
           "' '" + node.text + "'\n";
    TomlNode room;
    for (const TomlNode& child : with_items(node, room).children)
        print_tree(child, depth + 1, out);
}

// The tree, or the error.
inline std::string printed_toml(std::string_view text, ArraysOfNumbers arrays) {
    FirstError error;
    const TomlNode root = parse_toml(text, "a.toml", error, arrays);
    if (error.any()) return error.line();
    std::string out;
    print_tree(root, 0, out);
    return out;
}

// Whether a text means the same if its arrays of numbers stay text. Of two errors toml++ may report
// another one: it finds invalid UTF-8 up to 32 bytes before it reads what stands there.
inline bool same_both_ways(std::string_view text) {
    const std::string read = printed_toml(text, ArraysOfNumbers::are_read);
    const std::string stay = printed_toml(text, ArraysOfNumbers::stay_text);
    if (read == stay) return true;
    const auto is_error = [](const std::string& s) { return s.find("not valid") != s.npos; };
    const auto is_utf8 = [](const std::string& s) { return s.find("utf-8") != s.npos; };
    return is_error(read) && is_error(stay) && (is_utf8(read) || is_utf8(stay));
}

}  // namespace umbra78::tools::test
