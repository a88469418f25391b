// The solids of a scene file: [[torus]], [[cylinder]], [[cone]], [[box]], and [[triangle]].
#pragma once

#include "tools/scene/materials.hpp"
#include "tools/scene/scene.hpp"

namespace umbra78::tools {

// Appends the solids' patches to the free ones and the triangles to the mesh. After an error they
// are not to be used.
void read_solids(const TomlNode& root, const MaterialNames&, LoadedScene&, FirstError&);

}  // namespace umbra78::tools
