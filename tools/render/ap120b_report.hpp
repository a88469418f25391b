// The cost of a frame on the AP-120B, as text and JSON. The host's transfers and library calls are
// not part of the sum and are printed apart.
#pragma once

#include "shadow/ap120b/cost.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace umbra78::tools {

std::string print(const shadow::ArrayCost&, int clock_ns);  // a line a step
nlohmann::ordered_json to_json(const shadow::ArrayCost&, int clock_ns);

}  // namespace umbra78::tools
