// The bias study's section on depth maps of today beside the scene's own: the same half texel of
// bias with nearest lookup, and the least bias that each map needs.
#pragma once

#include "tools/study/study.hpp"

namespace umbra78::tools::study {

// A case for the scene's own map and for each map of today (shadow/frame/profiles.hpp), with the
// light's range as it is and 32 times as deep, which a light of parallel rays can have. In quick
// all maps are small.
std::vector<Case> map_cases(const Request&);

// A table of these cases' rows, and pictures of their stripes; nothing of no rows.
void report_maps(const Request&, std::span<const Row>, Report&);

}  // namespace umbra78::tools::study
