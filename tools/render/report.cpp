#include "tools/render/report.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace umbra78::tools {
namespace {

using nlohmann::ordered_json;

double real(const hw::Rational& exact) {
    std::int64_t q32 = 0;
    exact.round_scaled(32, fixed::Rounding::half_even, q32);
    return std::ldexp(static_cast<double>(q32), -32);
}

ordered_json to_json(const ShadowError& error) {
    return {{"false_shadow", error.false_shadow_rate()},
            {"false_light", error.false_light_rate()},
            {"lit_pixels", error.lit},
            {"shadowed_pixels", error.shadowed}};
}

}  // namespace

BiasReport bias_report(const raster::View& light, const RenderJob& job) {
    const shadow::BiasUnits units = shadow::bias_units(light, job.settings().machine);
    const double quanta = std::ldexp(static_cast<double>(job.matrices().lights[0].bias_quanta_q16),
                                     -16);
    const double world = quanta / real(units.quanta_per_world);
    return {quanta, world * real(units.texels_per_world), world};
}

std::string print(const BiasReport& bias) {
    return fmt::format("{:.6g} quanta = {:.4g} texels = {:.4g} world units", bias.quanta,
                       bias.texels, bias.world);
}

std::string percent(std::optional<double> rate) {
    return rate ? fmt::format("{:.2f}", 100 * *rate) : "n/a";
}

ordered_json to_json(const BiasReport& bias) {
    return {{"quanta", bias.quanta}, {"texels", bias.texels}, {"world", bias.world}};
}

ordered_json to_json(const StageTimes& times) {
    return {{"matrices", times.matrices_ms},
            {"light", times.light_ms},
            {"observer", times.observer_ms},
            {"post_process", times.post_process_ms},
            {"filters", times.filters_ms},
            {"total", times.total_ms()}};
}

ordered_json to_json(const std::optional<ShadowReport>& report) {
    if (!report) return nullptr;
    ordered_json json = to_json(report->all);
    json["outside_light_texel_band"] = to_json(report->outside_band);
    json["edge_distance_px"] = {{"mean", report->edge.mean},
                                {"hausdorff", report->edge.hausdorff}};
    json["isolated_pixels"] = report->isolated_pixels;
    json["threshold"] = report->threshold;
    json["truth"] = {{"by", report->tessellation_error ? "Embree" : "closed form"}};
    if (report->tessellation_error)
        json["truth"]["uncertain_pixels"] = *report->tessellation_error;
    return json;
}

}  // namespace umbra78::tools
