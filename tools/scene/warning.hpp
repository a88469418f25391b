// What the user of a scene or of a frame should know: a line each, with the measured figure and
// the remedy.
#pragma once

#include <string>
#include <vector>

namespace umbra78::tools {

struct Warning {
    std::string key;      // "near_plane": what kind of warning it is, for programs
    double measured = 0;  // the figure in the line; its unit is the line's
    std::string line;     // what is wrong, how much, and the remedy
};

using Warnings = std::vector<Warning>;

}  // namespace umbra78::tools
