// umbra78 render: draws a scene file and writes its picture, its buffers, errors and costs.
#include "tools/cli/command_line.hpp"
#include "tools/cli/commands.hpp"
#include "tools/io/buffer_files.hpp"
#include "tools/render/error_map.hpp"
#include "tools/render/frame_warnings.hpp"
#include "tools/render/light_costs.hpp"
#include "tools/render/rendered.hpp"
#include "tools/scene/scene_file.hpp"
#include "tools/scene/settings_text.hpp"
#include "tools/scene/view_keys.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <memory>

namespace umbra78::tools {
namespace {

using nlohmann::ordered_json;

struct DrawOptions {
    std::string scene, out, buffers, error_map;
    std::vector<std::string> set;
    bool json = false, no_truth = false, spool = false;
    int threads = 1;
};

Path picture_path(const DrawOptions& options) {
    return options.out.empty() ? Path(options.scene).stem().concat(".png") : Path(options.out);
}

// Writes all files or, after an error, none.
void write_files(const DrawOptions& options, const Rendered& rendered) {
    FileSet files;
    if (!options.buffers.empty()) files.make_folder(options.buffers);  // the picture may be there
    const Buffer picture = rendered.job.buffer(Plane::picture);
    if (rendered.job.coloured())
        write_png_rgb(picture_path(options), picture.size_px, picture.size_px, rendered.job.rgb(),
                      &files);
    else
        write_png_gray(picture_path(options), picture.size_px, picture.size_px,
                       rendered.job.bytes(Plane::picture), &files);
    if (!options.error_map.empty())
        write_png_rgb(options.error_map, picture.size_px, picture.size_px, rendered.map, &files);
    if (!options.buffers.empty()) {
        const Path folder = options.buffers;
        for (const PlaneOf& plane : rendered.job.planes()) {
            const Buffer buffer = rendered.job.buffer(plane);
            write_pgm(folder / (buffer.name + ".pgm"), buffer, &files);
            write_npy(folder / (buffer.name + ".npy"), buffer, &files);
        }
    }
    files.commit();
}

ordered_json to_json(const DrawOptions& options, const Rendered& rendered) {
    ordered_json json{{"scene", options.scene}, {"picture", picture_path(options).string()}};
    json.update(tools::to_json(rendered));
    return json;
}

// Of a light with an area the first map and mask; its darkness is what they come to.
void print_planes(const Rendered& rendered) {
    const RenderJob& job = rendered.job;
    const shadow::Scene& scene = job.inputs().scene;
    const auto is_further = [&](const PlaneOf& of) {
        if (of.plane != Plane::light_z && of.plane != Plane::mask) return false;
        for (std::size_t s = 0; s < scene.sources_used(); ++s)
            if (scene.source(s).first_light == of.light) return false;
        return true;
    };
    std::size_t further = 0;
    const int width = job.coloured() ? 15 : 11;
    for (const PlaneOf& plane : job.planes()) {
        if (is_further(plane)) {
            ++further;
            continue;
        }
        const Buffer buffer = job.buffer(plane);
        fmt::print("{:<{}} {}\n", buffer.name, width, hash_of(buffer));
    }
    if (further > 0)
        fmt::print("            and {} more {}masks: see --json\n", further,
                   rendered.has_map() ? "maps and " : "");
}

void print_rows(const DrawOptions& options, const Rendered& rendered) {
    const RenderJob& job = rendered.job;
    const int size = rendered.scene.settings.machine.size_px();
    fmt::print("{}: {} x {} pixels, {} {}\n", picture_path(options).string(), size, size,
               rendered.patches + rendered.triangles, kinds_of_surfaces(rendered.scene));
    print_planes(rendered);
    const std::size_t lights = rendered.scene.lights.size();
    for (std::size_t l = 0; rendered.has_map() && l < lights; ++l)
        fmt::print("{:<11} {}\n", lights == 1 ? "bias" : "bias " + name_of_light(l, lights),
                   print(bias_report(job, l)));
    const std::vector<shadow::FrameLedger> ledgers = job.ledgers();
    const int clock_ns = rendered.scene.settings.timing.clock_ns;
    std::uint64_t transformations = 0;
    for (const shadow::FrameLedger& l : ledgers) transformations += l.transformation(true);
    fmt::print("machine     {:.1f} ms at {} ns a cycle, {:.1f} of them for the transformation{}; "
               "see umbra78 cycles\n",
               simulated_ms(shadow::total(ledgers, true), clock_ns), clock_ns,
               simulated_ms(transformations, clock_ns), ledgers.size() == 1 ? "" : "s");
    if (ledgers.size() > 1) fmt::print("{}", print(light_costs(rendered.scene, ledgers), clock_ns));
    const StageTimes& t = job.times();
    if (rendered.scene.stream)
        fmt::print("host        {:.1f} ms, the reading included, and {:.1f} MB of memory at most\n",
                   t.total_ms(), static_cast<double>(peak_bytes()) / 1e6);
    else
        fmt::print("host        {:.1f} ms: light {:.1f}, observer {:.1f}, shadow {:.1f}, filters "
                   "{:.1f}\n",
                   t.total_ms(), t.light_ms, t.observer_ms, t.post_process_ms, t.filters_ms);
    for (std::size_t l = 0; l < lights; ++l) {
        if (lights > 1) fmt::print("{}\n", name_of_light(l, lights));
        const bool compared = !rendered.errors.empty() && rendered.errors[l];
        if (compared)
            fmt::print("{}", print(*rendered.errors[l]));
        else
            fmt::print("error       n/a ({})\n", options.no_truth
                                                     ? "--no-truth"
                                                     : no_truth_because(rendered.scene));
        if (!rendered.on_ground.empty())
            fmt::print("{}", print_on_ground(rendered.on_ground[l]));
    }
    if (!options.error_map.empty())
        fmt::print("error map   {}: {}\n", options.error_map, error_map_legend);
}

void run(const DrawOptions& options) {
    if (options.out.empty()) check_output(picture_path(options), ".png", {});
    const Rendered rendered(load_streamed_scene(options.scene, options.set, options.spool),
                            {!options.no_truth, options.error_map, options.threads});
    print_warnings(rendered.warnings);
    write_files(options, rendered);
    if (options.json) {
        fmt::print("{}", print(to_json(options, rendered)));
    } else {
        print_rows(options, rendered);
    }
}

}  // namespace

void add_render_command(CLI::App& app, int&) {
    const auto options = std::make_shared<DrawOptions>();
    Command command(app, "render", "Render a scene file");
    command.scene(options->scene);
    command.output("--out", options->out, ".png",
                   "The picture; default: the scene's name with .png, in this folder");
    command.output_folder("--buffers", options->buffers,
                          "Folder for every stage's buffer, as PGM and NPY: Z of both views, "
                          "intensity, the mask before and after each filter, the picture");
    const Argument error_file = command.output(
        "--error", options->error_map, ".png",
        fmt::format("The error map, over the picture: {}", error_map_legend));
    command.set(options->set);
    command
        .flag("--no-truth", options->no_truth,
              "Do not compute the exact truth and the errors against it")
        .excludes(error_file);
    command.flag("--spool", options->spool,
                 "Copy a [stream] that cannot be read twice, such as a pipe, to a temporary file "
                 "in TMPDIR first");
    command.threads(options->threads);
    command.json(options->json);
    command.footer([] {
        return settings_help() +
               "\nExample:\n  umbra78 render tools/scenes/figures.toml --set lookup=nearest "
               "--set bias=64 --buffers out";
    });
    command.runs([options] { run(*options); });
}

}  // namespace umbra78::tools
