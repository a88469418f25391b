#include "tools/render/profile_costs.hpp"

#include "shadow/frame/profiles.hpp"
#include "tools/io/text_formats.hpp"
#include "tools/scene/scene_file.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace umbra78::tools {
namespace {

using nlohmann::ordered_json;
using shadow::FrameLedger;

const std::vector<std::string> columns{
    "profile",    "observer's view ms", "light's view ms",        "transformation ms",
    "filters ms", "total ms",           "both views / observer's", "transformation's bottleneck"};

std::vector<std::string> cells(const ProfileCost& c) {
    const auto ms = [](double v) { return v == 0 ? "" : fmt::format("{:.1f}", v); };
    const std::string name = fmt::format("`{}`", c.profile);
    if (!c.refused.empty()) return {name, "", "", "", "", "", "", c.refused};
    return {name,
            ms(c.observer_ms),
            ms(c.light_ms),
            ms(c.transformation_ms),
            ms(c.filters_ms),
            ms(c.total_ms()),
            c.transformation_ms > 0 ? fmt::format("{:.2f}", c.claim.both_views) : "",
            c.transformation_ms > 0 ? c.busiest : ""};
}

}  // namespace

ProfileCost profile_cost(const LoadedScene& on_profile, std::string_view profile, int figure) {
    ProfileCost cost;
    cost.profile = profile;
    try {
        const shadow::Settings& settings = on_profile.settings;
        RenderJob job(on_profile.view(), settings);
        job.render();
        const FrameLedger whole = job.ledger(), l = of_figure(whole, figure);
        const auto ms = [&](std::uint64_t cycles) {
            return simulated_ms(cycles, settings.timing.clock_ns);
        };
        cost.claim = cost_claim(whole);
        cost.busiest = whole.bottleneck();
        cost.observer_ms = ms(FrameLedger::cycles(l.observer, true));
        cost.light_ms = ms(FrameLedger::cycles(l.light, true));
        cost.transformation_ms = ms(l.transformation(true));
        cost.filters_ms = ms(l.filters(true));
    } catch (const SceneError& error) {
        cost.refused = error.what();
    }
    return cost;
}

std::vector<ProfileCost> profile_costs(const LoadedScene& scene, int figure) {
    std::vector<ProfileCost> costs;
    LoadedScene on_profile = scene;
    for (const shadow::Profile& p : shadow::profiles_of_1978()) {
        on_profile.settings = scene.settings;
        shadow::apply(p, on_profile.settings);
        costs.push_back(profile_cost(on_profile, p.name, figure));
    }
    return costs;
}

std::vector<std::vector<std::string>> profile_rows(const std::vector<ProfileCost>& costs) {
    std::vector<std::vector<std::string>> rows{columns};
    for (const ProfileCost& c : costs) rows.push_back(cells(c));
    return rows;
}

std::string profile_table(const std::vector<ProfileCost>& costs) {
    return markdown_table(profile_rows(costs));
}

ordered_json to_json(const std::vector<ProfileCost>& costs) {
    ordered_json json = ordered_json::array();
    for (const ProfileCost& c : costs) {
        ordered_json row{{"profile", c.profile}};
        if (!c.refused.empty()) {
            row["refused"] = c.refused;
        } else {
            row["observer_ms"] = c.observer_ms;
            row["light_ms"] = c.light_ms;
            row["transformation_ms"] = c.transformation_ms;
            row["filters_ms"] = c.filters_ms;
            row["total_ms"] = c.total_ms();
            row["bottleneck"] = c.busiest;
            row["both_views_over_observer"] = c.claim.both_views;
            row["depth_complexity"] = c.claim.depth_complexity;
        }
        json.push_back(row);
    }
    return json;
}

}  // namespace umbra78::tools
