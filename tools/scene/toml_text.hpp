// A TOML document as a tree in which every number is still the text that was written.
//
// toml++ checks the grammar, but gives decimals as double, and a scene needs them exact. So toml++
// gives the place of a number in the document, and its characters are taken from there. Arrays of
// plain numbers in tables do not pass through it: they stay text until they are asked for, so that
// one patch of a scene has a tree at a time (number_arrays.hpp). A value given on the command line
// becomes the same kind of node.
#pragma once

#include "tools/io/first_error.hpp"
#include "tools/scene/number_arrays.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace umbra78::tools {

struct TomlNode {
    enum class Kind { table, array, text, number, other };

    Kind kind = Kind::table;
    std::string where{};  // "scene.toml:12" or "--set bias=64": an error's line begins with it
    std::string key{};    // in a table
    std::string text{};   // a text, or a number as it is written; of `other`: "a boolean", ...
    std::vector<TomlNode> children{};  // of a table in the order of the file, or of an array
    NumberArray numbers{};             // of an array that is not read: its text, in the document

    const TomlNode* find(std::string_view child) const;  // null if there is none
};

enum class ArraysOfNumbers { stay_text, are_read };

// The tree of a document; an empty table, and an error, if the text is not TOML. `name` is the
// file's, for `where`. The text must outlive a tree whose arrays stay text.
TomlNode parse_toml(std::string_view text, const std::string& name, FirstError&,
                    ArraysOfNumbers = ArraysOfNumbers::stay_text);

// The array itself, or `room`, into which it is read, if it has stayed text.
const TomlNode& with_items(const TomlNode&, TomlNode& room);

// "key=value" as --set takes it. The value is an array [...], a number, or else a text, with or
// without quotes. After an error the node is a text without a key.
TomlNode parse_override(const std::string& key_and_value, FirstError&);
// The same for the program; throws SceneError. Defined in scene_file.cpp.
TomlNode parse_override(const std::string& key_and_value);

// "the number 3", "the text 'x'": what an error calls a value of the wrong kind.
std::string describe(const TomlNode&);

}  // namespace umbra78::tools
