// umbra78 pack: writes surfaces in the form that is read as it is drawn.
#include "tools/cli/command_line.hpp"
#include "tools/cli/commands.hpp"
#include "tools/io/text_formats.hpp"
#include "tools/scene/scene_file.hpp"
#include "tools/stream/hills.hpp"
#include "tools/stream/packed.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>
#include <stdexcept>

namespace umbra78::tools {
namespace {

struct PackOptions {
    std::string scene, out;
    std::vector<std::string> set;
    std::uint64_t hills = 0, layers = 1;
    bool json = false;
};

constexpr std::uint64_t max_hills = std::uint64_t{1} << 32;

std::uint64_t pack_hills(const PackOptions& options) {
    if (options.hills > max_hills || options.layers < 1 || options.layers > options.hills)
        throw std::runtime_error("--hills takes 1 to 2^32 patches, and --layers 1 to as many");
    Hills hills({.patches = options.hills, .layers = options.layers});
    PackedWriter writer(options.out, hills.materials(), hills.count());
    raster::Surfaces batch;
    hills.rewind();
    while (hills.next(batch) == Hills::Next::batch) writer.add(batch);
    writer.commit();
    return writer.written();
}

std::uint64_t pack_scene(const PackOptions& options) {
    // Places are packed as the file has them; the scene that reads them takes its own origin.
    std::vector<std::string> set = options.set;
    set.push_back("observer.recentre=\"off\"");
    const LoadedScene scene = load_scene(options.scene, set);
    if (!std::ranges::all_of(scene.materials, [](const raster::Material& m) {
            return m.diffuse.is_grey() && m.specular.is_grey();
        }))
        throw SceneError(fmt::format("{}: a coloured material cannot be packed, the form has grey "
                                     "levels; make it grey", options.scene));
    PackedWriter writer(options.out, scene.materials, scene.surfaces().count());
    writer.add(scene.surfaces());
    writer.commit();
    return writer.written();
}

void pack(const PackOptions& options) {
    const bool of_hills = options.hills > 0;
    if (of_hills && !options.scene.empty())
        throw std::runtime_error("give a scene or --hills, and not both");
    if (!of_hills && options.scene.empty())
        throw std::runtime_error("give a scene, or --hills N with N from 1 up");
    if (!of_hills && options.layers != 1)
        throw std::runtime_error("--layers is of --hills; give --hills N, or leave --layers out");
    const std::uint64_t written = of_hills ? pack_hills(options) : pack_scene(options);
    if (options.json)
        fmt::print("{}", print(nlohmann::ordered_json{{"file", options.out},
                                                      {"primitives", written}}));
    else
        fmt::print("{}: {} primitives\n", options.out, written);
}

}  // namespace

void add_pack_command(CLI::App& app, int&) {
    const auto options = std::make_shared<PackOptions>();
    Command command(app, "pack",
                    "Write surfaces in the packed form, which is read as it is drawn (.u78p)");
    command.input("scene", options->scene, "SCENE",
                  "The scene file whose surfaces are packed; its views and settings are not");
    command.output("--out", options->out, ".u78p", "The packed file")
        .required();
    command.number("--hills", options->hills, "N",
                   "In place of a scene: hills of N patches, on a square of 64 by 64 units");
    command.number("--layers", options->layers, "N",
                   "How many landscapes of hills lie below each other; they share the patches");
    command.set(options->set);
    command.json(options->json);
    command.footer(
        "Examples:\n"
        "  umbra78 pack tools/scenes/robot.toml --out robot.u78p\n"
        "  umbra78 pack --hills 1000000 --out - | umbra78 render tools/scenes/hills.toml");
    command.runs([options] { pack(*options); });
}

}  // namespace umbra78::tools
