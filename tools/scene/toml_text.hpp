// A TOML document in which every number is still the text it was written as.
//
// toml++ checks the grammar, but hands out decimals as double, and a scene needs them exact. So a
// document becomes this small tree: toml++ says where a number stands, and its characters are
// taken from there. A value given on the command line becomes the same kind of node.
#pragma once

#include "tools/scene/scene_error.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace umbra78::tools {

struct TomlNode {
    enum class Kind { table, array, text, number, other };

    Kind kind = Kind::table;
    std::string where{};  // "scene.toml:12", or "--set bias=64": what an error's line begins with
    std::string key{};    // in a table
    std::string text{};   // of a text or a number; of another kind, what to call it
    std::vector<TomlNode> children{};  // of a table in the order of the file, or of an array

    const TomlNode* find(std::string_view child) const;
};

// Throws SceneError for what is no TOML. `name` is the file's, for `where`.
TomlNode parse_toml(std::string_view text, const std::string& name);

// The value of "key=value", as --set takes it: an array [...], a number, or else a text, with or
// without quotes.
TomlNode parse_override(const std::string& key_and_value);

// "a number", "the text 'x'": what an error calls a value of the wrong kind.
std::string describe(const TomlNode&);

}  // namespace umbra78::tools
