// umbra78 bands: the README's table on the paper's sentence about figure 3.
#include "tools/band_study.hpp"
#include "tools/commands.hpp"
#include "tools/report.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>

namespace umbra78::tools {

void add_bands_command(CLI::App& app, int&) {
    CLI::App* command = app.add_subcommand(
        "bands", "Print which reading of the paper's sentence about figure 3's error fits");
    command->footer("Example:\n  umbra78 bands > bands.md");
    const auto json = std::make_shared<bool>(false);
    command->add_flag("--json", *json, "Print JSON instead of Markdown");
    command->callback([json] {
        const std::vector<BandRow> rows = study_bands();
        fmt::print("{}", *json ? print(to_json(rows)) : to_markdown(rows));
    });
}

}  // namespace umbra78::tools
