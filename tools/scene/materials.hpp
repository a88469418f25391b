// What all surfaces of a scene file share: tables of which there are many, and materials by name.
#pragma once

#include "tools/scene/table_reader.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace umbra78::tools {

using MaterialNames = std::vector<std::string>;

// The tables [[key]], of which there may be none.
std::span<const TomlNode> tables_of(const TomlNode& root, std::string_view key, FirstError&);

// Reads [[material]]; the material of surfaces that name none is appended to them.
MaterialNames read_materials(const TomlNode& root, std::vector<raster::Material>&, FirstError&);

// The number of a surface's material; that of the last one for a surface that names none.
std::uint16_t read_material(const TableReader&, const MaterialNames&);

}  // namespace umbra78::tools
