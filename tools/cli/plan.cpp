// umbra78 plan: prints what a frame needs, what the plan leaves out, why, and the cycles saved.
#include "tools/cli/command_line.hpp"
#include "tools/cli/commands.hpp"
#include "tools/render/frame_warnings.hpp"
#include "tools/render/plan_report.hpp"
#include "tools/render/report.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>

namespace umbra78::tools {
namespace {

using nlohmann::ordered_json;
using shadow::Omission;
using shadow::FrameStage;

struct PlanOptions {
    std::string scene;
    std::vector<std::string> set;
    bool json = false;
};

template <class Visit>
void for_omissions(const Planned& planned, bool left_out, Visit visit) {
    for (std::size_t k = 0; k < shadow::omission_count; ++k) {
        bool first = true;
        for (const Decided& d : decided(planned, static_cast<Omission>(k))) {
            if (d.decision.left_out != left_out) continue;
            visit(d, first);
            first = false;
        }
    }
}

ordered_json to_json(const PlanOptions& options, const Planned& planned) {
    ordered_json json{{"scene", options.scene}};
    json.update(tools::to_json(planned));
    return json;
}

void print_stages(const Planned& planned) {
    fmt::print("{:<20}{:>12}{:>12}{:>12}{:>12}{:>14}{:>14}\n", "cycles of", "transform", "divide",
               "noise", "store", "operations", "in all");
    const shadow::FrameCycles cycles = planned.cycles();
    for (std::size_t k = 0; k < shadow::stage_count; ++k) {
        const shadow::StageCycles& c = cycles[k];
        if (static_cast<FrameStage>(k) == FrameStage::join && c.total() == 0) continue;
        fmt::print("{:<20}", name_of(static_cast<FrameStage>(k), !planned.on_ground()));
        for (const std::uint64_t n : {c.transform, c.divide, c.noise, c.store})
            fmt::print("{:>12}", n == 0 ? "-" : grouped(n));
        const std::uint64_t operations = c.operations.one_after_the_other();
        fmt::print("{:>14}", operations == 0 ? "-" : grouped(operations));
        fmt::print("{:>14}\n", c.total() == 0 ? "left out" : grouped(c.total()));
    }
}

void print_rows(const PlanOptions& options, const Planned& planned) {
    const int size = planned.scene.settings.machine.size_px();
    const shadow::OutsideSurfaces& outside = planned.plan().outside;
    const char* const light = planned.lights() == 1 ? "light's" : "first light's";
    const std::string of_light =
        !planned.on_ground() ? fmt::format("outside the {} view", light)
                          : fmt::format("with no {} shadow in the picture", light);
    fmt::print("{}: {} x {} pixels, {} of them visible; {} {}, {} {}, {} outside the observer's\n",
               options.scene, size, size, grouped(planned.ledger().visible),
               planned.scene.surfaces().count(), kinds_of_surfaces(planned.scene),
               outside.light[0], of_light, outside.observer);
    const shadow::FrameLines& lines = planned.ledger().lines;
    fmt::print("scan lines: {} with something visible, {} with a shadow, {} within the low-pass's "
               "reach of one\n\n",
               lines.visible, lines.filtered.dequantize, lines.filtered.composite);
    print_stages(planned);
    fmt::print("\n{:<30}{:>12}   {}\n", "left out", "cycles", "because");
    bool starred = false;
    for_omissions(planned, true, [&](const Decided& d, bool first) {
        const shadow::Saving s = planned.saving(d.omission);
        starred |= s.after_drawing;
        fmt::print("{:<29} {:>12}{}  {}\n", d.name(planned.on_ground()),
                   first ? grouped(s.cycles) : "\"", s.after_drawing ? "*" : " ",
                   explain(d.decision.reason));
    });
    fmt::print("\n{:<45}{}\n", "needed", "because");
    for_omissions(planned, false, [&](const Decided& d, bool) {
        fmt::print("{:<44} {}\n", d.name(planned.on_ground()), explain(d.decision.reason));
    });
    const std::uint64_t left = total(planned.cycles()), everything = planned.everything();
    const int ns = planned.scene.settings.timing.clock_ns;
    fmt::print("\nIn all {} unit cycles instead of {}; at {} ns a cycle, one unit after the other, "
               "this takes {:.1f} ms instead of {:.1f} ms.\n",
               grouped(left), grouped(everything), ns, simulated_ms(left, ns),
               simulated_ms(everything, ns));
    if (starred)
        fmt::print("*: this count is known only after drawing; which scan lines have a shadow "
                   "near, only after the test.\n");
}

void run(const PlanOptions& options) {
    const Planned planned(load_scene(options.scene, options.set));
    print_warnings(planned.warnings);
    if (options.json) {
        fmt::print("{}", print(to_json(options, planned)));
    } else {
        print_rows(options, planned);
    }
}

}  // namespace

void add_plan_command(CLI::App& app, int&) {
    const auto options = std::make_shared<PlanOptions>();
    Command command(app, "plan",
                    "Print what a frame needs, what is left out and why, and the cycles saved");
    command.scene(options->scene);
    command.set(options->set);
    command.json(options->json);
    command.footer("Settings are those of umbra78 render --help. The plan is that of a frame whose "
                   "depth maps nothing but\nthe shadow test reads, as in umbra78 animate; umbra78 "
                   "render shows them and so draws each.\n\nExample:\n"
                   "  umbra78 plan tools/scenes/figures.toml --set dither=none");
    command.runs([options] { run(*options); });
}

}  // namespace umbra78::tools
