#include "tools/render/rendered.hpp"

#include "tools/render/cycle_report.hpp"
#include "tools/render/error_map.hpp"
#include "tools/render/frame_warnings.hpp"
#include "tools/render/ground_pixels.hpp"
#include "tools/render/light_costs.hpp"
#include "tools/render/stream_watch.hpp"
#include "tools/scene/settings_text.hpp"
#include "tools/truth/patch_truth.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sys/resource.h>

#include <utility>

namespace umbra78::tools {
namespace {

using nlohmann::ordered_json;

// Of a scene with several depth maps; "machine" is then of the first light alone.
ordered_json lights_json(const Rendered& rendered, std::span<const shadow::FrameLedger> ledgers) {
    const int clock_ns = rendered.scene.settings.timing.clock_ns;
    ordered_json rows = ordered_json::array();
    for (const LightCost& cost : light_costs(rendered.scene, ledgers)) {
        ordered_json& row = rows.emplace_back();
        row = tools::to_json(cost);
        if (rendered.has_map())
            row["bias"] = to_json(bias_report(rendered.job, cost.light));
        if (!rendered.errors.empty()) row["error"] = to_json(rendered.errors[cost.light]);
        if (!rendered.on_ground.empty())
            row["error_on_ground"] = to_json(std::optional(rendered.on_ground[cost.light]));
    }
    return {{"frame_cycles", shadow::total(ledgers, true)},
            {"frame_ms", simulated_ms(shadow::total(ledgers, true), clock_ns)},
            {"lights", rows}};
}

}  // namespace

const char* no_truth_because(const LoadedScene& scene) {
    if (scene.stream) return "a stream: its primitives are not held";
    return traces_patches() ? "free patches: there is no memory for their triangles"
                            : "free patches: built without Embree; install libembree-dev and "
                              "build again";
}

Rendered::Rendered(LoadedScene loaded, const RenderOptions& options)
    : scene(std::move(loaded)),
      pool(workers_for(options.threads)),
      job(scene.view(), scene.settings, Maps::shown, pool.executor()),
      patches(scene.patches.size()),
      triangles(scene.facets.size()) {
    if (scene.stream) {
        draw_stream();
    } else {
        job.render();
    }
    if (options.truth)
        for (std::size_t l = 0; l < scene.lights.size(); ++l) compare(options, l);
    warnings = frame_warnings(scene, job, error());
}

void Rendered::draw_stream() {
    StreamWatch watch(scene);
    job.render_stream(watch, *scene.stream);
    patches = watch.patches();
    triangles = watch.triangles();
    scene.sample = watch.sample();
    const Warnings found = warnings_of_stream(scene, watch.seen());
    scene.warnings.insert(scene.warnings.end(), found.begin(), found.end());
}

// The error map is the first light's.
void Rendered::compare(const RenderOptions& options, std::size_t light) {
    truths.push_back(scene.stream ? std::nullopt : trace(scene, light));
    const std::optional<SceneTruth>& truth = truths.back();
    const bool wants_map = light == 0 && !options.error_map.empty();
    if (!truth && wants_map)
        throw SceneError(fmt::format("--error {}: {} has no exact truth: {}",
                                     options.error_map, scene.name,
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

std::uint64_t peak_bytes() {
    struct rusage used {};
    ::getrusage(RUSAGE_SELF, &used);
    return static_cast<std::uint64_t>(used.ru_maxrss) * 1024;
}

ordered_json to_json(const Rendered& rendered) {
    const RenderJob& job = rendered.job;
    ordered_json json{{"size_px", rendered.scene.settings.machine.size_px()},
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
    if (rendered.has_map()) json["bias"] = to_json(bias_report(job));
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

}  // namespace umbra78::tools
