// The cycle ledger of a frame and of its post-process, as text and JSON.
//
// Side by side: a phase takes as long as its busiest unit. One by one: as long as all its units
// after each other.
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

const char* name_of(shadow::PostProcessUnit);

// A line a phase: each unit's cycles, and the phase's, side by side and one by one.
std::string print_frame(const shadow::FrameLedger&, int clock_ns);
// A line a stage: work, blocked and by which stage, held, idle; and the bottleneck.
std::string print_post_process(const shadow::PostProcessLedger&, int clock_ns);

nlohmann::ordered_json to_json(const shadow::FrameLedger&, int clock_ns);

// What the paper says about the cost, measured in this frame: shadows take "roughly twice" the
// rendering, "plus a fixed transformation".
struct CostClaim {
    double both_views;        // cycles of both views over those of the observer's view
    double transformation;    // cycles of the transformation over those of the observer's view
    double depth_complexity;  // samples drawn for each visible pixel, observer's view
};
CostClaim cost_claim(const shadow::FrameLedger&);

// A frame's ledger without the phases that a figure of the paper does not need: figures 1 and 2 are
// one view each, 3 and 4 have no filters, 5 has no composite.
shadow::FrameLedger of_figure(shadow::FrameLedger, int figure);

}  // namespace umbra78::tools
