#include "tools/web/answers.hpp"

#include "tools/render/cycle_report.hpp"
#include "tools/render/frame_warnings.hpp"
#include "tools/render/report.hpp"
#include "tools/scene/checks.hpp"
#include "tools/scene/settings_text.hpp"
#include "tools/scene/view_keys.hpp"
#include "tools/study/moire/frame.hpp"
#include "tools/truth/real_scene.hpp"
#include "tools/watch/pixel_trace.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace umbra78::tools::web {
namespace {

using nlohmann::ordered_json;

// The angles as a scene file has them, of the axis that points back to the eye, Q2.30.
ordered_json view_json(const std::string& name, const raster::View& view,
                       const raster::World& origin) {
    const auto q = [](auto word, int fraction) {
        return std::ldexp(static_cast<double>(word), -fraction);
    };
    const double x = q(view.axes.back[0], 30), y = q(view.axes.back[1], 30),
                 z = q(view.axes.back[2], 30);
    constexpr double degrees = 180 / std::numbers::pi;
    const Real3 target = real(view.target), from = real(origin);
    const double distance = q(view.distance, raster::world_fraction);
    return {{"name", name},
            {"perspective", raster::has_eye(view)},
            {"azimuth", std::atan2(x, z) * degrees},
            {"elevation", std::asin(std::clamp(y, -1.0, 1.0)) * degrees},
            {"target", {target[0] + from[0], target[1] + from[1], target[2] + from[2]}},
            {"distance", distance},
            {"extent", q(view.extent, raster::world_fraction)}};
}

// As umbra78 render has them: a rate of no pixels is n/a.
ordered_json rates_json(const ShadowError& error) {
    ordered_json json{{"false_shadow", nullptr}, {"false_light", nullptr}};
    if (error.lit > 0) json["false_shadow"] = error.false_shadow_rate();
    if (error.shadowed > 0) json["false_light"] = error.false_light_rate();
    return json;
}

// Against polygons there are rates and no bands, edges or coverage.
ordered_json polygon_error_json(const SceneTruth& truth, const MachineMask& mask) {
    const ShadowError all = shadow_error(truth.truth, mask, truth.unlit_side);
    ordered_json json = rates_json(all);
    json["lit_pixels"] = all.lit;
    json["shadowed_pixels"] = all.shadowed;
    const GradedError graded = graded_error(truth.truth, mask, truth.unlit_side);
    json["graded"] = {{"mean_absolute", graded.mean_absolute()}};
    json["truth"] = {{"by", "polygons"}};
    return json;
}

constexpr int spectrum_px = 64;

}  // namespace

ordered_json frame_json(Session& session) {
    const RenderJob& job = session.job();
    const LoadedScene& scene = session.scene();
    ordered_json json;
    for (const PlaneOf& plane : job.planes()) {
        const Buffer buffer = job.buffer(plane);
        json["planes"].push_back(
            {{"name", buffer.name}, {"size", buffer.size_px}, {"most", buffer.maxval}});
    }
    json["coloured"] = job.coloured();
    json["surfaces"] = scene.patches.size() + scene.facets.size();
    json["host_ms"] = to_json(job.times());
    if (shadow::map_layers(job.settings()) > 0) json["bias"] = to_json(bias_report(job));
    json["views"].push_back(view_json("observer", scene.observer, scene.origin));
    for (std::size_t l = 0; l < scene.lights.size(); ++l)
        json["views"].push_back(view_json(name_of_light(l, scene.lights.size()),
                                          scene.lights[l].view, scene.origin));
    json["settings"] = settings_json(job.settings());
    json["method"] = shadow::method_of(job.inputs()).name;
    json["has_closed_form"] = scene.has_closed_form();
    json["warnings"] = lines_of(scene.warnings);
    json["isolated_pixels"] =
        isolated_pixels(session.mask(), job.settings().machine.size_px());
    if (session.knows_truth()) json["rates"] = rates_json(session.rates());
    return json;
}

ordered_json hashes_json(const Session& session) {
    ordered_json json = ordered_json::object();
    for (const PlaneOf& plane : session.job().planes()) {
        const Buffer buffer = session.job().buffer(plane);
        json[buffer.name] = hash_of(buffer);
    }
    return json;
}

ordered_json machine_json(const Session& session) {
    const std::vector<shadow::FrameLedger> ledgers = session.job().ledgers();
    const int clock_ns = session.job().settings().timing.clock_ns;
    const std::uint64_t cycles = shadow::total(ledgers, true);
    return {{"cycles", cycles},
            {"ms", simulated_ms(cycles, clock_ns)},
            {"transformation", ledgers.front().transformation(true)},
            {"ledger", to_json(ledgers.front(), clock_ns)}};
}

ordered_json error_json(Session& session) {
    const SceneTruth* truth = session.truth();
    if (truth == nullptr) return {{"error", nullptr}, {"because", session.why_no_truth()}};
    const study::ErrorSpectrum whole = study::error_spectrum(*truth, session.mask(), 0);
    const Peak peak = highest_peak(
        periodogram(study::busiest_window(*truth, session.mask(), spectrum_px), spectrum_px),
        spectrum_px);
    ordered_json json{{"windows", whole.flatness.windows}};
    json["flatness"] =
        whole.flatness.windows > 0 ? ordered_json(whole.flatness.median) : ordered_json(nullptr);
    // Too few errors for a spectrum have no period either.
    const bool has_line = whole.flatness.windows > 0 && peak.over_mean > 0;
    json["period_px"] = has_line ? ordered_json(peak.at.period_px()) : ordered_json(nullptr);
    json["peak_over_mean"] = peak.over_mean;
    if (truth->closed_form) {
        const ShadowReport report = session.error();
        json["error"] = to_json(std::optional(report));
        json["warnings"] = lines_of(frame_warnings(session.scene(), session.job(), report));
    } else {
        json["error"] = polygon_error_json(*truth, session.mask());
    }
    return json;
}

ordered_json trace_json(const Session& session, int x, int y) {
    if (session.scene().lights.size() > 1 || !session.scene().lights.front().parts.empty() ||
        session.scene().is_coloured() || session.scene().lights.front().ramp_px > 0)
        throw SceneError("a pixel is followed in a grey frame with one light and one depth map "
                         "without a ramp; leave out the others");
    const PixelTrace trace = trace_pixel(session.job(), {x, y});
    ordered_json json = to_json(trace);
    json["summary"] = summary(trace);
    return json;
}

ordered_json around_json(const Session& session, const std::string& plane, int x, int y,
                         int radius) {
    for (const PlaneOf& of : session.job().planes()) {
        const Buffer buffer = session.job().buffer(of);
        if (buffer.name != plane) continue;
        const int size = buffer.size_px;
        ordered_json rows = ordered_json::array();
        for (int row = y - radius; row <= y + radius; ++row) {
            ordered_json& codes = rows.emplace_back(ordered_json::array());
            for (int column = x - radius; column <= x + radius; ++column) {
                const bool inside = row >= 0 && row < size && column >= 0 && column < size;
                codes.push_back(nullptr);
                if (inside) codes.back() = buffer.at(std::size_t(row) * size + column);
            }
        }
        return {{"plane", plane}, {"most", buffer.maxval}, {"rows", rows}};
    }
    return {{"problem", "this frame has no plane " + plane}};
}

}  // namespace umbra78::tools::web
