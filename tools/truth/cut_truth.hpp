// The truth of a scene as near and far cut it: what a machine that loses nothing else would draw.
#pragma once

#include "tools/truth/scene_truth.hpp"

namespace umbra78::tools {

// trace() of scene_truth.hpp, but truth sees only what lies within the observer's near .. far.
std::optional<SceneTruth> trace_within_depths(const LoadedScene&);

}  // namespace umbra78::tools
