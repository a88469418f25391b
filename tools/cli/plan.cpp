// umbra78 plan: prints what a frame needs, what the plan leaves out, why, and the cycles saved.
#include "tools/cli/command_line.hpp"
#include "tools/cli/commands.hpp"
#include "tools/render/frame_warnings.hpp"
#include "tools/render/plan_text.hpp"
#include "tools/render/report.hpp"
#include "tools/scene/view_keys.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <memory>

namespace umbra78::tools {
namespace {

using nlohmann::ordered_json;
using shadow::Omission;
using shadow::FrameStage;

struct Options {
    std::string scene;
    std::vector<std::string> set;
    bool json = false;
};

// The frame is drawn, because some counts are known only afterwards.
struct Planned {
    LoadedScene scene;
    RenderJob job;
    std::vector<shadow::FrameLedger> ledgers;  // by light
    Warnings warnings;

    explicit Planned(const Options& options)
        : scene(load_scene(options.scene, options.set)),
          job(scene.view(), scene.settings, Maps::for_shadows_alone) {
        const std::string_view refusal = shadow::method_of(job.inputs()).no_plan_cost;
        if (!refusal.empty()) throw SceneError(std::string(refusal));
        job.render();
        ledgers = job.ledgers();
        warnings = frame_warnings(scene, job, {});
    }
    const shadow::FramePlan& plan() const { return job.plan(); }
    const shadow::FrameLedger& ledger() const { return ledgers.front(); }
    std::size_t lights() const { return ledgers.size(); }
    bool on_ground() const { return ledger().on_ground; }
    shadow::DrawnFrame drawn() const { return {job.inputs(), ledgers}; }
    shadow::Saving saving(Omission o) const { return shadow::saving(o, plan(), drawn()); }
    shadow::FrameCycles cycles() const { return cycles_of(plan(), drawn()); }
    std::uint64_t everything() const { return total(cycles_of(shadow::FramePlan{}, drawn())); }
};

// An omission and why, for all lights that have the same reason.
struct Decided {
    Omission omission;
    shadow::Decision decision;
    std::vector<std::string> lights{};  // empty: for the frame, or for each of its lights

    std::string name(bool on_ground) const {
        const std::string_view of = name_of(omission, !on_ground);
        return lights.empty() ? std::string(of)
                              : fmt::format("{}, {}", of, fmt::join(lights, " "));
    }
};

std::vector<Decided> decided(const Planned& planned, Omission o) {
    const shadow::Scene& scene = planned.job.inputs().scene;
    if (scope_of(o) == shadow::Scope::frame || planned.lights() == 1)
        return {{o, planned.plan().at(o)}};
    std::vector<Decided> all;
    for (std::size_t s = 0; s < scene.sources_used(); ++s) {
        const shadow::Source source = scene.source(s);
        const std::string name = name_of_light(s, scene.sources_used());
        for (std::size_t k = 0; k < (scope_of(o) == shadow::Scope::source ? 1 : source.lights);
             ++k) {
            const shadow::Decision d = planned.plan().at(o, source.first_light + k);
            auto group = std::ranges::find_if(all, [&](const Decided& g) {
                return g.decision.left_out == d.left_out && g.decision.reason == d.reason;
            });
            if (group == all.end()) group = all.insert(group, {o, d});
            if (group->lights.empty() || group->lights.back() != name)
                group->lights.push_back(name);
        }
    }
    if (all.size() == 1) all.front().lights.clear();  // each light's
    return all;
}

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

ordered_json to_json(const Options& options, const Planned& planned) {
    const shadow::OutsideSurfaces& outside = planned.plan().outside;
    ordered_json json{{"scene", options.scene},
                      {"size_px", planned.scene.settings.machine.size_px()},
                      {"patches", planned.scene.patches.size()},
                      {"triangles", planned.scene.facets.size()},
                      {"surfaces_outside_light", outside.light[0]},
                      {"surfaces_outside_observer", outside.observer},
                      {"visible_pixels", planned.ledger().visible},
                      {"visible_lines", planned.ledger().lines.visible},
                      {"shadow_lines", planned.ledger().lines.filtered.dequantize}};
    const shadow::FrameCycles cycles = planned.cycles();
    for (std::size_t k = 0; k < shadow::stage_count; ++k)
        json["stages"].push_back({{"stage", key_of(static_cast<FrameStage>(k))},
                                  {"cycles", cycles[k].total()},
                                  {"transform", cycles[k].transform},
                                  {"divide", cycles[k].divide},
                                  {"noise", cycles[k].noise},
                                  {"store", cycles[k].store},
                                  {"operations", cycles[k].operations.one_after_the_other()}});
    for (std::size_t k = 0; k < shadow::omission_count; ++k) {
        const auto o = static_cast<Omission>(k);
        const shadow::Saving s = planned.saving(o);
        bool first = true;
        for (const Decided& d : decided(planned, o)) {
            ordered_json& row = json["omissions"].emplace_back();
            row["omission"] = key_of(o);
            if (!d.lights.empty()) row["lights"] = d.lights;
            row["left_out"] = d.decision.left_out;
            row["why"] = explain(d.decision.reason);
            row["saved_cycles"] = first ? s.cycles : 0;  // of all lights, in the first row
            row["after_drawing"] = s.after_drawing;
            first = false;
        }
    }
    json["cycles"] = total(cycles);
    json["cycles_of_everything"] = planned.everything();
    json["saved_cycles"] = planned.everything() - total(cycles);
    json["cycle_ns"] = planned.scene.settings.timing.clock_ns;
    json["warnings"] = tools::to_json(planned.warnings);
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

void print_rows(const Options& options, const Planned& planned) {
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

void run(const Options& options) {
    const Planned planned(options);
    print_warnings(planned.warnings);
    if (options.json) {
        fmt::print("{}", print(to_json(options, planned)));
    } else {
        print_rows(options, planned);
    }
}

}  // namespace

void add_plan_command(CLI::App& app, int&) {
    const auto options = std::make_shared<Options>();
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
