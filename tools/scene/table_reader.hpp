// A table of a scene file, read key by key into exact words. What is wrong is reported to a
// FirstError, in a line that begins with the node's `where`, and a harmless value is returned.
#pragma once

#include "tools/scene/scene_keys.hpp"
#include "tools/scene/toml_text.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace umbra78::tools {

void report(FirstError&, const TomlNode& where, const std::string& what);

// `called` is the value's name in an error. After an error a number is the one in its range that
// is nearest to 0, a choice is the first, a text is empty.
std::int64_t read_number(const TomlNode&, const std::string& called, const NumberRange&,
                         FirstError&);
raster::World read_point(const TomlNode&, const std::string& called, const NumberRange&,
                         FirstError&);
int read_choice(const TomlNode&, const std::string& called,
                std::span<const std::string_view> names, FirstError&);
std::string read_text(const TomlNode&, const std::string& called, FirstError&);

// Reports a node that is not a table, and the first key that is not among `keys`. `title` is what
// errors call the table.
void check_keys(const TomlNode&, std::string_view title, std::span<const std::string_view> keys,
                FirstError&);

// Reads a table by its rows of scene_keys.hpp. Every `key` below must be one of them.
class TableReader {
public:
    // Checks the node's keys. The node, the table and the error outlive the reader.
    TableReader(const TomlNode&, const SceneTable&, FirstError&);

    const TomlNode* find(std::string_view key) const { return node_.find(key); }
    // Reports a key that is left out; then it is an empty table.
    const TomlNode& need(std::string_view key) const;

    // The value, or the row's default where it is left out.
    std::int64_t number(std::string_view key) const;
    int choice(std::string_view key) const;
    // The value, or `otherwise` where it is left out.
    std::int64_t number(std::string_view key, std::int64_t otherwise,
                        bool in_perspective = false) const;
    raster::World point(std::string_view key, const raster::World& otherwise) const;
    raster::Levels levels(std::string_view key) const;
    // The value, which must be given.
    std::int64_t needed_number(std::string_view key) const;
    raster::World needed_point(std::string_view key) const;
    std::string needed_text(std::string_view key) const;

    std::string called(std::string_view key) const;  // "'radius' in [[sphere]]"
    const TomlNode& node() const { return node_; }
    const std::string& title() const { return title_; }
    FirstError& error() const { return error_; }
    void report(const TomlNode& where, const std::string& what) const;

private:
    const TomlNode& node_;
    const SceneTable& table_;
    FirstError& error_;
    std::string title_;
};

}  // namespace umbra78::tools
