// Fitting a view to what it must hold: the control points and vertices of
// all surfaces, by exact comparisons.
#pragma once

#include "raster/view.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace umbra78::tools {

using raster::Surfaces;

// The middle of the points' box, rounded down, so that it moves with the points;
// the origin where there are none.
raster::World box_centre(const Surfaces&);

// The least extent, rounded up, whose window holds every point: orthographic, or in
// perspective by the points' places at the target's depth. A perspective window is at most four
// distances wide (76 degrees to either side), so what is beside or behind the eye stays outside.
std::int32_t fitted_extent(const raster::View&, const Surfaces&);

// Patches and facets with a point outside a view's window, or outside its near .. far.
struct Outside {
    std::size_t window = 0, depth = 0;
};
Outside count_outside(const raster::View&, const Surfaces&);

}  // namespace umbra78::tools
