#include "tools/scene/toml_text.hpp"

#include "fixed/decimal.hpp"

#include <fmt/format.h>

#include <algorithm>

// toml++ 3.3 asserts that a key begins like a key (under clang it even assumes so). The key of
// "[=]" does not, and without the assertion toml++ reports that well: so its assertions are off in
// every build: NDEBUG is undefined so that clang does not assume them, and TOML_ASSERT is empty.
#undef NDEBUG
// The library that its package builds throws, so its sources are compiled here, without exceptions.
#undef TOML_SHARED_LIB
#undef TOML_HEADER_ONLY
#define TOML_SHARED_LIB 0
#define TOML_HEADER_ONLY 1
#define TOML_EXCEPTIONS 0
#define TOML_ASSERT(expr) static_assert(true)
#include <toml++/toml.h>

namespace umbra78::tools {
namespace {

// The text that toml++ was given, by lines, for its places: lines and columns from 1, a column is a
// code point. Where arrays are emptied, their numbers are known by their line.
class Source {
public:
    Source(std::string_view text, const std::string& name, const std::vector<NumberArray>& arrays)
        : name_(name), arrays_(arrays) {
        constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
        if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
        for (std::size_t begin = 0; begin <= text.size();) {
            const std::size_t end = std::min(text.find('\n', begin), text.size());
            lines_.push_back(text.substr(begin, end - begin));
            begin = end + 1;
        }
    }

    std::string where(const toml::source_region& at) const {
        return fmt::format("{}:{}", name_, at.begin.line);
    }

    // What the array that begins there held, if it was emptied.
    NumberArray numbers(const toml::source_region& at) const {
        const int line = static_cast<int>(at.begin.line);
        const auto found = std::lower_bound(
            arrays_.begin(), arrays_.end(), line,
            [](const NumberArray& array, int wanted) { return array.line < wanted; });
        return found != arrays_.end() && found->line == line ? *found : NumberArray{};
    }

    // The text of a value that stands on one line.
    std::string text(const toml::source_region& at) const {
        const std::string_view line = lines_[at.begin.line - 1];
        const std::size_t begin = byte(line, at.begin.column), end = byte(line, at.end.column);
        return std::string(line.substr(begin, end - begin));
    }

private:
    static std::size_t byte(std::string_view line, std::size_t column) {
        std::size_t at = 0;
        while (at < line.size() && column > 1) {
            ++at;
            while (at < line.size() && (line[at] & 0xC0) == 0x80) ++at;  // UTF-8 continues
            --column;
        }
        return at;
    }

    const std::string& name_;
    const std::vector<NumberArray>& arrays_;
    std::vector<std::string_view> lines_;
};

const char* name_of(toml::node_type type) {
    switch (type) {
        case toml::node_type::boolean: return "a boolean";
        case toml::node_type::date: return "a date";
        case toml::node_type::time: return "a time";
        case toml::node_type::date_time: return "a date";
        default: return "something else";
    }
}

bool stands_before(const toml::source_position& a, const toml::source_position& b) {
    return a.line != b.line ? a.line < b.line : a.column < b.column;
}

// Empties the tables and arrays of `from` as it goes, so that not both trees are there at once.
TomlNode convert(toml::node& from, const Source& source) {
    using Kind = TomlNode::Kind;
    TomlNode node;
    node.where = source.where(from.source());
    if (toml::table* table = from.as_table()) {
        std::vector<std::pair<toml::source_position, TomlNode>> members;
        for (auto&& [key, value] : *table) {
            members.emplace_back(key.source().begin, convert(value, source));
            members.back().second.key = key.str();
        }
        std::stable_sort(members.begin(), members.end(), [](const auto& a, const auto& b) {
            return stands_before(a.first, b.first);
        });
        node.children.reserve(members.size());
        for (auto& member : members) node.children.push_back(std::move(member.second));
        table->clear();
    } else if (toml::array* array = from.as_array()) {
        node.kind = Kind::array;
        if (array->empty()) node.numbers = source.numbers(from.source());
        node.children.reserve(array->size());
        for (toml::node& item : *array) node.children.push_back(convert(item, source));
        array->clear();
    } else if (from.is_number()) {
        node.kind = Kind::number;
        node.text = source.text(from.source());
    } else if (const toml::value<std::string>* text = from.as_string()) {
        node.kind = Kind::text;
        node.text = text->get();
    } else {
        node.kind = Kind::other;
        node.text = name_of(from.type());
    }
    return node;
}

// The items of an array whose '[' is taken, and its ']'.
void read_items(ArrayTokens& tokens, std::string_view name, TomlNode& array) {
    for (ArrayToken token = tokens.next(); token.kind != ArrayToken::Kind::close;
         token = tokens.next()) {
        const bool is_array = token.kind == ArrayToken::Kind::open;
        TomlNode& item = array.children.emplace_back();
        item.kind = is_array ? TomlNode::Kind::array : TomlNode::Kind::number;
        item.where = fmt::format("{}:{}", name, token.line);
        if (is_array) read_items(tokens, name, item);
        else item.text = token.text;
    }
}

void rename(TomlNode& node, const std::string& where) {
    node.where = where;
    for (TomlNode& child : node.children) rename(child, where);
}

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
    while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
    return text;
}

}  // namespace

const TomlNode* TomlNode::find(std::string_view child) const {
    for (const TomlNode& node : children)
        if (node.key == child) return &node;
    return nullptr;
}

TomlNode parse_toml(std::string_view text, const std::string& name, FirstError& error,
                    ArraysOfNumbers arrays) {
    const TomlOutline outline = outline_of(text, arrays == ArraysOfNumbers::stay_text);
    if (outline.stray_byte > 0) {
        error.report(fmt::format(
            "{}:{}: {}", name, outline.stray_byte,
            outline.after_backslash
                ? "a character that is not ASCII follows a backslash; write the text in one line"
                : "this is not valid TOML: a character that is not ASCII stands outside a text in "
                  "quotes and a comment; remove it"));
        return {.where = name};
    }
    const std::string_view parsed_text = outline.arrays.empty() ? text : outline.emptied;
    toml::parse_result parsed = toml::parse(parsed_text, name);
    if (parsed.failed()) {
        std::string what(parsed.error().description());
        std::replace(what.begin(), what.end(), '\n', ' ');
        error.report(fmt::format("{}:{}: this is not valid TOML: {}", name,
                                 parsed.error().source().begin.line, what));
        return {.where = name};
    }
    TomlNode root = convert(parsed.table(), Source(parsed_text, name, outline.arrays));
    root.where = name;
    for (TomlNode& child : root.children) {
        TomlNode room;
        if (!child.numbers.text.empty()) child = with_items(child, room);
    }
    return root;
}

const TomlNode& with_items(const TomlNode& array, TomlNode& room) {
    if (array.numbers.text.empty()) return array;
    const std::string_view name = std::string_view(array.where).substr(0, array.where.rfind(':'));
    ArrayTokens tokens(array.numbers.text, array.numbers.line);
    tokens.next();  // its '['
    room = {.kind = TomlNode::Kind::array, .where = array.where, .key = array.key};
    read_items(tokens, name, room);
    return room;
}

TomlNode parse_override(const std::string& key_and_value, FirstError& error) {
    const std::string where = "--set " + key_and_value;
    const std::size_t equals = key_and_value.find('=');
    const std::string_view whole = key_and_value;
    const std::string_view key = trimmed(whole.substr(0, equals));
    const std::string_view value =
        equals == whole.npos ? std::string_view{} : trimmed(whole.substr(equals + 1));
    TomlNode node{.kind = TomlNode::Kind::text};
    if (key.empty() || value.empty()) {
        error.report(where + ": write key=value, such as --set bias=64");
        return node;
    }
    node.text = value;
    const auto read = fixed::parse_decimal(value, 0, 64);
    const char first = value.front();
    if (first == '[' || first == '"' || first == '\'') {
        FirstError no_toml;
        TomlNode table = parse_toml(fmt::format("v = {}", value), where, no_toml);
        if (no_toml.any()) {
            error.report(where + ": the value is not valid TOML; write [x, y, z], a number or a "
                                 "name");
            return node;
        }
        node = std::move(table.children.front());
    } else if (read.status != fixed::DecimalStatus::bad_character) {
        node.kind = TomlNode::Kind::number;
    }
    rename(node, where);
    node.key = key;
    return node;
}

std::string describe(const TomlNode& node) {
    switch (node.kind) {
        case TomlNode::Kind::table: return "a table";
        case TomlNode::Kind::array: {
            TomlNode room;
            return fmt::format("an array of {}", with_items(node, room).children.size());
        }
        case TomlNode::Kind::text: return fmt::format("the text '{}'", node.text);
        case TomlNode::Kind::number: return fmt::format("the number {}", node.text);
        default: return node.text;
    }
}

}  // namespace umbra78::tools
