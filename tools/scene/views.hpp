// Reads the observer of a scene file into a view, and what all views say of the scene. A key that
// the file leaves out is fitted to the points of all surfaces. After an error a view is not to be
// used.
#pragma once

#include "tools/scene/scene_points.hpp"
#include "tools/scene/toml_text.hpp"

namespace umbra78::tools {

// The keys that a scene lacks whose stream is read once: "stream.largest, light.far".
std::string keys_left_out(const TomlNode& root);

// Tells the points which axes the views will have, as far as these are given by angles. What is
// wrong in them is reported later.
void expect_axes(const TomlNode& root, ScenePoints&);

// What is taken from all places of the scene: the observer's target, or 0 if observer.recentre is
// "off" or a point of a surface, the light's target or its position would leave -32766 .. 32766.
raster::World read_origin(const TomlNode& root, ScenePoints&, FirstError&);

// The origin is taken from the views' places; it has been taken from the surfaces.
// [observer]; if it is left out, a view from the front that shows the whole scene.
raster::View read_observer(const TomlNode& root, ScenePoints&, const raster::World& origin,
                           FirstError&);

}  // namespace umbra78::tools
