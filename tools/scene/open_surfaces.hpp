// Surfaces with an open border: what is not a closed shell.
#pragma once

#include "raster/scene.hpp"

#include <cstdint>

namespace umbra78::tools {

// How many patches and facets have a border that no other surface has: four control points of a
// patch, in either direction, or two corners of a facet. A border of one place alone counts for
// none. A patch's border that is a facet's side is open.
std::uint64_t open_surfaces(const raster::Surfaces&);

}  // namespace umbra78::tools
