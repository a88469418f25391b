// umbra78 render: draws a scene file and writes its picture, its buffers, errors and costs.
#include "tools/cli/command_line.hpp"
#include "tools/cli/commands.hpp"
#include "tools/render/cycle_report.hpp"
#include "tools/render/error_map.hpp"
#include "tools/render/frame_warnings.hpp"
#include "tools/render/report.hpp"
#include "tools/render/stream_watch.hpp"
#include "tools/scene/scene_file.hpp"
#include "tools/scene/settings_text.hpp"
#include "tools/truth/patch_truth.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sys/resource.h>

#include <filesystem>
#include <memory>

namespace umbra78::tools {
namespace {

using nlohmann::ordered_json;

struct Options {
    std::string scene, out, buffers, error_map;
    std::vector<std::string> set;
    bool json = false, no_truth = false, spool = false;
};

// Why a scene that is not of spheres and planes alone has none.
const char* no_truth_because(const LoadedScene& scene) {
    if (scene.stream) return "a stream: its primitives are not held";
    return traces_patches() ? "free patches: there is no memory for their triangles"
                            : "free patches: built without Embree; install libembree-dev and "
                              "build again";
}

struct Rendered {
    LoadedScene scene;
    RenderJob job;
    std::optional<ShadowReport> error;
    std::vector<std::uint8_t> map;  // the error map, if it is asked for
    Warnings warnings;
    std::uint64_t patches, triangles;

    explicit Rendered(const Options& options)
        : scene(load_streamed_scene(options.scene, options.set, options.spool)),
          job(scene.view(), scene.settings), patches(scene.patches.size()),
          triangles(scene.facets.size()) {
        if (scene.stream) {
            draw_stream();
        } else {
            job.render();
        }
        if (!options.no_truth) compare(options);
        warnings = frame_warnings(scene, job, error);
    }

private:
    void draw_stream() {
        StreamWatch watch(scene);
        job.render_stream(watch, *scene.stream);
        patches = watch.patches();
        triangles = watch.triangles();
        scene.sample = watch.sample();
        const Warnings found = warnings_of_stream(scene, watch.seen());
        scene.warnings.insert(scene.warnings.end(), found.begin(), found.end());
    }

    void compare(const Options& options) {
        const std::optional<SceneTruth> truth =
            scene.stream ? std::nullopt : trace(scene);
        if (!truth && !options.error_map.empty())
            throw SceneError(fmt::format("--error {}: {} has no exact truth: {}",
                                         options.error_map, options.scene,
                                         no_truth_because(scene)));
        if (!truth) return;
        const std::vector<std::uint8_t> visible = job.visible();
        const Buffer depths = job.buffer(Plane::observer_z);
        error = report(*truth, {job.bytes(Plane::filtered), visible},
                       widened(light_texel_band(*truth), *truth, scene.settings), &depths);
        if (!options.error_map.empty()) map = error_map(*truth, job);
    }
};

// The most memory that the program has had so far.
std::uint64_t peak_bytes() {
    struct rusage used {};
    ::getrusage(RUSAGE_SELF, &used);
    return static_cast<std::uint64_t>(used.ru_maxrss) * 1024;
}

Path picture_path(const Options& options) {
    return options.out.empty() ? Path(options.scene).stem().concat(".png") : Path(options.out);
}

// Writes all files or, after an error, none.
void write_files(const Options& options, const Rendered& rendered) {
    FileSet files;
    if (!options.buffers.empty()) files.make_folder(options.buffers);  // the picture may be there
    const Buffer picture = rendered.job.buffer(Plane::picture);
    write_png_gray(picture_path(options), picture.size_px, picture.size_px,
                   rendered.job.bytes(Plane::picture), &files);
    if (!options.error_map.empty())
        write_png_rgb(options.error_map, picture.size_px, picture.size_px, rendered.map, &files);
    if (!options.buffers.empty()) {
        const Path folder = options.buffers;
        for (const Plane plane : all_planes) {
            const Buffer buffer = rendered.job.buffer(plane);
            write_pgm(folder / (buffer.name + ".pgm"), buffer, &files);
            write_npy(folder / (buffer.name + ".npy"), buffer, &files);
        }
    }
    files.commit();
}

ordered_json to_json(const Options& options, const Rendered& rendered) {
    const RenderJob& job = rendered.job;
    ordered_json json{{"scene", options.scene},
                      {"picture", picture_path(options).string()},
                      {"size_px", rendered.scene.settings.machine.size_px()},
                      {"patches", rendered.patches},
                      {"triangles", rendered.triangles},
                      {"frame_bytes", job.frame_bytes()},
                      {"peak_bytes", peak_bytes()}};
    if (rendered.scene.stream)
        json["stream_hash"] = fmt::format("{:016x}", rendered.scene.stream->hash());
    for (const Plane plane : all_planes)
        json["hashes"][name_of(plane)] = hash_of(job.buffer(plane));
    json["error"] = to_json(rendered.error);
    json["bias"] = to_json(bias_report(rendered.scene.light, job));
    json["machine"] = tools::to_json(job.ledger(), rendered.scene.settings.timing.clock_ns);
    json["host_ms"] = to_json(job.times());
    json["settings"] = settings_json(rendered.scene.settings);
    json["warnings"] = tools::to_json(rendered.warnings);
    return json;
}

void print_rows(const Options& options, const Rendered& rendered) {
    const RenderJob& job = rendered.job;
    const int size = rendered.scene.settings.machine.size_px();
    fmt::print("{}: {} x {} pixels, {} {}\n", picture_path(options).string(), size, size,
               rendered.patches + rendered.triangles, kinds_of_surfaces(rendered.scene));
    for (const Plane plane : all_planes)
        fmt::print("{:<11} {}\n", name_of(plane), hash_of(job.buffer(plane)));
    fmt::print("bias        {}\n", print(bias_report(rendered.scene.light, job)));
    const shadow::FrameLedger ledger = job.ledger();
    const int clock_ns = rendered.scene.settings.timing.clock_ns;
    fmt::print("machine     {:.1f} ms at {} ns a cycle, {:.1f} of them for the transformation; see "
               "umbra78 cycles\n",
               simulated_ms(ledger.total(true), clock_ns), clock_ns,
               simulated_ms(ledger.transformation(true), clock_ns));
    const StageTimes& t = job.times();
    if (rendered.scene.stream)
        fmt::print("host        {:.1f} ms, the reading included, and {:.1f} MB of memory at most\n",
                   t.total_ms(), static_cast<double>(peak_bytes()) / 1e6);
    else
        fmt::print("host        {:.1f} ms: light {:.1f}, observer {:.1f}, shadow {:.1f}, filters "
                   "{:.1f}\n",
                   t.total_ms(), t.light_ms, t.observer_ms, t.post_process_ms, t.filters_ms);
    if (rendered.error) {
        fmt::print("{}", print(*rendered.error));
    } else {
        fmt::print("error       n/a ({})\n",
                   options.no_truth ? "--no-truth" : no_truth_because(rendered.scene));
    }
    if (!options.error_map.empty())
        fmt::print("error map   {}: {}\n", options.error_map, error_map_legend);
}

void run(const Options& options) {
    if (options.out.empty()) check_output(picture_path(options), ".png", {});
    const Rendered rendered(options);
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
    const auto options = std::make_shared<Options>();
    Command command(app, "render", "Render a scene file");
    command.scene(options->scene);
    command.output("--out", options->out, ".png",
                   "The picture; default: the scene's name with .png, in this folder");
    command.output_folder("--buffers", options->buffers,
                          "Folder for every stage's buffer, as PGM and NPY: Z of both views, "
                          "intensity, the mask before and after each filter, the picture");
    const Argument error_file = command.output(
        "--error", options->error_map, ".png",
        std::string("The error map, over the picture: ") + error_map_legend);
    command.set(options->set);
    command
        .flag("--no-truth", options->no_truth,
              "Do not compute the exact truth and the errors against it")
        .excludes(error_file);
    command.flag("--spool", options->spool,
                 "Copy a [stream] that cannot be read twice, such as a pipe, to a temporary file "
                 "in TMPDIR first");
    command.json(options->json);
    command.footer([] {
        return settings_help() +
               "\nExample:\n  umbra78 render tools/scenes/figures.toml --set lookup=nearest "
               "--set bias=64 --buffers out";
    });
    command.runs([options] { run(*options); });
}

}  // namespace umbra78::tools
