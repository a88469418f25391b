// The [[model]] tables of a scene file: surfaces from files of their own.
#pragma once

#include "raster/placing.hpp"
#include "tools/scene/materials.hpp"
#include "tools/scene/scene.hpp"

namespace umbra78::tools {

// Reads every [[model]], and its file by way of `files`: appends its patches to the free ones and
// its triangles to the mesh, and warns of what was left out. After an error they are not to be
// used.
void read_models(const TomlNode& root, const MaterialNames&, const FileSource& files, LoadedScene&,
                 FirstError&);

// The key `turn`, or no turn.
raster::Turn read_turn(const TableReader&);

}  // namespace umbra78::tools
