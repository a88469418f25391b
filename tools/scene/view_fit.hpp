// Fitting a view to what it must hold: the control points of all patches, by exact comparisons.
#pragma once

#include "raster/view.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace umbra78::tools {

using Patches = std::span<const raster::Patch>;

// The middle of the control points' box, rounded down, so that it moves with the points;
// the origin where there are none.
raster::World box_centre(Patches);

// The least extent, rounded up, whose window holds every control point: orthographic, or in
// perspective by the points' places at the target's depth. A perspective window is at most four
// distances wide (76 degrees to either side), so what is beside or behind the eye stays outside.
std::int32_t fitted_extent(const raster::View&, Patches);

// Patches with a control point outside a view's window, or outside its near .. far.
struct Outside {
    std::size_t window = 0, depth = 0;
};
Outside count_outside(const raster::View&, Patches);

}  // namespace umbra78::tools
