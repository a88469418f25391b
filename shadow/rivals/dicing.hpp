// The facets of a scene: its mesh, and its patches diced (hw/MACHINE.md, section 22) into 2^levels
// x 2^levels cells of two facets each, all alike, so that patches that share an edge share its
// words.
#pragma once

#include "raster/dice.hpp"
#include "shadow/rivals/mesh.hpp"

#include <cstddef>

namespace umbra78::shadow::rivals {

MeshSize diced_size(const raster::Surfaces& surfaces, int levels);
void add_diced(const raster::Surfaces& surfaces, int levels, const ToWords& to,
               raster::DiceMemory& memory, MeshBuilder& out);

}  // namespace umbra78::shadow::rivals
