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

// Without a pixel to count there is no rate: 0 would say that all is right.
std::optional<double> false_shadow(const ShadowError& error) {
    return error.lit > 0 ? std::optional(error.false_shadow_rate()) : std::nullopt;
}
std::optional<double> false_light(const ShadowError& error) {
    return error.shadowed > 0 ? std::optional(error.false_light_rate()) : std::nullopt;
}

ordered_json to_json(std::optional<double> rate) {
    return rate ? ordered_json(*rate) : ordered_json(nullptr);
}

ordered_json to_json(const Coverage& c) {
    return {{"seen_by_truth", c.seen}, {"drawn", c.drawn},         {"missing", c.missing},
            {"extra", c.extra},        {"misplaced", c.misplaced}, {"beyond_edge", c.beyond_edge}};
}

std::string print(const Coverage& c, const ShadowReport& report) {
    const int compared = report.all.lit + report.all.shadowed;
    std::string text = fmt::format("compared    {} of {} pixels drawn; {} lie beyond the exact "
                                   "silhouette, {} on unlit sides\n",
                                   compared, c.drawn, c.beyond_edge, report.unlit_side);
    if (!c.complete())
        text += fmt::format("coverage    {} pixels missing of {} that truth sees, {} extra, {} at "
                            "another depth\n", c.missing, c.seen, c.extra, c.misplaced);
    return text;
}

ordered_json to_json(const ShadowError& error) {
    return {{"false_shadow", to_json(false_shadow(error))},
            {"false_light", to_json(false_light(error))},
            {"lit_pixels", error.lit},
            {"shadowed_pixels", error.shadowed}};
}

ordered_json to_json(const GradedError& e) {
    const auto of = [](double value, int pixels) {
        return to_json(pixels > 0 ? std::optional(value) : std::nullopt);
    };
    return {{"mean_absolute", of(e.mean_absolute(), e.pixels())},
            {"rms", of(e.rms(), e.pixels())},
            {"lit_below_98_percent", of(e.lit_below_98_rate(), e.lit)},
            {"umbra_above_2_percent", of(e.umbra_above_2_rate(), e.umbra)},
            {"penumbra_ratio", of(e.penumbra_ratio(), e.penumbra)}};
}

std::string print(const GradedError& e) {
    const auto share = [](double rate, int pixels) {
        return pixels > 0 ? percent(rate) + " %" : percent(std::nullopt);
    };
    return fmt::format("of the light that truth sees: {} on average, {} rms; {} of the lit pixels "
                       "get less than 98 %, {} of those in shadow more than 2 %{}\n",
                       share(e.mean_absolute(), e.pixels()), share(e.rms(), e.pixels()),
                       share(e.lit_below_98_rate(), e.lit),
                       share(e.umbra_above_2_rate(), e.umbra),
                       e.penumbra > 0 ? fmt::format("; the penumbra has {:.2f} times the true "
                                                    "one's pixels", e.penumbra_ratio())
                                      : "");
}

std::string print_rates(const ShadowReport& report) {
    const auto rate = [](std::optional<double> r) { return r ? percent(r) + " %" : percent(r); };
    return fmt::format(
        "false shadow {}, false light {}; outside one light texel of the edge {}, {}; "
        "{} isolated pixels\n",
        rate(false_shadow(report.all)), rate(false_light(report.all)),
        rate(false_shadow(report.outside_band)), rate(false_light(report.outside_band)),
        report.isolated_pixels);
}

}  // namespace

BiasReport bias_report(const RenderJob& job, std::size_t light) {
    const shadow::Scene& scene = job.inputs().scene;
    const std::size_t map = scene.source(light).first_light;
    const shadow::BiasUnits units = shadow::bias_units(scene.lights[map], job.settings().machine);
    const double quanta =
        std::ldexp(static_cast<double>(job.matrices().lights[map].bias_quanta_q16), -16);
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

std::string print(const ShadowReport& report) {
    std::string text = "error       ";
    if (report.coverage && !report.coverage->complete())
        text += fmt::format("{} % of all pixels are missing, extra, misplaced or wrong in shadow\n"
                            "            of those compared: ", percent(report.wrong_share()));
    text += report.graded.graded() ? print(report.graded) : print_rates(report);
    if (report.coverage) text += print(*report.coverage, report);
    if (!std::isnan(report.edge.mean))
        text += fmt::format("edge        {:.2f} pixels from the true edge on average, at most "
                            "{:.1f}\n", report.edge.mean, report.edge.hausdorff);
    if (report.tessellation_error)
        text += fmt::format("truth       traced by Embree; with half as many triangles a side {} % "
                            "of the pixels change\n", percent(report.tessellation_error));
    return text;
}

std::string print_on_ground(const ShadowReport& report) {
    return "ground      " +
           (report.graded.graded() ? print(report.graded) : print_rates(report));
}

ordered_json to_json(const BiasReport& bias) {
    return {{"quanta", bias.quanta}, {"texels", bias.texels}, {"world", bias.world}};
}

// Of a stream the stages are not timed apart.
ordered_json to_json(const StageTimes& times) {
    if (times.stream_ms > 0)
        return {{"matrices", times.matrices_ms},
                {"stream", times.stream_ms},
                {"total", times.total_ms()}};
    return {{"matrices", times.matrices_ms},
            {"light", times.light_ms},
            {"observer", times.observer_ms},
            {"post_process", times.post_process_ms},
            {"filters", times.filters_ms},
            {"total", times.total_ms()}};
}

ordered_json to_json(const std::optional<ShadowReport>& report) {
    if (!report) return nullptr;
    ordered_json rates = to_json(report->all);
    rates["outside_light_texel_band"] = to_json(report->outside_band);
    // Rates of right and wrong pixels are of binary masks.
    ordered_json json = report->graded.graded() ? ordered_json{{"at_threshold", rates}} : rates;
    json["graded"] = to_json(report->graded);
    json["edge_distance_px"] = {{"mean", report->edge.mean},
                                {"hausdorff", report->edge.hausdorff}};
    if (report->coverage) {
        json["coverage"] = to_json(*report->coverage);
        json["wrong_pixels"] = report->wrong_pixels;
        json["wrong_share"] = report->wrong_share();
    }
    json["unlit_side_pixels"] = report->unlit_side;
    json["isolated_pixels"] = report->isolated_pixels;
    json["threshold"] = report->threshold;
    json["truth"] = {{"by", report->tessellation_error ? "Embree" : "closed form"}};
    if (report->tessellation_error)
        json["truth"]["uncertain_pixels"] = *report->tessellation_error;
    return json;
}

}  // namespace umbra78::tools
