// The cycle ledger as text and JSON: of a frame, of its post-process, and the table of profiles.
#pragma once

#include "shadow/frame/paper_figures.hpp"
#include "tools/render/render_job.hpp"

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace umbra78::tools {

struct LoadedScene;

const char* name_of(shadow::Unit);

// Phase by phase: each unit's cycles, and the phase's side by side and one after the other.
std::string print_frame(const shadow::FrameLedger&, int clock_ns);
// Stage by stage: work, blocked and by whom, held, idle; the bottleneck.
std::string print_post_process(const shadow::PostProcessLedger&, int clock_ns);

nlohmann::ordered_json to_json(const shadow::FrameLedger&, int clock_ns);

// What the paper says of the cost, in this frame: "roughly twice" the rendering, "plus a fixed
// transformation".
struct CostClaim {
    double both_views;      // of the observer's view: about 2, less the light's shading
    double transformation;  // of the observer's view
    double depth_complexity;  // samples drawn for each visible pixel, observer's view
};
CostClaim cost_claim(const shadow::FrameLedger&);

// A frame's ledger without the phases a figure of the paper does not need: 1 and 2 are a view each,
// 3 and 4 have no filters, 5 is not laid on a picture.
shadow::FrameLedger of_figure(shadow::FrameLedger, int figure);

}  // namespace umbra78::tools
