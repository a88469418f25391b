// umbra78 bias: the least bias of a scene or of a depth map, what it costs, and how it is written
// for interfaces and engines.
#include "tools/bias/answer.hpp"
#include "tools/cli/command_line.hpp"
#include "tools/cli/commands.hpp"
#include "tools/io/text_formats.hpp"
#include "tools/render/frame_warnings.hpp"
#include "tools/scene/scene_error.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <charconv>
#include <cmath>
#include <memory>

namespace umbra78::tools {
namespace {

using bias::MapSetup;

struct BiasOptions {
    std::string scene;
    std::vector<std::string> set;
    int map_px = 0;
    std::string depth = "d16", filter = "nearest";
    std::string extent, range, slope, azimuth = "45", z = "0.75", pixel;
    bool reversed = false, json = false;

    bool names_map() const { return map_px > 0 || !extent.empty() || !range.empty(); }
};

std::optional<double> number_in(const std::string& text) {
    double value = 0;
    const char* const end = text.data() + text.size();
    const auto [at, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc() || at != end || !std::isfinite(value)) return {};
    return value;
}
std::string check_decimal(const std::string& text) {
    return number_in(text) ? "" : fmt::format("'{}' is not a number; write it as in 0.5", text);
}
std::string check_depth(const std::string& text) {
    return bias::depth_format(text) ? ""
                                    : fmt::format("'{}' is no depth format; give d16, d24 or d32f",
                                                  text);
}
std::string check_filter(const std::string& text) {
    return bias::filter(text) ? ""
                              : fmt::format("'{}' is no filter; give nearest, bilinear, pcf3 or "
                                            "pcf5", text);
}

double within(const char* option, const std::string& text, double low, double high) {
    const double value = *number_in(text);
    if (value >= low && value <= high) return value;
    throw SceneError(fmt::format("{} {}: its range is {:g} .. {:g}", option, text, low, high));
}

MapSetup setup_of(const BiasOptions& o) {
    if (o.map_px == 0 || o.extent.empty() || o.range.empty() || o.slope.empty())
        throw SceneError("a depth map is given by --map, --extent, --range and --slope; give all "
                         "four, or a scene");
    if (!o.set.empty()) throw SceneError("--set changes a scene's settings; give a scene");
    MapSetup s;
    s.map_px = o.map_px;
    s.extent = within("--extent", o.extent, 1e-6, 1e9);
    s.range = within("--range", o.range, 1e-6, 1e9);
    s.slope_deg = within("--slope", o.slope, 0, 89);
    s.azimuth_deg = within("--azimuth", o.azimuth, 0, 90);
    s.depth = within("--z", o.z, 0.001, 0.999);
    if (!o.pixel.empty()) s.pixel = within("--pixel", o.pixel, 1e-9, 1e9);
    s.format = *bias::depth_format(o.depth);
    s.filter = *bias::filter(o.filter);
    s.reversed = o.reversed;
    const double reached = 16 * s.texel() * (s.along_x() + s.along_y()) / s.range;
    if (reached >= std::min(s.depth, 1 - s.depth))
        throw SceneError(fmt::format("such a slope leaves the depth range within 16 texels of "
                                     "--z {:g}; give more --map, more --range or less --extent",
                                     s.depth));
    return s;
}

bias::Answer answer_of(const BiasOptions& options) {
    if (options.scene.empty()) return bias::answer(setup_of(options));
    if (options.names_map() || !options.slope.empty())
        throw SceneError("a scene has its own map; give a scene, or --map, --extent, --range and "
                         "--slope");
    const LoadedScene scene = load_scene(options.scene, options.set);
    print_warnings(scene.warnings);
    return bias::answer(scene);
}

void add_map_options(Command& command, BiasOptions& o) {
    command.number("--map", o.map_px, "TEXELS", "A side of the depth map").range(16, 65536);
    command.text("--extent", o.extent, "WORLD", "What the map shows from edge to edge")
        .checked(check_decimal);
    command.text("--range", o.range, "WORLD", "From its near plane to its far one")
        .checked(check_decimal);
    command.text("--slope", o.slope, "DEGREES",
                 "Between the light and the normal of the steepest surface that is to be free of "
                 "false shadow, 0 .. 89")
        .checked(check_decimal);
    command.text("--azimuth", o.azimuth, "DEGREES",
                 "Of the slope from an axis of the map; 45 is the worst")
        .checked(check_decimal)
        .default_shown();
    command.text("--depth", o.depth, "FORMAT", "d16, d24 or d32f")
        .checked(check_depth)
        .default_shown();
    command.flag("--reversed", o.reversed, "1 is near and 0 far");
    command.text("--filter", o.filter, "FILTER",
                 "nearest; bilinear, four comparisons averaged; pcf3, pcf5, a window of k x k")
        .checked(check_filter)
        .default_shown();
    command.text("--z", o.z, "DEPTH", "Of the surface, 0 near .. 1 far: decides a float's step")
        .checked(check_decimal)
        .default_shown();
    command.text("--pixel", o.pixel, "WORLD", "A pixel of the picture; default: a texel")
        .checked(check_decimal);
}

}  // namespace

void add_bias_command(CLI::App& app, int&) {
    const auto options = std::make_shared<BiasOptions>();
    Command command(app, "bias",
                    "Print the least bias of a scene or a depth map, in everyone's units");
    command.input("scene", options->scene, "FILE",
                  "Scene file (TOML), searched by the machine; or give a map by the options below");
    command.set(options->set);
    add_map_options(command, *options);
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
