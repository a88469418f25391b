// umbra78 bands: prints which readings of the paper's sentence about figure 3 fit what is drawn.
#include "tools/cli/command_line.hpp"
#include "tools/cli/commands.hpp"
#include "tools/paper/bands.hpp"
#include "tools/render/report.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>

namespace umbra78::tools {

void add_bands_command(CLI::App& app, int&) {
    struct Options {
        int bias = 64;
        bool json = false;
    };
    const auto options = std::make_shared<Options>();
    Command command(app, "bands",
                    "Print which reading of the paper's sentence about figure 3's error fits");
    command.number("--bias", options->bias, "QUANTA", "The bias in quanta; figure 3 has 64")
        .range(0, 1 << 16)
        .default_shown();
    command.json(options->json, "Markdown");
    command.footer("Example:\n  umbra78 bands --bias 32 > bands.md");
    command.runs([options] {
        const std::vector<BandRow> rows = measure_bands(options->bias);
        fmt::print("{}", options->json ? print(to_json(rows)) : to_markdown(rows, options->bias));
    });
}

}  // namespace umbra78::tools
