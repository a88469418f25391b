// "did you mean ...?": the known name nearest to a misspelt one.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace umbra78::tools {

// The fewest letters to insert, delete, replace or swap with a neighbour to turn a into b.
int edit_distance(std::string_view a, std::string_view b);

// "did you mean 'radius'?" if a known name is near, else "known here: centre, material, radius".
std::string suggest(std::string_view word, std::span<const std::string_view> known);

}  // namespace umbra78::tools
