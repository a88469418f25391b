// Whole frames beside the float frame: from triangles, and from patches in both samplings.
#pragma once

#include <string>
#include <vector>

namespace umbra78::tools {

// Registers them, and adds their names in the order of the table.
void add_frames(std::vector<std::string>& names);

}  // namespace umbra78::tools
