// What figures 1 to 6 cost on each profile's machine.
#pragma once

#include "shadow/frame/paper_figures.hpp"
#include "tools/render/profile_costs.hpp"

#include <array>
#include <string>
#include <vector>

namespace umbra78::tools {

using FigureCosts = std::array<std::vector<ProfileCost>, shadow::figure_count>;

FigureCosts figure_costs();
std::string figure_table(const FigureCosts&);  // Markdown

}  // namespace umbra78::tools
