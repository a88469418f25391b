// umbra78 settings: prints the table of settings and the profiles with their sources.
#include "tools/cli/command_line.hpp"
#include "tools/cli/commands.hpp"
#include "tools/render/report.hpp"
#include "tools/scene/settings_text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>

namespace umbra78::tools {

void add_settings_command(CLI::App& app, int&) {
    Command command(app, "settings", "Print the table of settings and profiles");
    const auto json = std::make_shared<bool>(false);
    command.json(*json, "Markdown");
    command.footer("Example:\n  umbra78 settings > settings.md");
    command.runs([json] {
        fmt::print("{}", *json ? print(settings_json()) : settings_markdown());
    });
}

}  // namespace umbra78::tools
