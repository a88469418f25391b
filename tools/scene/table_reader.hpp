// A table of a scene file, read key by key: exact words, or one line that says what is wrong.
#pragma once

#include "raster/scene.hpp"
#include "tools/scene/toml_text.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace umbra78::tools {

// A number as a word of `fraction` fraction bits, rounded half to even. With no fraction bits
// only whole numbers are taken.
struct NumberRange {
    int fraction;
    std::int64_t min, max;  // words
};

// "-2.5 .. 40", "2^-16 .. 32767": the range in numbers.
std::string print(const NumberRange&);

// The words of lengths and places in the world, Q15.16. `called` is the value's name in an error.
inline constexpr std::int64_t world_one = std::int64_t{1} << raster::world_fraction;
inline constexpr std::int64_t world_reach = 32767 * world_one;
inline constexpr NumberRange place_range{raster::world_fraction, -world_reach, world_reach};
inline constexpr NumberRange length_range{raster::world_fraction, 1, world_reach};

std::int64_t read_number(const TomlNode&, const std::string& called, const NumberRange&);
raster::World read_point(const TomlNode&, const std::string& called);
// The number of the name among `names`.
int read_choice(const TomlNode&, const std::string& called,
                std::span<const std::string_view> names);
std::string read_text(const TomlNode&, const std::string& called);

class TableReader {
public:
    using Keys = std::span<const std::string_view>;

    // Throws for a key that is not among `keys`. `title` is "[light]" or "[[sphere]]".
    TableReader(const TomlNode& table, std::string title, Keys keys);

    const TomlNode* find(std::string_view key) const { return table_.find(key); }
    const TomlNode& need(std::string_view key, std::string_view example) const;
    std::string called(std::string_view key) const;  // "'radius' in [[sphere]]"
    const TomlNode& table() const { return table_; }
    const std::string& title() const { return title_; }

    std::int64_t number(std::string_view key, const NumberRange&, std::int64_t otherwise) const;
    int choice(std::string_view key, Keys names, int otherwise) const;

private:
    const TomlNode& table_;
    std::string title_;
};

[[noreturn]] void fail(const TomlNode& where, const std::string& what);

}  // namespace umbra78::tools
