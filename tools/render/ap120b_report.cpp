#include "tools/render/ap120b_report.hpp"

#include "tools/render/render_job.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace umbra78::tools {
namespace {

const char* source_name(shadow::ArrayCycleSource source) {
    constexpr const char* names[] = {"replayed", "published", "assumed"};
    return names[static_cast<std::size_t>(source)];
}

double transfer_ms(const shadow::ArrayCost& cost) {
    return static_cast<double>(cost.transfer_us()) * 1e-3;
}

}  // namespace

std::string print(const shadow::ArrayCost& cost, int clock_ns) {
    std::string text = fmt::format("AP-120B     {} cycles, {:.1f} ms\n", cost.cycles(),
                                   simulated_ms(cost.cycles(), clock_ns));
    for (const shadow::ArrayCostStep& s : cost.list())
        text += fmt::format("  {:<24}{:>8.1f} ms  {} x {} cycles a pixel ({})\n", s.name,
                            simulated_ms(cost.cycles(s), clock_ns), s.elements, s.cycles,
                            source_name(s.source));
    const auto call_ms = [&](int us) { return static_cast<double>(cost.calls()) * us * 1e-3; };
    return text + fmt::format("  apart: host transfer {:.1f} ms (assumed); {} library calls, "
                              "{:.0f} to {:.0f} ms of overhead (published)\n",
                              transfer_ms(cost), cost.calls(),
                              call_ms(shadow::array_call_min_us),
                              call_ms(shadow::array_call_max_us));
}

nlohmann::ordered_json to_json(const shadow::ArrayCost& cost, int clock_ns) {
    auto steps = nlohmann::ordered_json::array();
    for (const shadow::ArrayCostStep& s : cost.list())
        steps.push_back({{"step", s.name},
                         {"source", source_name(s.source)},
                         {"elements_a_pixel", s.elements},
                         {"cycles_an_element", s.cycles},
                         {"ms", simulated_ms(cost.cycles(s), clock_ns)}});
    return {{"visible", cost.pixels},
            {"cycles", cost.cycles()},
            {"ms", simulated_ms(cost.cycles(), clock_ns)},
            {"host_transfer_ms", transfer_ms(cost)},
            {"library_calls", cost.calls()},
            {"bottleneck", cost.longest().name},
            {"steps", steps}};
}

}  // namespace umbra78::tools
