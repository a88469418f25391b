// The header shadow/frame/paper_scene_words.hpp: the figures' scene file in the machine's words.
//
// The core has no reader of scene files, so its copy of the scene is generated and committed.
#pragma once

#include "tools/scene/scene_file.hpp"

#include <string>

namespace umbra78::tools {

// The header's text. Throws SceneError if the scene has what the header has no words for: other
// surfaces than spheres of one material, views other than two of one cube at elevation 0 with
// azimuths of whole degrees, or a setting that the figures do not set.
std::string paper_scene_words(const LoadedScene& scene);

}  // namespace umbra78::tools
