// umbra78 render: draws a scene file and writes its picture, its buffers, errors and costs.
#include "tools/cli/command_line.hpp"
#include "tools/cli/commands.hpp"
#include "tools/io/buffer_files.hpp"
#include "tools/render/cycle_report.hpp"
#include "tools/render/error_map.hpp"
#include "tools/render/frame_warnings.hpp"
#include "tools/render/ground_pixels.hpp"
#include "tools/render/light_costs.hpp"
#include "tools/render/report.hpp"
#include "tools/render/stream_watch.hpp"
#include "tools/scene/scene_file.hpp"
#include "tools/scene/settings_text.hpp"
#include "tools/scene/view_keys.hpp"
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
    std::vector<std::optional<ShadowReport>> errors;  // by light; empty: none was asked for
    std::vector<ShadowReport> on_ground;  // by light, of its pixels alone; empty without a ground
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
        if (!options.no_truth)
            for (std::size_t l = 0; l < scene.lights.size(); ++l) compare(options, l);
        warnings = frame_warnings(scene, job, error());
    }

    // The first light's.
    std::optional<ShadowReport> error() const {
        return errors.empty() ? std::nullopt : errors.front();
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

    // The error map is the first light's.
    void compare(const Options& options, std::size_t light) {
        const std::optional<SceneTruth> truth =
            scene.stream ? std::nullopt : trace(scene, light);
        const bool wants_map = light == 0 && !options.error_map.empty();
        if (!truth && wants_map)
            throw SceneError(fmt::format("--error {}: {} has no exact truth: {}",
                                         options.error_map, options.scene,
                                         no_truth_because(scene)));
        errors.emplace_back();
        if (!truth) return;
        const std::vector<std::uint8_t> visible = job.visible();
        const Buffer depths = job.buffer(Plane::observer_z);
        errors.back() = report(*truth, {job.bytes({Plane::filtered, light}), visible},
                               widened(light_texel_band(*truth), *truth, scene.settings), &depths);
        if (scene.ground) {
            const std::vector<std::uint8_t> ground = ground_pixels(scene, job);
            on_ground.push_back(report(*truth, {job.bytes({Plane::filtered, light}), ground},
                                       widened(light_texel_band(*truth), *truth, scene.settings)));
        }
        if (wants_map) map = error_map(*truth, job);
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

// Where there is none, nothing is compared and there is no bias.
bool has_map(const RenderJob& job) { return shadow::map_layers(job.settings()) > 0; }

// Of a scene with several depth maps; "machine" is then of the first light alone.
ordered_json lights_json(const Rendered& rendered, std::span<const shadow::FrameLedger> ledgers) {
    const int clock_ns = rendered.scene.settings.timing.clock_ns;
    ordered_json rows = ordered_json::array();
    for (const LightCost& cost : light_costs(rendered.scene, ledgers)) {
        ordered_json& row = rows.emplace_back();
        row = tools::to_json(cost);
        if (has_map(rendered.job))
            row["bias"] = to_json(bias_report(rendered.job, cost.light));
        if (!rendered.errors.empty()) row["error"] = to_json(rendered.errors[cost.light]);
        if (!rendered.on_ground.empty())
            row["error_on_ground"] = to_json(std::optional(rendered.on_ground[cost.light]));
    }
    return {{"frame_cycles", shadow::total(ledgers, true)},
            {"frame_ms", simulated_ms(shadow::total(ledgers, true), clock_ns)},
            {"lights", rows}};
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
    for (const PlaneOf& plane : job.planes()) {
        const Buffer buffer = job.buffer(plane);
        json["hashes"][buffer.name] = hash_of(buffer);
    }
    json["error"] = to_json(rendered.error());
    if (!rendered.on_ground.empty())
        json["error_on_ground"] = to_json(std::optional(rendered.on_ground.front()));
    if (has_map(job)) json["bias"] = to_json(bias_report(job));
    const std::vector<shadow::FrameLedger> ledgers = job.ledgers();
    const int clock_ns = rendered.scene.settings.timing.clock_ns;
    json["machine"] = tools::to_json(ledgers.front(), clock_ns);
    if (rendered.scene.lights.size() > 1 || ledgers.size() > 1)
        json["lights"] = lights_json(rendered, ledgers);
    json["host_ms"] = to_json(job.times());
    json["settings"] = settings_json(rendered.scene.settings);
    json["warnings"] = tools::to_json(rendered.warnings);
    return json;
}

// Of a light with an area the first map and mask; its darkness is what they come to.
void print_planes(const RenderJob& job) {
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
                   has_map(job) ? "maps and " : "");
}

void print_rows(const Options& options, const Rendered& rendered) {
    const RenderJob& job = rendered.job;
    const int size = rendered.scene.settings.machine.size_px();
    fmt::print("{}: {} x {} pixels, {} {}\n", picture_path(options).string(), size, size,
               rendered.patches + rendered.triangles, kinds_of_surfaces(rendered.scene));
    print_planes(job);
    const std::size_t lights = rendered.scene.lights.size();
    for (std::size_t l = 0; has_map(job) && l < lights; ++l)
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
        fmt::format("The error map, over the picture: {}", error_map_legend));
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
