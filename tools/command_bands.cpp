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
    struct Options {
        int bias = 64;
        bool json = false;
    };
    const auto options = std::make_shared<Options>();
    command->add_option("--bias", options->bias, "Bias in quanta; figure 3 has 64")
        ->type_name("QUANTA")
        ->check(CLI::Range(0, 1 << 16))
        ->capture_default_str();
    command->add_flag("--json", options->json, "Print JSON instead of Markdown");
    command->footer("Example:\n  umbra78 bands --bias 32 > bands.md");
    command->callback([options] {
        const std::vector<BandRow> rows = study_bands(options->bias);
        fmt::print("{}", options->json ? print(to_json(rows)) : to_markdown(rows, options->bias));
    });
}

}  // namespace umbra78::tools
