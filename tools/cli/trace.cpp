// umbra78 trace: prints every word of one pixel's way through the post-process, with its cycle.
#include "tools/cli/command_line.hpp"
#include "tools/cli/commands.hpp"
#include "tools/cli/two_numbers.hpp"
#include "tools/render/report.hpp"
#include "tools/scene/scene_file.hpp"
#include "tools/scene/settings_text.hpp"
#include "tools/watch/pixel_trace.hpp"
#include "tools/watch/rival_trace.hpp"
#include "tools/watch/vcd.hpp"
#include "tools/watch/waterfall.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>

namespace umbra78::tools {
namespace {

struct TraceOptions {
    std::string scene, pixel, vcd;
    std::vector<std::string> set;
    std::uint64_t cycles = VcdOptions{}.cycles;
    bool json = false, waterfall = false;
};

Pixel pixel_of(const TraceOptions& options) {
    const auto [x, y] = *two_numbers(options.pixel, ',');
    return {x, y};
}

void run_rival(const TraceOptions& options, const RenderJob& job) {
    if (!options.vcd.empty() || options.waterfall)
        throw SceneError(std::string(shadow::method_of(job.inputs()).no_trace));
    const RivalTrace trace = trace_rival(job, pixel_of(options));
    if (options.json) {
        nlohmann::ordered_json json{{"scene", options.scene}};
        json.update(to_json(trace));
        json["settings"] = settings_json(job.settings());
        fmt::print("{}", print(json));
        return;
    }
    fmt::print("{}: pixel ({}, {}): {}\n\n{}", options.scene, trace.pixel.x, trace.pixel.y,
               trace.state, print(trace));
}

void run(const TraceOptions& options) {
    const LoadedScene scene = load_scene(options.scene, options.set);
    require_one_light(scene, "umbra78 trace");
    RenderJob job(scene.view(), scene.settings);
    if (shadow::is_rival(scene.settings.form)) return run_rival(options, job);
    job.render();
    const PixelTrace trace = trace_pixel(job, pixel_of(options));
    if (!options.vcd.empty()) {
        VcdOptions window;
        window.cycles = options.cycles;
        window.from = trace.first_cycle;
        write_vcd(options.vcd, job, window);
    }
    if (options.json) {
        nlohmann::ordered_json json{{"scene", options.scene}};
        json.update(to_json(trace));
        json["settings"] = settings_json(scene.settings);
        fmt::print("{}", print(json));
        return;
    }
    fmt::print("{}: pixel ({}, {}): {}\n\n{}", options.scene, trace.pixel.x, trace.pixel.y,
               summary(trace), to_text(trace.lines));
    if (!options.waterfall) return;
    WaterfallOptions window;
    window.from = trace.first_cycle;
    fmt::print("\n{}", waterfall(job, window));
}

}  // namespace

void add_trace_command(CLI::App& app, int&) {
    const auto options = std::make_shared<TraceOptions>();
    Command command(app, "trace",
                    "Print every word of one pixel's way through the post-process");
    command.scene(options->scene);
    command.text("--pixel", options->pixel, "X,Y", "The pixel, x,y from the upper left corner")
        .required()
        .checked(check_pixel);
    command.set(options->set);
    command.output("--vcd", options->vcd, ".vcd",
                   "Write the machine's signals as a value change dump, starting with the pixel's "
                   "first cycle");
    command.number("--cycles", options->cycles, "N", "Number of cycles in the --vcd file")
        .range(1, 1 << 20)
        .default_shown();
    const Argument waterfall = command.flag(
        "--waterfall", options->waterfall,
        "Also print which stage this pixel and the next five are in, cycle by cycle");
    command.json(options->json).excludes(waterfall);
    command.footer("Settings are those of umbra78 render --help.\n"
                   "\nOf a rival of the depth map (--set form=volumes) it prints the facet that is "
                   "seen, those\nbefore it, and the sides of shadow volumes between it and the "
                   "eye.\n"
                   "\nExample:\n  umbra78 trace tools/scenes/figures.toml --pixel 80,180 "
                   "--set lookup=nearest --set dither=none --set bias=64");
    command.runs([options] { run(*options); });
}

}  // namespace umbra78::tools
