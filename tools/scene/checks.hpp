// What stands in the way of a frame, and what a user should be told of before it is drawn.
#pragma once

#include "tools/scene/scene_file.hpp"

namespace umbra78::tools {

// Throws SceneError if the scene's matrices do not fit the machine's words.
void check_matrices(const LoadedScene&);

// Nothing drawn, a caster outside the light's volume, surfaces cut off by near and far.
std::vector<std::string> warnings_of(const LoadedScene&);

// One line for a frame that cannot be drawn, with the remedy; "" for ok.
std::string explain(shadow::FrameStatus);

}  // namespace umbra78::tools
