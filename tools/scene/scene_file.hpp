// Scene files for the program: read from a path, with a SceneError in place of a result's error.
//
// The reading itself is read_scene() of scene.hpp, which has no exceptions and no files.
#pragma once

#include "tools/scene/scene.hpp"
#include "tools/scene/scene_error.hpp"

#include <span>
#include <string>
#include <string_view>

namespace umbra78::tools {

// `overrides` are those of read_scene(). Both throw SceneError: for a scene that is wrong, and
// load_scene() for a file that cannot be read or is larger than 256 MiB. The models of a scene are
// files, which load_scene() finds from the scene's folder; parse_scene() asks `files` for them.
LoadedScene load_scene(const std::string& path, std::span<const std::string> overrides);
LoadedScene parse_scene(std::string_view text, const std::string& name,
                        std::span<const std::string> overrides, const FileSource& files = {});

// The same for a scene that may have a [stream], which the caller draws as it is read. `spool`: as
// open_packed() takes it.
LoadedScene load_streamed_scene(const std::string& path, std::span<const std::string> overrides,
                                bool spool);

// Throws SceneError for a scene with several depth maps or with colour. `what` looks at one light
// in grey: "umbra78 trace".
void require_one_light(const LoadedScene&, const std::string& what);

// The files that the scene at `path` names, which count from its folder.
FileSource files_beside(const std::string& path);

}  // namespace umbra78::tools
