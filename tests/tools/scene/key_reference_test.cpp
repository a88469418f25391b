// The one table of scene keys: the reader reads every row of it, in its range and with its default,
// and the committed reference is what is printed from it.
#include "tools/scene/key_reference.hpp"

#include "fixed/decimal.hpp"
#include "tests/support/paths.hpp"
#include "tools/scene/scene.hpp"
#include "tools/scene/scene_keys.hpp"
#include "tools/scene/table_reader.hpp"
#include "tools/stream/hills.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <array>
#include <fstream>
#include <iterator>

namespace umbra78::tools {
namespace {

// A scene that is right, with all needed keys but those of `table`.
std::string others_than(std::string_view table) {
    return table == "light" ? "" : "[light]\nazimuth = 0\n";
}

std::string error_of_reading(const std::string& text) {
    const auto streams = [](const std::string&) {
        return OpenedStream{std::make_unique<Hills>(HillsShape{.patches = 1, .side = 2}), ""};
    };
    return read_scene(text, "a.toml", {}, {}, streams).error;
}

// The text of a table with all its needed keys, `key` given as `value` and written last.
std::string table_text(const SceneTable& table, std::string_view key, const std::string& value) {
    const bool perspective = key == "distance" || key == "position";
    std::string text = title_of(table) + "\n";
    if (perspective)
        text += table.name == "light" ? "kind = \"point\"\n" : "projection = \"perspective\"\n";
    for (const SceneKey& row : table.keys) {
        const bool wanted = !row.example.empty() && row.key != key &&
                            (row.key == "azimuth" ? !perspective : row.left_out == "must be given");
        const std::string flat = "[0, 0, 0], [1, 0, 0], [2, 0, 0], [3, 0, 0], ";
        if (wanted && row.kind == KeyKind::control)
            text += fmt::format("{} = [{}{}{}{}]\n", row.key, flat, flat, flat, flat);
        else if (wanted)
            text += fmt::format("{} = {}\n", row.key, row.example);
    }
    return text + fmt::format("{} = {}\n", key, value) + others_than(table.name);
}

// A row that the reader forgot would take anything.
TEST(SceneKeys, EveryRowIsRead) {
    int rows = 0;
    for (const SceneTable& table : scene_tables()) {
        for (const SceneKey& key : table.keys) {
            const std::string error = error_of_reading(table_text(table, key.key, "true"));
            EXPECT_NE(error.find(fmt::format("'{}' in {}", key.key, title_of(table))), error.npos)
                << error;
            ++rows;
        }
    }
    EXPECT_EQ(rows, 72);
}

std::string decimal(std::int64_t word, int fraction) {
    std::array<char, fixed::longest_decimal> text;
    const int length = fixed::print_decimal(word, fraction, text);
    return {text.data(), static_cast<std::size_t>(length)};
}

std::string whole(std::int64_t word, int) { return std::to_string(word); }

// Both ends of every range are taken, and one word beyond either is not.
TEST(SceneKeys, EveryNumberIsHeldToItsRange) {
    int ranges = 0;
    for (const SceneTable& table : scene_tables()) {
        for (const SceneKey& key : table.keys) {
            if (key.kind != KeyKind::number) continue;
            for (const bool perspective : {false, true}) {
                const NumberRange& range =
                    perspective && key.perspective ? *key.perspective : key.range;
                const auto text = range.fraction == 0 ? whole : decimal;
                const auto read = [&](std::int64_t word, FirstError& error) {
                    const std::string line =
                        fmt::format("{} = {}", key.key, text(word, range.fraction));
                    const TomlNode node = parse_toml(line, "a.toml", error);
                    return TableReader(node, table, error).number(key.key, -1, perspective);
                };
                for (const std::int64_t word : {range.min, range.max}) {
                    FirstError error;
                    EXPECT_EQ(read(word, error), word) << key.key;
                    EXPECT_EQ(error.line(), "");
                }
                for (const std::int64_t word : {range.min - 1, range.max + 1}) {
                    FirstError error;
                    read(word, error);
                    EXPECT_NE(error.line().find("its range is " + print(range)),
                              std::string::npos)
                        << key.key << ": " << error.line();
                }
                ++ranges;
            }
        }
    }
    EXPECT_EQ(ranges, 2 * 26);
}

TEST(SceneKeys, ADefaultIsWhatAKeyLeftOutIs) {
    const SceneResult scene = read_scene("[[material]]\nname = \"a\"\n[light]\nazimuth = 0\n"
                                         "[[sphere]]\ncentre = [0, 0, 0]\nradius = 1\n",
                                         "a.toml", {});
    ASSERT_TRUE(scene.ok()) << scene.error;
    const raster::Material& a = scene.scene.materials.at(0);
    const auto fallback = [](const char* table, const char* key) {
        return print_fallback(scene_key(scene_table(table), key));
    };
    EXPECT_EQ(fallback("material", "diffuse"), std::to_string(a.diffuse[0]));
    EXPECT_EQ(fallback("material", "specular"), std::to_string(a.specular[0]));
    EXPECT_EQ(fallback("material", "shininess"), std::to_string(a.shininess));
    EXPECT_EQ(fallback("observer", "projection"), "orthographic");
    EXPECT_EQ(scene.scene.observer.projection, raster::Projection::orthographic);
    EXPECT_EQ(fallback("observer", "azimuth"), "0");
    EXPECT_EQ(fallback("observer", "elevation"), "0");
    EXPECT_EQ(scene.scene.observer.axes.back, raster::axes_from_angles(0, 0).back);
    EXPECT_EQ(fallback("light", "kind"), "directional");
    EXPECT_EQ(fallback("light", "elevation"), "0");
    EXPECT_EQ(scene.scene.light().axes.back, raster::axes_from_angles(0, 0).back);
}

// "0 is on the z axis, 90 on the x axis", as the table says of an azimuth.
TEST(SceneKeys, AnAzimuthTurnsFromZToX) {
    EXPECT_EQ(raster::axes_from_angles(0, 0).back, (raster::Axis{0, 0, 1 << 30}));
    EXPECT_EQ(raster::axes_from_angles(90 * 65536, 0).back, (raster::Axis{1 << 30, 0, 0}));
}

TEST(SceneKeys, TheCommittedReferenceIsWhatIsPrinted) {
    std::ifstream file(UMBRA78_SOURCE_DIR "/tools/scenes/KEYS.md");
    const std::string committed{std::istreambuf_iterator<char>(file), {}};
    EXPECT_EQ(committed, scene_keys_markdown())
        << "print it anew: umbra78 settings --scene > tools/scenes/KEYS.md";
}

TEST(SceneKeys, JsonHoldsEveryRow) {
    const nlohmann::ordered_json json = scene_keys_json();
    ASSERT_EQ(json["tables"].size(), scene_tables().size());
    for (std::size_t t = 0; t < scene_tables().size(); ++t)
        EXPECT_EQ(json["tables"][t]["keys"].size(), scene_tables()[t].keys.size());
    EXPECT_EQ(json["settings"].size(), shadow::settings_table().size());
}

// Only the first of several errors is reported, and nothing is thrown for it.
TEST(ReadScene, ReportsTheFirstErrorOfSeveral) {
    EXPECT_EQ(error_of_reading("[[sphere]]\ncentre = [0, 0]\nradius = 0\nmaterial = 3\n"
                               "[[plane]]\n[light]\nazimuth = 400\n[settings]\nxy_bits = 99\n"),
              "a.toml:2: 'centre' in [[sphere]] is an array of 2; write [x, y, z]");
    EXPECT_EQ(error_of_reading("[[sphere]]\ncentre = [0, 0, 0]\nradius = 1\n"
                               "[light]\nazimuth = 400\nextent = 0\n[settings]\nxy_bits = 99\n"),
              "a.toml:5: 'azimuth' in [light] is 400; its range is -360 .. 360");
    const std::string set[] = {"bias", "lamp.azimuth=3", "light.azimuth=500"};
    EXPECT_EQ(read_scene("[light]\nazimuth = 1\n", "a.toml", set).error,
              "--set bias: write key=value, such as --set bias=64");
}

}  // namespace
}  // namespace umbra78::tools
