#include "tools/scene/table_reader.hpp"

#include "fixed/decimal.hpp"
#include "tools/io/suggest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace umbra78::tools {
namespace {

using fixed::DecimalStatus;
using Kind = TomlNode::Kind;

const TomlNode nothing;

void report_kind(FirstError& error, const TomlNode& node, const std::string& called,
                 std::string_view remedy) {
    report(error, node, fmt::format("{} is {}; {}", called, describe(node), remedy));
}

std::int32_t narrow(std::int64_t word) { return static_cast<std::int32_t>(word); }

// read_number; `called()` makes the name, which only an error needs.
template <class Called>
std::int64_t number_of(const TomlNode& node, Called called, const NumberRange& range,
                       FirstError& error) {
    const auto [word, status] = fixed::parse_decimal(node.text, range.fraction, 64);
    if (node.kind != Kind::number)
        report_kind(error, node, called(), "write a number");
    else if (status == DecimalStatus::bad_character)
        report_kind(error, node, called(), "write a decimal, such as 2.5");
    else if (range.fraction == 0 && node.text.find_first_of(".eE") != node.text.npos)
        report_kind(error, node, called(), "write a whole number");
    else if (status != DecimalStatus::ok || word < range.min || word > range.max)
        report(error, node,
               fmt::format("{} is {}; its range is {}", called(), node.text, print(range)));
    else
        return word;
    return std::clamp<std::int64_t>(0, range.min, range.max);
}

}  // namespace

void report(FirstError& error, const TomlNode& where, const std::string& what) {
    error.report(where.where + ": " + what);
}

std::int64_t read_number(const TomlNode& node, const std::string& called,
                         const NumberRange& range, FirstError& error) {
    return number_of(node, [&] { return called; }, range, error);
}

raster::World read_point(const TomlNode& node, const std::string& called, const NumberRange& range,
                         FirstError& error) {
    TomlNode room;
    const std::vector<TomlNode>& items = with_items(node, room).children;
    if (node.kind != Kind::array || items.size() != 3) {
        report_kind(error, node, called, "write [x, y, z]");
        return {};
    }
    const auto word = [&](std::size_t axis) {
        const auto name = [&] { return fmt::format("{} of {}", "xyz"[axis], called); };
        return narrow(number_of(items[axis], name, range, error));
    };
    return {word(0), word(1), word(2)};
}

int read_choice(const TomlNode& node, const std::string& called,
                std::span<const std::string_view> names, FirstError& error) {
    const auto found = std::find(names.begin(), names.end(), node.text);
    if (node.kind == Kind::text && found != names.end())
        return static_cast<int>(found - names.begin());
    report_kind(error, node, called, suggest(node.text, names));
    return 0;
}

std::string read_text(const TomlNode& node, const std::string& called, FirstError& error) {
    if (node.kind == Kind::text) return node.text;
    report_kind(error, node, called, "write a name in quotes");
    return "";
}

void check_keys(const TomlNode& node, std::string_view title,
                std::span<const std::string_view> keys, FirstError& error) {
    if (node.kind != Kind::table) {
        report(error, node, fmt::format("{0} is {1}; write {0} and its keys below it", title,
                                        describe(node)));
        return;
    }
    for (const TomlNode& child : node.children) {
        if (std::find(keys.begin(), keys.end(), child.key) != keys.end()) continue;
        report(error, child, fmt::format("unknown key '{}' in {}; {}", child.key, title,
                                         suggest(child.key, keys)));
        return;
    }
}

TableReader::TableReader(const TomlNode& node, const SceneTable& table, FirstError& error)
    : node_(node), table_(table), error_(error),
      // A table of which there may be many, and that is written as the only one.
      title_(node.key == table.name ? fmt::format("[{}]", table.name) : title_of(table)) {
    std::vector<std::string_view> keys;
    for (const SceneKey& key : table.keys) keys.push_back(key.key);
    check_keys(node, title_, keys, error);
}

const TomlNode& TableReader::need(std::string_view key) const {
    if (const TomlNode* node = find(key)) return *node;
    report(node_, fmt::format("{} has no '{}'; add {} = {}", title_, key, key,
                              scene_key(table_, key).example));
    return nothing;
}

std::int64_t TableReader::number(std::string_view key) const {
    return number(key, scene_key(table_, key).fallback);
}

int TableReader::choice(std::string_view key) const {
    const SceneKey& row = scene_key(table_, key);
    const TomlNode* node = find(key);
    return node ? read_choice(*node, called(key), row.choices, error_)
                : static_cast<int>(row.fallback);
}

std::int64_t TableReader::number(std::string_view key, std::int64_t otherwise,
                                 bool in_perspective) const {
    const SceneKey& row = scene_key(table_, key);
    const NumberRange& range = in_perspective && row.perspective ? *row.perspective : row.range;
    const TomlNode* node = find(key);
    return node ? read_number(*node, called(key), range, error_) : otherwise;
}

raster::World TableReader::point(std::string_view key, const raster::World& otherwise) const {
    const TomlNode* node = find(key);
    return node ? read_point(*node, called(key), scene_key(table_, key).range, error_) : otherwise;
}

raster::Levels TableReader::levels(std::string_view key) const {
    const SceneKey& row = scene_key(table_, key);
    const TomlNode* node = find(key);
    if (!node) return narrow(row.fallback);
    if (node->kind != Kind::array)
        return narrow(read_number(*node, called(key), row.range, error_));
    TomlNode room;
    const std::vector<TomlNode>& items = with_items(*node, room).children;
    if (items.size() != 3) {
        report_kind(error_, *node, called(key), "write a number, or [red, green, blue]");
        return narrow(row.fallback);
    }
    const auto word = [&](std::size_t channel) {
        constexpr const char* names[] = {"red", "green", "blue"};
        return narrow(read_number(items[channel],
                                  fmt::format("{} of {}", names[channel], called(key)), row.range,
                                  error_));
    };
    return {word(0), word(1), word(2)};
}

std::int64_t TableReader::needed_number(std::string_view key) const {
    return read_number(need(key), called(key), scene_key(table_, key).range, error_);
}

raster::World TableReader::needed_point(std::string_view key) const {
    return read_point(need(key), called(key), scene_key(table_, key).range, error_);
}

std::string TableReader::needed_text(std::string_view key) const {
    return read_text(need(key), called(key), error_);
}

std::string TableReader::called(std::string_view key) const {
    return fmt::format("'{}' in {}", key, title_);
}

void TableReader::report(const TomlNode& where, const std::string& what) const {
    tools::report(error_, where, what);
}

}  // namespace umbra78::tools
