#include "tools/render/plan_report.hpp"

#include "tools/render/frame_warnings.hpp"
#include "tools/scene/view_keys.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <utility>

namespace umbra78::tools {

using nlohmann::ordered_json;
using shadow::FrameStage;
using shadow::Omission;

Planned::Planned(LoadedScene loaded)
    : scene(std::move(loaded)), job(scene.view(), scene.settings, Maps::for_shadows_alone) {
    const std::string_view refusal = shadow::method_of(job.inputs()).no_plan_cost;
    if (!refusal.empty()) throw SceneError(std::string(refusal));
    job.render();
    ledgers = job.ledgers();
    warnings = frame_warnings(scene, job, {});
}

std::string Decided::name(bool on_ground) const {
    const std::string_view of = name_of(omission, !on_ground);
    return lights.empty() ? std::string(of) : fmt::format("{}, {}", of, fmt::join(lights, " "));
}

std::vector<Decided> decided(const Planned& planned, Omission o) {
    const shadow::Scene& scene = planned.job.inputs().scene;
    if (scope_of(o) == shadow::Scope::frame || planned.lights() == 1)
        return {{o, planned.plan().at(o)}};
    std::vector<Decided> all;
    for (std::size_t s = 0; s < scene.sources_used(); ++s) {
        const shadow::Source source = scene.source(s);
        const std::string name = name_of_light(s, scene.sources_used());
        for (std::size_t k = 0; k < (scope_of(o) == shadow::Scope::source ? 1 : source.lights);
             ++k) {
            const shadow::Decision d = planned.plan().at(o, source.first_light + k);
            auto group = std::ranges::find_if(all, [&](const Decided& g) {
                return g.decision.left_out == d.left_out && g.decision.reason == d.reason;
            });
            if (group == all.end()) group = all.insert(group, {o, d});
            if (group->lights.empty() || group->lights.back() != name)
                group->lights.push_back(name);
        }
    }
    if (all.size() == 1) all.front().lights.clear();  // each light's
    return all;
}

ordered_json to_json(const Planned& planned) {
    const shadow::OutsideSurfaces& outside = planned.plan().outside;
    ordered_json json{{"size_px", planned.scene.settings.machine.size_px()},
                      {"patches", planned.scene.patches.size()},
                      {"triangles", planned.scene.facets.size()},
                      {"surfaces_outside_light", outside.light[0]},
                      {"surfaces_outside_observer", outside.observer},
                      {"visible_pixels", planned.ledger().visible},
                      {"visible_lines", planned.ledger().lines.visible},
                      {"shadow_lines", planned.ledger().lines.filtered.dequantize}};
    const shadow::FrameCycles cycles = planned.cycles();
    for (std::size_t k = 0; k < shadow::stage_count; ++k)
        json["stages"].push_back({{"stage", key_of(static_cast<FrameStage>(k))},
                                  {"cycles", cycles[k].total()},
                                  {"transform", cycles[k].transform},
                                  {"divide", cycles[k].divide},
                                  {"noise", cycles[k].noise},
                                  {"store", cycles[k].store},
                                  {"operations", cycles[k].operations.one_after_the_other()}});
    for (std::size_t k = 0; k < shadow::omission_count; ++k) {
        const auto o = static_cast<Omission>(k);
        const shadow::Saving s = planned.saving(o);
        bool first = true;
        for (const Decided& d : decided(planned, o)) {
            ordered_json& row = json["omissions"].emplace_back();
            row["omission"] = key_of(o);
            if (!d.lights.empty()) row["lights"] = d.lights;
            row["left_out"] = d.decision.left_out;
            row["why"] = explain(d.decision.reason);
            row["saved_cycles"] = first ? s.cycles : 0;  // of all lights, in the first row
            row["after_drawing"] = s.after_drawing;
            first = false;
        }
    }
    json["cycles"] = total(cycles);
    json["cycles_of_everything"] = planned.everything();
    json["saved_cycles"] = planned.everything() - total(cycles);
    json["cycle_ns"] = planned.scene.settings.timing.clock_ns;
    json["warnings"] = tools::to_json(planned.warnings);
    return json;
}

}  // namespace umbra78::tools
