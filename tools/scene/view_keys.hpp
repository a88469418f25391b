// The keys that views have in common, read from a table of a scene file.
#pragma once

#include "raster/view.hpp"
#include "tools/scene/scene_points.hpp"
#include "tools/scene/table_reader.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace umbra78::tools {

// What a light is called in --set and in warnings: light, or light1 .. where there are several.
std::string name_of_light(std::size_t index, std::size_t lights);

// The tables [[light]] of a scene, or its one [light].
std::vector<const TomlNode*> light_nodes(const TomlNode& root);

// Reports a key that only another kind of view has. Where --set chose the kind, a key of the file
// is ignored.
void refuse(const TableReader&, std::string_view key, std::string_view kind_key,
            std::string_view needed);

void look_by_angles(const TableReader&, raster::View&);
void look_from_position(const TableReader&, raster::View&, const raster::World& origin);

// The window and the depth range, as given or fitted. The view's other members are read.
void fit_view(const TableReader&, raster::View&, ScenePoints&);

// A point as given, less the origin; left out, it is the middle of the scene.
raster::World read_target(const TableReader&, ScenePoints&, const raster::World& origin);

raster::World less(const raster::World&, const raster::World&);

}  // namespace umbra78::tools
