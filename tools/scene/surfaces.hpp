// The surfaces and materials of a scene file.
#pragma once

#include "tools/scene/scene.hpp"
#include "tools/scene/toml_text.hpp"

namespace umbra78::tools {

// Reads [[material]] and all surfaces into the scene's vectors, models by way of `files`. After an
// error they are not to be used.
void read_surfaces(const TomlNode& root, const FileSource& files, LoadedScene&, FirstError&);

// Takes `origin` from all places of the surfaces; the differences fit a word.
void take_origin(const raster::World& origin, LoadedScene&);

// Appends the patches of the spheres and planes, which come before the free ones.
void append_closed_forms(LoadedScene&);

// Makes the blob of each object but the ground, where there is one. False if one of them reaches
// out of the world; it is then left out.
bool make_blobs(LoadedScene& scene);

}  // namespace umbra78::tools
