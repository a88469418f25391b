// The tables and keys of a scene file: the one place where a key's type, unit, range, default and
// meaning are written. The reader takes them from here, and tools/scenes/KEYS.md is printed from
// here. The keys of [settings] are those of shadow::settings_table().
#pragma once

#include "raster/scene.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace umbra78::tools {

// A number as a word of `fraction` fraction bits, rounded half to even. With no fraction bits
// only whole numbers are taken.
struct NumberRange {
    int fraction;
    std::int64_t min, max;  // words
};

// The words of lengths and places in the world are Q15.16, those of angles Q15.16 degrees.
inline constexpr std::int64_t world_one = std::int64_t{1} << raster::world_fraction;
inline constexpr std::int64_t world_reach = 32767 * world_one;
inline constexpr NumberRange place_range{raster::world_fraction, -world_reach, world_reach};
inline constexpr NumberRange length_range{raster::world_fraction, 1, world_reach};
inline constexpr NumberRange azimuth_range{16, -360 * world_one, 360 * world_one};

// "-2.5 .. 40", "2^-16 .. 32767": the range in numbers.
std::string print(const NumberRange&);

enum class KeyKind : std::uint8_t {
    number,
    point,    // [x, y, z], each in the range
    levels,   // a number, or [red, green, blue]
    choice,   // one of `choices`
    text,
    control,  // 16 points, or 4 rows of 4
};

struct SceneKey {
    std::string_view key;
    KeyKind kind;
    std::string_view unit{};
    NumberRange range{};                         // of a number, or of a point's coordinates
    const NumberRange* perspective = nullptr;    // the range in a perspective view, if another
    std::span<const std::string_view> choices{};
    // What a key that is left out is: in words, or, where they are empty, the word `fallback`.
    std::string_view left_out{};
    std::int64_t fallback = 0;
    std::string_view example{};  // of a key that is needed, at least sometimes
    std::string_view meaning;
};

struct SceneTable {
    std::string_view name;
    bool many;  // an array of tables, [[name]]; of `light` one may be written [light]
    std::string_view meaning;
    std::span<const SceneKey> keys;
};

// [observer], [light], [[material]], and the surfaces, [[sphere]] the first and [stream] the last.
std::span<const SceneTable> scene_tables();

// The names of all tables, `settings` the last.
std::span<const std::string_view> scene_table_names();

// One of them. Traps for a name that is not a table's, or not a key's.
const SceneTable& scene_table(std::string_view name);
const SceneKey& scene_key(const SceneTable&, std::string_view key);

std::string title_of(const SceneTable&);        // "[light]", "[[sphere]]"
std::string print_range(const SceneKey&);       // "-90 .. 90", "directional, point"
std::string print_fallback(const SceneKey&);    // "0", "fitted to the scene"

}  // namespace umbra78::tools
