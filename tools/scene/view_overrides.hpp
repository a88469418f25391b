// What --set changes in the views of a scene file.
#pragma once

#include "tools/scene/toml_text.hpp"

#include <span>
#include <string>

namespace umbra78::tools {

// Moves the overrides observer.KEY and light.KEY (of several lights: light2.KEY) into the tree, in
// place of what the file says.
// Returns the others, the settings, as a table.
TomlNode apply_view_overrides(TomlNode& root, std::span<const std::string> overrides,
                              FirstError&);

}  // namespace umbra78::tools
