#include "tools/report.hpp"

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
    const double quanta = std::ldexp(static_cast<double>(job.matrices().bias_quanta_q16), -16);
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

const char* name_of(shadow::ArrayStepSource source) {
    constexpr const char* names[] = {"replayed", "published", "assumed"};
    return names[static_cast<std::size_t>(source)];
}

ordered_json to_json(const shadow::ArrayCost& cost, int clock_ns) {
    ordered_json steps = ordered_json::array();
    for (const shadow::ArrayStep& s : cost.list())
        steps.push_back({{"step", s.name},
                         {"source", name_of(s.source)},
                         {"elements_a_pixel", s.elements},
                         {"cycles_an_element", s.cycles},
                         {"ms", simulated_ms(cost.cycles(s), clock_ns)}});
    return {{"cycles", cost.cycles()},
            {"ms", simulated_ms(cost.cycles(), clock_ns)},
            {"host_transfer_ms", static_cast<double>(cost.transfer_us()) * 1e-3},
            {"library_calls", cost.calls()},
            {"steps", steps}};
}

std::string print(const shadow::ArrayCost& cost, int clock_ns) {
    std::string text = fmt::format("AP-120B     {} cycles, {:.1f} ms\n", cost.cycles(),
                                   simulated_ms(cost.cycles(), clock_ns));
    for (const shadow::ArrayStep& s : cost.list())
        text += fmt::format("  {:<24}{:>8.1f} ms  {} x {} cycles a pixel ({})\n", s.name,
                            simulated_ms(cost.cycles(s), clock_ns), s.elements, s.cycles,
                            name_of(s.source));
    const auto call_ms = [&](int us) { return static_cast<double>(cost.calls()) * us * 1e-3; };
    return text + fmt::format("  apart: host transfer {:.1f} ms (assumed); {} library calls, "
                              "{:.0f} to {:.0f} ms of overhead (published)\n",
                              static_cast<double>(cost.transfer_us()) * 1e-3, cost.calls(),
                              call_ms(shadow::array_call_least_us),
                              call_ms(shadow::array_call_most_us));
}

ordered_json to_json(const MachineCost& cost) {
    const shadow::PostProcessCycles& p = cost.post_process;
    ordered_json json = {{"cycle_ns", cost.clock_ns},
            {"light_transform_cycles", cost.light_cycles},
            {"observer_transform_cycles", cost.observer_cycles},
            {"transform_cycles", cost.transform_cycles()},
            {"transform_ms", cost.transform_ms()},
            {"post_process_cycles",
             {{"read", p.read},
              {"transform", p.transform},
              {"divide", p.divide},
              {"lookup", p.lookup},
              {"write", p.write},
              {"overlapped", p.overlapped()}}},
            {"post_process_ms", simulated_ms(p.overlapped(), cost.clock_ns)}};
    if (cost.array) {
        json.erase("post_process_cycles");
        json["ap120b"] = to_json(*cost.array, cost.clock_ns);
        json["post_process_ms"] = json["ap120b"]["ms"];
    }
    return json;
}

ordered_json to_json(const std::optional<ShadowReport>& report) {
    if (!report) return nullptr;
    ordered_json json = to_json(report->all);
    json["outside_light_texel_band"] = to_json(report->outside_band);
    json["isolated_pixels"] = report->isolated_pixels;
    json["threshold"] = report->threshold;
    return json;
}

std::string print(const ordered_json& json) { return json.dump(2) + "\n"; }

}  // namespace umbra78::tools
