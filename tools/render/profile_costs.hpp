// What one frame costs on each profile's machine, as a table.
#pragma once

#include "tools/render/cycle_report.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace umbra78::tools {

struct LoadedScene;

// The milliseconds of one frame on one profile's machine.
struct ProfileCost {
    std::string profile;
    std::string refused;  // why the profile cannot draw the scene, or empty
    double observer_ms = 0, light_ms = 0, transformation_ms = 0, filters_ms = 0;
    std::string busiest;  // the bottleneck of the transformation
    CostClaim claim{};
    double total_ms() const { return observer_ms + light_ms + transformation_ms + filters_ms; }
};
// Of a scene whose settings are the profile's already.
ProfileCost profile_cost(const LoadedScene& on_profile, std::string_view profile, int figure = 6);
std::vector<ProfileCost> profile_costs(const LoadedScene& scene, int figure = 6);

std::string profile_table(const std::vector<ProfileCost>&);  // Markdown
// The rows of that table, the heading first.
std::vector<std::vector<std::string>> profile_rows(const std::vector<ProfileCost>&);
nlohmann::ordered_json to_json(const std::vector<ProfileCost>&);

}  // namespace umbra78::tools
