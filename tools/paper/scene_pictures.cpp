#include "tools/paper/scene_pictures.hpp"

#include "tools/io/text_formats.hpp"
#include "tools/render/cycle_report.hpp"
#include "tools/render/frame_warnings.hpp"
#include "tools/render/ground_pixels.hpp"
#include "tools/scene/checks.hpp"
#include "tools/scene/scene_file.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <atomic>
#include <exception>
#include <filesystem>
#include <sstream>
#include <thread>

namespace umbra78::tools {
namespace {

// The observer's view is drawn once more by itself, for its time is that of a frame without shadow.
void measure(const LoadedScene& scene, const RenderJob& job, DrawnScene& made) {
    const std::vector<shadow::FrameLedger> ledgers = job.ledgers();
    const StageTimes& t = job.times();
    made.clock_ns = scene.settings.timing.clock_ns;
    made.lights = scene.lights.size();
    const bool has_map = ledgers.front().has_map;
    made.maps = has_map ? ledgers.size() : 0;
    made.cost = {shadow::total(ledgers, true), of_figure(ledgers.front(), 1).total(true),
                 t.total_ms(), t.matrices_ms + t.observer_ms};
    if (!ledgers.front().on_ground) return;
    // Here the shadow is drawn with the observer's view.
    shadow::Settings plain = scene.settings;
    plain.form = shadow::Form::post_process;
    RenderJob without(scene.view(), plain);
    without.draw_observer();
    made.cost.host_ms_without = without.times().matrices_ms + without.times().observer_ms;
}

void compare(const LoadedScene& scene, const RenderJob& job, DrawnScene& made) {
    const std::vector<std::uint8_t> visible = job.visible();
    const Buffer depths = job.buffer(Plane::observer_z);
    const auto compared = [&](const SceneTruth& truth, std::size_t light) {
        return report(truth, {job.bytes({Plane::filtered, light}), visible},
                      widened(light_texel_band(truth), truth, scene.settings), &depths);
    };
    for (std::size_t l = 0; scene.lights.size() > 1 && l < scene.lights.size(); ++l)
        if (const std::optional<SceneTruth> truth = trace(scene, l))
            made.by_light.push_back(compared(*truth, l));
    if (scene.lights.size() > 1) return;
    const std::optional<SceneTruth> truth = trace(scene);
    if (!truth) return;
    const Band band = widened(light_texel_band(*truth), *truth, scene.settings);
    made.error = compared(*truth, 0);
    if (!scene.ground) return;
    const std::vector<std::uint8_t> ground = ground_pixels(scene, job);
    made.on_ground = report(*truth, {job.bytes(Plane::filtered), ground}, band);
}

DrawnScene draw(const ScenePicture& of, const std::string& folder) {
    DrawnScene made;
    made.of = &of;
    if (!of.needs.empty() && !std::filesystem::exists(of.needs)) {
        made.left_out = fmt::format("there is no {}; the Debian package {} brings it", of.needs,
                                    of.package);
        return made;
    }
    std::vector<std::string> set;
    std::istringstream overrides{std::string(of.set)};
    for (std::string one; overrides >> one;) set.push_back(one);
    const LoadedScene scene = load_scene(fmt::format("{}/{}", folder, of.scene), set);
    RenderJob job(scene.view(), scene.settings);
    job.render();
    made.size_px = scene.settings.machine.size_px();
    for (std::size_t c = 0; c < (job.coloured() ? 3 : 1); ++c) {
        const std::span<const std::uint8_t> bytes = job.bytes({Plane::picture, 0, c});
        made.channels.emplace_back(bytes.begin(), bytes.end());
    }
    if (job.coloured()) made.rgb = job.rgb();
    made.patches = scene.patches.size();
    made.triangles = scene.facets.size();
    measure(scene, job, made);
    compare(scene, job, made);
    made.warnings = lines_of(frame_warnings(scene, job, made.error));
    return made;
}

}  // namespace

std::vector<std::uint8_t> DrawnScene::gray() const {
    if (!coloured()) return channels.front();
    std::vector<std::uint8_t> made;
    for (std::size_t a = 0; a < channels[0].size(); ++a)
        made.push_back(static_cast<std::uint8_t>(
            (channels[0][a] + 2 * channels[1][a] + channels[2][a] + 2) / 4));
    return made;
}

std::vector<Buffer> DrawnScene::buffers() const {
    constexpr const char* names[] = {"_red", "_green", "_blue"};
    std::vector<Buffer> made;
    for (std::size_t c = 0; c < channels.size(); ++c)
        made.push_back({std::string(of->name) + (coloured() ? names[c] : ""), size_px, 255,
                        std::span<const std::uint8_t>(channels[c])});
    return made;
}

std::vector<DrawnScene> draw_scene_pictures(const std::string& folder) {
    const std::span<const ScenePicture> table = scene_pictures();
    std::vector<DrawnScene> drawn(table.size());
    std::vector<std::exception_ptr> errors(drawn.size());
    std::atomic<std::size_t> next = 0;
    const auto work = [&] {
        for (std::size_t k = next++; k < drawn.size(); k = next++) try {
                drawn[k] = draw(table[k], folder);
            } catch (...) {
                errors[k] = std::current_exception();
            }
    };
    // Exact truth takes up to half a gigabyte a scene.
    const unsigned most = std::min(std::thread::hardware_concurrency(), 3u);
    std::vector<std::jthread> threads;
    for (unsigned k = 1; k < most; ++k) threads.emplace_back(work);
    work();
    threads.clear();  // waits for them
    for (const std::exception_ptr& error : errors)
        if (error) std::rethrow_exception(error);
    return drawn;
}

std::string cost_table(std::span<const DrawnScene> drawn) {
    std::vector<std::vector<std::string>> rows{{"picture", "patches", "triangles", "depth maps",
                                                "machine ms without", "with", "times",
                                                "host ms without", "with", "times"}};
    for (const DrawnScene& d : drawn) {
        if (!d.left_out.empty()) continue;
        const auto ms = [&](std::uint64_t cycles) {
            return fmt::format("{:.1f}", simulated_ms(cycles, d.clock_ns));
        };
        rows.push_back({std::string(d.of->name), fmt::format("{}", d.patches),
                        fmt::format("{}", d.triangles), fmt::format("{}", d.maps),
                        ms(d.cost.cycles_without),
                        ms(d.cost.cycles), fmt::format("{:.2f}", d.cost.times_cycles()),
                        fmt::format("{:.1f}", d.cost.host_ms_without),
                        fmt::format("{:.1f}", d.cost.host_ms),
                        fmt::format("{:.2f}", d.cost.times_host())});
    }
    return markdown_table(rows);
}

nlohmann::ordered_json to_json(const DrawnScene& d) {
    nlohmann::ordered_json json{{"picture", d.of->name}, {"shows", d.of->shows},
                                {"scene", d.of->scene}};
    if (!d.left_out.empty()) {
        json["left_out"] = d.left_out;
        return json;
    }
    json["patches"] = d.patches;
    json["triangles"] = d.triangles;
    json["lights"] = d.lights;
    json["depth_maps"] = d.maps;
    for (const Buffer& b : d.buffers()) json[d.coloured() ? b.name : "hash"] = hash_of(b);
    json["machine_cycles"] = d.cost.cycles;
    json["machine_cycles_without_shadow"] = d.cost.cycles_without;
    json["host_ms"] = d.cost.host_ms;
    json["host_ms_without_shadow"] = d.cost.host_ms_without;
    json["error"] = to_json(d.error);
    for (const ShadowReport& one : d.by_light) json["error_by_light"].push_back(to_json(one));
    if (d.on_ground) json["error_on_ground"] = to_json(d.on_ground);
    json["warnings"] = d.warnings;
    return json;
}

}  // namespace umbra78::tools
