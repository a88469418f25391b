// The observer and the light of a scene file, read into views. What is left out is fitted to the
// control points of all patches. After an error a view is not to be used.
#pragma once

#include "tools/scene/toml_text.hpp"
#include "tools/scene/view_fit.hpp"

namespace umbra78::tools {

// [observer]; if it is left out, a view from the front that shows the whole scene.
raster::View read_observer(const TomlNode& root, Patches, FirstError&);

// [light]: its kind "directional" makes an orthographic view, "point" a perspective one.
raster::View read_light(const TomlNode& root, Patches, FirstError&);

// Moves the overrides observer.KEY and light.KEY into the tree, in place of what the file says.
// Returns the others, the settings, as a table.
TomlNode apply_view_overrides(TomlNode& root, std::span<const std::string> overrides,
                              FirstError&);

}  // namespace umbra78::tools
