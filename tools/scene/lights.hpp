// Reads the lights of a scene file: [light], or all [[light]].
#pragma once

#include "tools/scene/scene.hpp"
#include "tools/scene/scene_points.hpp"
#include "tools/scene/toml_text.hpp"

#include <vector>

namespace umbra78::tools {

// The kind "directional" makes an orthographic view, "point" a perspective one, "area" one for each
// light on it, "sectors" six. The origin is taken from the views' places. At least one, even after
// an error.
std::vector<SceneLight> read_lights(const TomlNode& root, ScenePoints&,
                                    const raster::World& origin, FirstError&);

}  // namespace umbra78::tools
