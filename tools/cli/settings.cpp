// umbra78 settings: prints the table of settings and the profiles with their sources; with --scene
// the tables and keys of a scene file, too.
#include "tools/cli/command_line.hpp"
#include "tools/cli/commands.hpp"
#include "tools/render/report.hpp"
#include "tools/scene/key_reference.hpp"
#include "tools/scene/settings_text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>

namespace umbra78::tools {

void add_settings_command(CLI::App& app, int&) {
    Command command(app, "settings", "Print the table of settings and profiles");
    const auto json = std::make_shared<bool>(false), scene = std::make_shared<bool>(false);
    command.flag("--scene", *scene, "Print all tables and keys of a scene file");
    command.json(*json, "Markdown");
    command.footer("Example:\n  umbra78 settings > settings.md\n"
                   "  umbra78 settings --scene > tools/scenes/KEYS.md");
    command.runs([json, scene] {
        if (*json)
            fmt::print("{}", print(*scene ? scene_keys_json() : settings_json()));
        else
            fmt::print("{}", *scene ? scene_keys_markdown() : settings_markdown());
    });
}

}  // namespace umbra78::tools
