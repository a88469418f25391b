// umbra78 cycles: prints where a frame's cycles go on a machine of the time, unit by unit.
#include "tools/cli/command_line.hpp"
#include "tools/cli/commands.hpp"
#include "tools/io/suggest.hpp"
#include "tools/paper/figure_costs.hpp"
#include "tools/render/ap120b_report.hpp"
#include "tools/render/cycle_report.hpp"
#include "tools/render/light_costs.hpp"
#include "tools/render/profile_costs.hpp"
#include "tools/render/memory_report.hpp"
#include "tools/render/report.hpp"
#include "tools/scene/scene_file.hpp"
#include "tools/scene/settings_text.hpp"
#include "tools/scene/toml_text.hpp"
#include "tools/watch/vcd.hpp"
#include "tools/watch/waterfall.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>

namespace umbra78::tools {
namespace {

using nlohmann::ordered_json;

struct CyclesOptions {
    std::string scene, profile, vcd;
    std::vector<std::string> set;
    bool all = false, json = false;
};

void print_claim(const CostClaim& claim) {
    fmt::print("the paper's \"roughly twice, plus a fixed transformation\": both views take {:.2f} "
               "times the observer's\nview, the transformation {:.3f} times; {:.2f} samples are "
               "drawn for each visible pixel\n",
               claim.both_views, claim.transformation, claim.depth_complexity);
}

// Only the fixed-point machine's post-process has a memory replay, a waterfall and a dump.
bool is_clocked(const LoadedScene& scene) {
    const shadow::Method* method = shadow::method_of(scene.settings);
    return method != nullptr && method->trace == shadow::Trace::clocked_post_process;
}

// The replay reads the texels about the pixel's own point, and of the observer its Z alone.
bool is_replayed(const LoadedScene& scene) {
    return is_clocked(scene) && scene.settings.receiver != shadow::Receiver::normal &&
           !shadow::reads_normals(scene.settings);
}

std::string timed_pixels(const LoadedScene& scene, const RenderJob& job) {
    if (scene.settings.receiver == shadow::Receiver::point) return waterfall(job);
    return fmt::format("The clocked machine has no stage for the receiver's plane or normal: no "
                       "pixel is timed{}. Give --set receiver=point.\n",
                       is_replayed(scene) ? "" : ", and no memory replayed");
}

void one_profile(const CyclesOptions& options, const LoadedScene& scene) {
    RenderJob job(scene.view(), scene.settings);
    job.render();
    if (!options.vcd.empty()) {
        require_one_light(scene, "--vcd");
        write_vcd(options.vcd, job);
    }
    const std::vector<shadow::FrameLedger> ledgers = job.ledgers();
    const shadow::FrameLedger& ledger = ledgers.front();
    const std::vector<LightCost> lights = light_costs(scene, ledgers);
    const int clock_ns = scene.settings.timing.clock_ns;
    if (options.json) {
        ordered_json json{{"scene", options.scene}, {"ledger", to_json(ledger, clock_ns)}};
        if (ledgers.size() > 1) {
            json["frame_cycles"] = shadow::total(ledgers, true);
            for (const LightCost& l : lights) json["lights"].push_back(to_json(l));
        }
        if (is_replayed(scene)) json["memory"] = to_json(job.replay_memory());
        json["settings"] = settings_json(scene.settings);
        fmt::print("{}", print(json));
        return;
    }
    if (ledgers.size() > 1)
        fmt::print("{}: {} ns a cycle, {} depth maps; {:.1f} ms in all. What follows the table is "
                   "of the first depth map alone.\n\n{}\n", options.scene, clock_ns,
                   ledgers.size(), simulated_ms(shadow::total(ledgers, true), clock_ns),
                   print(lights, clock_ns));
    fmt::print("{}: {} ns a cycle\n\n{}\n", options.scene, clock_ns,
               print_frame(ledger, clock_ns));
    if (ledger.has_map)
        fmt::print("{}\n", ledger.on_array
                               ? print(ledger.array, clock_ns)
                               : print_post_process(ledger.post_process, clock_ns));
    if (const hw::UnitCycles& once = ledger.scene.units; once.side_by_side() > 0)
        fmt::print("Once for the scene and the light, apart from the frame: {} cycles, {:.2f} ms.\n"
                   "\n", once.side_by_side(),
                   simulated_ms(once.side_by_side(), clock_ns));
    if (is_clocked(scene)) fmt::print("{}\n", timed_pixels(scene, job));
    if (is_replayed(scene)) fmt::print("{}\n", print_memory(job.replay_memory()));
    print_claim(cost_claim(ledger));
}

// The scene on a machine: --set comes after the profile, as it does for --profile alone.
LoadedScene scene_on(const std::string& profile, const CyclesOptions& options) {
    if (shadow::find_profile(profile) == nullptr) {
        std::vector<std::string_view> known;
        for (const shadow::Profile& each : shadow::profiles()) known.push_back(each.name);
        throw SceneError(fmt::format("--profile {}: there is no such profile; {}", profile,
                                     suggest(profile, known)));
    }
    std::vector<std::string> set = options.set;
    for (const std::string& each : options.set)
        if (parse_override(each).key == "profile")
            throw SceneError(fmt::format("--set {}: {} gives the machine, too; leave one out", each,
                                         options.all ? "--all" : "--profile"));
    set.insert(set.begin(), "profile=" + profile);
    return load_scene(options.scene, set);
}

void all_profiles(const CyclesOptions& options) {
    std::vector<ProfileCost> costs;
    for (const shadow::Profile& profile : shadow::profiles_of_1978()) {
        const std::string name(profile.name);
        const LoadedScene scene = scene_on(name, options);
        require_one_light(scene, "umbra78 cycles --all");
        costs.push_back(profile_cost(scene, name));
    }
    if (options.json) {
        ordered_json json{{"scene", options.scene}, {"profiles", to_json(costs)}};
        fmt::print("{}", print(json));
        return;
    }
    fmt::print("{}", profile_table(costs));
}

// Without a scene: the table the paper could have printed.
void all_figures(const CyclesOptions& options) {
    const auto figures = figure_costs();
    if (!options.json) {
        fmt::print("{}", figure_table(figures));
        return;
    }
    ordered_json json = ordered_json::array();
    for (std::size_t k = 0; k < figures.size(); ++k)
        json.push_back({{"figure", k + 1}, {"profiles", to_json(figures[k])}});
    fmt::print("{}", print(json));
}

void run(const CyclesOptions& options) {
    if (options.scene.empty()) {
        if (!options.profile.empty() || !options.vcd.empty() || !options.set.empty())
            throw SceneError("--profile, --vcd and --set need a scene; give its file");
        return all_figures(options);
    }
    if (options.all) return all_profiles(options);
    one_profile(options, options.profile.empty() ? load_scene(options.scene, options.set)
                                                 : scene_on(options.profile, options));
}

}  // namespace

void add_cycles_command(CLI::App& app, int&) {
    const auto options = std::make_shared<CyclesOptions>();
    Command command(app, "cycles", "Print where a frame's cycles go on a machine of the time");
    command.input("scene", options->scene, "FILE",
                  "Scene file (TOML); default: figures 1 to 6 on every profile");
    const Argument profile = command.text("--profile", options->profile, "PROFILE",
                                          "The machine; umbra78 settings lists them");
    const Argument all =
        command.flag("--all", options->all, "Print a row for each profile").excludes(profile);
    command.set(options->set);
    command
        .output("--vcd", options->vcd, ".vcd",
                "Write the machine's first cycles as a value change dump, for a waveform viewer "
                "such as GTKWave")
        .excludes(all);
    command.json(options->json);
    command.footer("Example:\n  umbra78 cycles tools/scenes/figures.toml --profile affine16x1");
    command.runs([options] { run(*options); });
}

}  // namespace umbra78::tools
