// What a frame needs, what its plan leaves out, why, and the cycles that this saves: what
// `umbra78 plan` prints.
#pragma once

#include "tools/render/plan_text.hpp"
#include "tools/render/render_job.hpp"
#include "tools/scene/scene_file.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace umbra78::tools {

// The frame is drawn, because some counts are known only afterwards.
struct Planned {
    LoadedScene scene;
    RenderJob job;
    std::vector<shadow::FrameLedger> ledgers;  // by light
    Warnings warnings;

    explicit Planned(LoadedScene);  // throws SceneError
    Planned(const Planned&) = delete;
    Planned& operator=(const Planned&) = delete;

    const shadow::FramePlan& plan() const { return job.plan(); }
    const shadow::FrameLedger& ledger() const { return ledgers.front(); }
    std::size_t lights() const { return ledgers.size(); }
    bool on_ground() const { return ledger().on_ground; }
    shadow::DrawnFrame drawn() const { return {job.inputs(), ledgers}; }
    shadow::Saving saving(shadow::Omission o) const { return shadow::saving(o, plan(), drawn()); }
    shadow::FrameCycles cycles() const { return cycles_of(plan(), drawn()); }
    std::uint64_t everything() const { return total(cycles_of(shadow::FramePlan{}, drawn())); }
};

// An omission and why, for all lights that have the same reason.
struct Decided {
    shadow::Omission omission;
    shadow::Decision decision;
    std::vector<std::string> lights{};  // empty: for the frame, or for each of its lights

    std::string name(bool on_ground) const;
};

std::vector<Decided> decided(const Planned&, shadow::Omission);

nlohmann::ordered_json to_json(const Planned&);

}  // namespace umbra78::tools
