// What one frame costs by each profile's machine, as a table.
#pragma once

#include "tools/render/cycle_report.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace umbra78::tools {

struct LoadedScene;

// The milliseconds of one frame by one profile's machine.
struct ProfileCost {
    std::string profile;
    std::string refused;  // why the profile cannot draw the scene, or empty
    double observer_ms = 0, light_ms = 0, transformation_ms = 0, filters_ms = 0;
    std::string busiest;  // the stage or unit that decides the transformation
    CostClaim claim{};
    double total_ms() const { return observer_ms + light_ms + transformation_ms + filters_ms; }
};
std::vector<ProfileCost> profile_costs(const LoadedScene& scene, int figure = 6);

std::string profile_table(const std::vector<ProfileCost>&);  // Markdown
// The rows of that table, its head first.
std::vector<std::vector<std::string>> profile_rows(const std::vector<ProfileCost>&);
nlohmann::ordered_json to_json(const std::vector<ProfileCost>&);

}  // namespace umbra78::tools
