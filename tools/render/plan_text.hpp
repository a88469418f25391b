// A plan as text: the names of stages and omissions, and the reasons of decisions.
#pragma once

#include "shadow/frame/costs.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace umbra78::tools {

// key_of is the name in JSON ("light_map"), name_of the name in text ("the light's view"), which is
// another where a method has no map and draws the shadow itself.
std::string_view key_of(shadow::Omission);
std::string_view name_of(shadow::Omission, bool has_map = true);
std::string_view explain(shadow::Reason);
std::string_view key_of(shadow::FrameStage);
std::string_view name_of(shadow::FrameStage, bool has_map = true);

// The keys of what is kept from the frame before: "same_light_map", ...
std::vector<std::string> kept(const shadow::FramePlan&);

std::string grouped(std::uint64_t);  // "12 345 678"

}  // namespace umbra78::tools
