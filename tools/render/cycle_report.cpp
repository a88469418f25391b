#include "tools/render/cycle_report.hpp"

#include "tools/render/ap120b_report.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>
#include <utility>

namespace umbra78::tools {
namespace {

using nlohmann::ordered_json;
using shadow::FrameLedger;
using shadow::PhaseLedger;
using shadow::StageLedger;

// The phases that are costed in operations, in the order of the frame; the transformation, which
// may be clocked, stands before the third of them.
constexpr std::ptrdiff_t after_transformation = 2;
std::vector<std::pair<const char*, const PhaseLedger*>> phases(const FrameLedger& l) {
    std::vector<std::pair<const char*, const PhaseLedger*>> all{
        {l.on_ground ? "shadow, flat" : "light's view", &l.light},
        {"observer's view", &l.observer},
        {"dequantize", &l.dequantize},
        {"low-pass", &l.low_pass},
        {"composite", &l.composite}};
    if (l.join.units.side_by_side() > 0)  // of an area or a ramp
        all.insert(all.begin() + after_transformation, {"darkness", &l.join});
    return all;
}

std::string blamed(const shadow::PostProcessLedger& l, const StageLedger& row) {
    if (row.blamed < 0) return "";
    return fmt::format("by {}", l.rows[static_cast<std::size_t>(row.blamed)].stage);
}

ordered_json to_json(const shadow::PostProcessLedger& l) {
    ordered_json stages = ordered_json::array();
    for (int k = 0; k < l.count; ++k) {
        const StageLedger& row = l.rows[static_cast<std::size_t>(k)];
        stages.push_back({{"unit", name_of(row.unit)},
                          {"stage", row.stage},
                          {"cycles_a_point", row.stay},
                          {"work", row.work},
                          {"blocked", row.blocked},
                          {"held", row.held},
                          {"idle", row.idle}});
    }
    return {{"visible", l.visible},
            {"cycles", l.total},
            {"without_overlap", l.without_overlap()},
            {"slot_cycles", l.slot_cycles},
            {"latency_cycles", l.latency},
            {"bottleneck", l.bottleneck().stage},
            {"stages", stages}};
}

}  // namespace

const char* name_of(shadow::PostProcessUnit unit) {
    constexpr std::array names{"reader", "transform", "divider", "lookup", "writer"};
    return names[static_cast<std::size_t>(unit)];
}

std::string print_frame(const FrameLedger& l, int clock_ns) {
    std::string text =
        fmt::format("{:<16}{:>12}{:>12}{:>12}{:>12}{:>14}{:>18}{:>11}  {}\n", "phase", "adders",
                    "multipliers", "divider", "store", "side by side", "one by one", "ms",
                    "busiest");
    const auto row = [&](const char* name, const PhaseLedger& p) {
        const hw::UnitCycles& u = p.units;
        text += fmt::format("{:<16}{:>12}{:>12}{:>12}{:>12}{:>14}{:>18}{:>11.2f}  {}\n", name,
                            u.adders, u.multipliers, u.divider, u.store, u.side_by_side(),
                            u.one_after_the_other(), simulated_ms(u.side_by_side(), clock_ns),
                            u.side_by_side() > 0 ? u.busiest() : "left out");
    };
    const auto all = phases(l);
    for (std::size_t k = 0; k < all.size(); ++k) {
        if (k == after_transformation) {
            text += fmt::format("{:<16}{:>48}{:>14}{:>18}{:>11.2f}  {}\n", "transformation",
                                l.on_array    ? "AP-120B, see below"
                                : l.has_map   ? "clocked, see below"
                                : l.on_ground ? "with the observer's view"
                                              : "counted",
                                l.transformation(true), l.transformation(false),
                                simulated_ms(l.transformation(true), clock_ns), l.bottleneck());
            if (l.test.units.side_by_side() > 0) row("  its operations", l.test);
        }
        row(all[k].first, *all[k].second);
    }
    text += fmt::format("{:<16}{:>62}{:>18}{:>11.2f}\n", "frame", l.total(true), l.total(false),
                        simulated_ms(l.total(true), clock_ns));
    return text;
}

std::string print_post_process(const shadow::PostProcessLedger& l, int clock_ns) {
    std::string text = fmt::format("{:<11}{:<13}{:>5}{:>12}{:>7}{:>10}{:>10}{:>12}\n", "unit",
                                   "stage", "stay", "work", "%", "blocked", "held", "idle");
    for (int k = 0; k < l.count; ++k) {
        const StageLedger& row = l.rows[static_cast<std::size_t>(k)];
        const double share = l.total == 0 ? 0
                                          : 100.0 * static_cast<double>(row.work) /
                                                static_cast<double>(l.total);
        text += fmt::format("{:<11}{:<13}{:>5}{:>12}{:>7.1f}{:>10}{:>10}{:>12}  {}\n",
                            name_of(row.unit), row.stage, row.stay, row.work, share, row.blocked,
                            row.held, row.idle, blamed(l, row));
    }
    text += fmt::format("{} cycles, {:.2f} ms: {} visible pixels, one every {} cycles, {} cycles "
                        "on its way; bottleneck: {}\n",
                        l.total, simulated_ms(l.total, clock_ns), l.visible, l.slot_cycles,
                        l.latency, l.bottleneck().stage);
    return text;
}

ordered_json to_json(const FrameLedger& l, int clock_ns) {
    ordered_json json{{"clock_ns", clock_ns}};
    for (const auto& [name, phase] : phases(l))
        json["phases"].push_back({{"phase", name},
                                  {"adders", phase->units.adders},
                                  {"multipliers", phase->units.multipliers},
                                  {"divider", phase->units.divider},
                                  {"store", phase->units.store},
                                  {"side_by_side", phase->units.side_by_side()},
                                  {"one_after_the_other", phase->units.one_after_the_other()}});
    if (l.has_map)
        json["transformation"] =
            l.on_array ? to_json(l.array, clock_ns) : to_json(l.post_process);
    else if (l.on_ground)
        json["masks"] = {{"store", l.test.units.store}};
    else
        json["transformation"] = {{"cycles", l.transformation(true)},
                                  {"bottleneck", l.bottleneck()},
                                  {"cycles_once", l.scene.units.side_by_side()}};
    json["frame_cycles"] = {{"side_by_side", l.total(true)},
                            {"one_after_the_other", l.total(false)}};
    json["frame_ms"] = simulated_ms(l.total(true), clock_ns);
    const CostClaim claim = cost_claim(l);
    json["claim"] = {{"both_views_over_observer", claim.both_views},
                     {"transformation_over_observer", claim.transformation},
                     {"depth_complexity", claim.depth_complexity}};
    return json;
}

FrameLedger of_figure(FrameLedger l, int figure) {
    if (figure == 1) l.light = {};
    if (figure == 2) l.observer = {};
    if (figure < 3) l.post_process = {}, l.array = {}, l.test = {};
    if (figure < 5) l.dequantize = l.low_pass = {};
    if (figure < 6) l.composite = {};
    return l;
}

CostClaim cost_claim(const FrameLedger& l) {
    const auto observer = static_cast<double>(FrameLedger::cycles(l.observer, true));
    const auto light = static_cast<double>(FrameLedger::cycles(l.light, true));
    if (observer == 0 || l.visible == 0) return {};
    return {(observer + light) / observer,
            static_cast<double>(l.transformation(true)) / observer,
            static_cast<double>(l.observer_counts.samples) / static_cast<double>(l.visible)};
}

}  // namespace umbra78::tools
