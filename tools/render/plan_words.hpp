// The words of a plan: what is left out, why, and from which stage.
#pragma once

#include "shadow/frame/costs.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace umbra78::tools {

// "light_map", as JSON has it, and "the light map" in a line of text.
std::string_view key_of(shadow::Omission);
std::string_view name_of(shadow::Omission);
std::string_view explain(shadow::Reason);
std::string_view key_of(shadow::FrameStage);
std::string_view name_of(shadow::FrameStage);

// The keys of what the frame before left in place: "same_light_map", ...
std::vector<std::string> kept(const shadow::FramePlan&);

std::string grouped(std::uint64_t);  // "12 345 678"

}  // namespace umbra78::tools
