#include "tools/scene/key_reference.hpp"

#include "tools/io/text_formats.hpp"
#include "tools/scene/scene_keys.hpp"
#include "tools/scene/settings_text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <vector>

namespace umbra78::tools {

using nlohmann::ordered_json;

std::string scene_keys_markdown() {
    std::string text =
        "# Keys of a scene file\n\n"
        "This page is printed by `umbra78 settings --scene`, from the tables by which scene files\n"
        "are read. A scene file is TOML; see `figures.toml`, `lamp.toml`, `solids.toml` and\n"
        "`teapot.toml`. The world is x right, y up, z toward an observer at azimuth 0. Numbers\n"
        "are decimals and are read exactly; lengths and angles are rounded to multiples of\n"
        "2^-16, half to even. The middle of the scene is the middle of the box that holds the\n"
        "control points of all surfaces, rounded down to a multiple of 2^-16.\n";
    for (const SceneTable& table : scene_tables()) {
        std::vector<std::vector<std::string>> rows{{"key", "unit", "range", "default", "meaning"}};
        for (const SceneKey& key : table.keys)
            rows.push_back({fmt::format("`{}`", key.key), std::string(key.unit), print_range(key),
                            print_fallback(key), std::string(key.meaning)});
        text += fmt::format("\n## {}\n\n{}{}\n\n{}", title_of(table), table.meaning,
                            table.many ? " There may be any number of them." : "",
                            markdown_table(rows));
    }
    return text + "\n## [settings]\n\nThe machine and what is done to the mask.\n\n"
           "A profile is a whole machine: it sets its keys, and every key that any other profile\n"
           "sets to its default, so that a profile replaces another. The order is: the defaults,\n"
           "the profile of [settings], the other keys of [settings], a profile of --set (or of\n"
           "--profile, --all, --vary), the other keys of --set. What comes later replaces what\n"
           "came before; of a key that --set gives twice, the last value counts.\n\n" +
           settings_markdown();
}

ordered_json scene_keys_json() {
    ordered_json json = ordered_json::array();
    for (const SceneTable& table : scene_tables()) {
        ordered_json keys = ordered_json::array();
        for (const SceneKey& key : table.keys)
            keys.push_back({{"key", key.key},
                            {"unit", key.unit},
                            {"range", print_range(key)},
                            {"default", print_fallback(key)},
                            {"meaning", key.meaning}});
        json.push_back({{"table", table.name},
                        {"many", table.many},
                        {"meaning", table.meaning},
                        {"keys", keys}});
    }
    ordered_json settings = settings_json();
    return {{"tables", json},
            {"settings", settings["settings"]},
            {"profiles", settings["profiles"]}};
}

}  // namespace umbra78::tools
