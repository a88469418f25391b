// The observer and the light of a scene file: views in words, fitted where nothing is given.
#pragma once

#include "tools/scene/toml_text.hpp"
#include "tools/scene/view_fit.hpp"

namespace umbra78::tools {

// [observer]: where it is left out, a view from the front that shows the whole scene.
raster::View read_observer(const TomlNode& root, Patches);

// [light]: of kind "directional" an orthographic view, of kind "point" a perspective one.
raster::View read_light(const TomlNode& root, Patches);

// Moves the values of --set observer.KEY and light.KEY into the tree; returns the others, the
// settings, as a table.
TomlNode apply_view_overrides(TomlNode& root, std::span<const std::string> overrides);

}  // namespace umbra78::tools
