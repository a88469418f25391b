// umbra78 bias: the least bias of a scene or of a depth map, what it costs, and how it is written
// for interfaces and engines.
#include "tools/bias/answer.hpp"
#include "tools/bias/map_options.hpp"
#include "tools/cli/command_line.hpp"
#include "tools/cli/commands.hpp"
#include "tools/io/text_formats.hpp"
#include "tools/render/frame_warnings.hpp"
#include "tools/scene/scene_error.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>

namespace umbra78::tools {
namespace {

struct BiasOptions {
    std::string scene;
    std::vector<std::string> set;
    bias::MapOptions map;
    bool json = false;
};

bias::Answer answer_of(const BiasOptions& options) {
    if (options.scene.empty() && !options.set.empty())
        throw SceneError("--set changes a scene's settings; give a scene");
    if (options.scene.empty()) return bias::answer(bias::setup_of(options.map));
    if (options.map != bias::MapOptions{})
        throw SceneError("a scene has its own map; give a scene and --set, or the map's options");
    const LoadedScene scene = load_scene(options.scene, options.set);
    print_warnings(scene.warnings);
    return bias::answer(scene);
}

void add_map_options(Command& command, bias::MapOptions& o) {
    command.number("--map", o.map_px, "TEXELS", "A side of the depth map").range(16, 65536);
    command.text("--extent", o.extent, "WORLD", "What the map shows from edge to edge")
        .checked(bias::check_decimal);
    command.text("--range", o.range, "WORLD", "From its near plane to its far one")
        .checked(bias::check_decimal);
    command.text("--slope", o.slope, "DEGREES",
                 "Between the light and the normal of the steepest surface that is to be free of "
                 "false shadow, 0 .. 89")
        .checked(bias::check_decimal);
    command.text("--azimuth", o.azimuth, "DEGREES",
                 "Of the slope from an axis of the map; 45 is the worst")
        .checked(bias::check_decimal)
        .default_shown();
    command.text("--depth", o.depth, "FORMAT", "d16, d24 or d32f")
        .checked(bias::check_depth)
        .default_shown();
    command.flag("--reversed", o.reversed, "1 is near and 0 far");
    command.text("--filter", o.filter, "FILTER",
                 "nearest; bilinear, four comparisons averaged; pcf3, pcf5, a window of k x k")
        .checked(bias::check_filter)
        .default_shown();
    command.text("--z", o.z, "DEPTH", "Of the surface, 0 near .. 1 far: decides a float's step")
        .checked(bias::check_decimal)
        .default_shown();
    command.text("--pixel", o.pixel, "WORLD", "A pixel of the picture; default: a texel")
        .checked(bias::check_decimal);
}

}  // namespace

void add_bias_command(CLI::App& app, int&) {
    const auto options = std::make_shared<BiasOptions>();
    Command command(app, "bias",
                    "Print the least bias of a scene or a depth map, in everyone's units");
    command.input("scene", options->scene, "FILE",
                  "Scene file (TOML), searched by the machine; or give a map by the options below");
    command.set(options->set);
    add_map_options(command, options->map);
    command.json(options->json);
    command.footer("Example:\n  umbra78 bias tools/scenes/figures.toml --set lookup=nearest\n"
                   "  umbra78 bias --map 2048 --extent 20 --range 50 --depth d16 --filter pcf3 "
                   "--slope 60");
    command.runs([options] {
        const bias::Answer answer = answer_of(*options);
        fmt::print("{}", options->json ? tools::print(bias::to_json(answer))
                                       : bias::print(answer));
    });
}

}  // namespace umbra78::tools
