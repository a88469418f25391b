#include "tools/scene/table_reader.hpp"

#include "fixed/decimal.hpp"
#include "tools/io/suggest.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace umbra78::tools {
namespace {

using fixed::DecimalStatus;
using Kind = TomlNode::Kind;

std::string print(std::int64_t word, int fraction) {
    if (word == 1 && fraction > 8) return fmt::format("2^-{}", fraction);  // 13 digits and more
    std::array<char, fixed::longest_decimal> text;
    const int length = fixed::print_decimal(word, fraction, text);
    return {text.data(), static_cast<std::size_t>(length)};
}

[[noreturn]] void fail_of_kind(const TomlNode& node, const std::string& called,
                               std::string_view remedy) {
    fail(node, fmt::format("{} is {}; {}", called, describe(node), remedy));
}

}  // namespace

void fail(const TomlNode& where, const std::string& what) {
    throw SceneError(where.where + ": " + what);
}

std::string print(const NumberRange& range) {
    return print(range.min, range.fraction) + " .. " + print(range.max, range.fraction);
}

std::int64_t read_number(const TomlNode& node, const std::string& called,
                         const NumberRange& range) {
    if (node.kind != Kind::number) fail_of_kind(node, called, "write a number");
    const auto [word, status] = fixed::parse_decimal(node.text, range.fraction, 64);
    if (status == DecimalStatus::bad_character)
        fail_of_kind(node, called, "write a decimal, such as 2.5");
    if (range.fraction == 0 && node.text.find_first_of(".eE") != node.text.npos)
        fail_of_kind(node, called, "write a whole number");
    if (status != DecimalStatus::ok || word < range.min || word > range.max)
        fail(node, fmt::format("{} is {}; its range is {}", called, node.text, print(range)));
    return word;
}

raster::World read_point(const TomlNode& node, const std::string& called) {
    if (node.kind != Kind::array || node.children.size() != 3)
        fail_of_kind(node, called, "write [x, y, z]");
    const auto word = [&](std::size_t axis) {
        return static_cast<std::int32_t>(read_number(
            node.children[axis], fmt::format("{} of {}", "xyz"[axis], called), place_range));
    };
    return {word(0), word(1), word(2)};
}

int read_choice(const TomlNode& node, const std::string& called,
                std::span<const std::string_view> names) {
    const auto found = std::find(names.begin(), names.end(), node.text);
    if (node.kind != Kind::text || found == names.end())
        fail_of_kind(node, called, suggest(node.text, names));
    return static_cast<int>(found - names.begin());
}

std::string read_text(const TomlNode& node, const std::string& called) {
    if (node.kind != Kind::text) fail_of_kind(node, called, "write a name in quotes");
    return node.text;
}

TableReader::TableReader(const TomlNode& table, std::string title, Keys keys)
    : table_(table), title_(std::move(title)) {
    if (table.kind != Kind::table)
        fail(table, fmt::format("{0} is {1}; write {0} and its keys below it", title_,
                                describe(table)));
    for (const TomlNode& node : table.children)
        if (std::find(keys.begin(), keys.end(), node.key) == keys.end())
            fail(node, fmt::format("unknown key '{}' in {}; {}", node.key, title_,
                                   suggest(node.key, keys)));
}

const TomlNode& TableReader::need(std::string_view key, std::string_view example) const {
    const TomlNode* node = find(key);
    if (!node)
        fail(table_, fmt::format("{} has no '{}'; add {} = {}", title_, key, key, example));
    return *node;
}

std::string TableReader::called(std::string_view key) const {
    return fmt::format("'{}' in {}", key, title_);
}

std::int64_t TableReader::number(std::string_view key, const NumberRange& range,
                                 std::int64_t otherwise) const {
    const TomlNode* node = find(key);
    return node ? read_number(*node, called(key), range) : otherwise;
}

int TableReader::choice(std::string_view key, Keys names, int otherwise) const {
    const TomlNode* node = find(key);
    return node ? read_choice(*node, called(key), names) : otherwise;
}

}  // namespace umbra78::tools
