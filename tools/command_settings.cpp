// umbra78 settings: the one table of settings, for the README and the manual.
#include "tools/commands.hpp"
#include "tools/report.hpp"
#include "tools/settings_text.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>

namespace umbra78::tools {

void add_settings_command(CLI::App& app, int&) {
    CLI::App* command = app.add_subcommand("settings", "Print the table of settings and profiles");
    command->footer("Example:\n  umbra78 settings > settings.md");
    const auto json = std::make_shared<bool>(false);
    command->add_flag("--json", *json, "Print JSON instead of Markdown");
    command->callback([json] {
        fmt::print("{}", *json ? print(settings_json()) : settings_markdown());
    });
}

}  // namespace umbra78::tools
