// The AP-120B's ledger of a frame, as text and JSON. Transfers and calls stand apart.
#pragma once

#include "shadow/ap120b/cost.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace umbra78::tools {

std::string print(const shadow::ArrayCost&, int clock_ns);  // a line a step
nlohmann::ordered_json to_json(const shadow::ArrayCost&, int clock_ns);

}  // namespace umbra78::tools
