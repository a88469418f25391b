// A polygon in space cut into triangles, in exact integers.
//
// Newell's normal says along which axis the polygon is flattest; that coordinate is left out, and
// ears are cut from what is left (G. H. Meisters, Polygons have ears, American Mathematical
// Monthly 82, 1975): an ear is a corner that turns the polygon's way and whose triangle holds no
// other corner.
#pragma once

#include "tools/models/model.hpp"

#include <array>
#include <span>
#include <vector>

namespace umbra78::tools {

// The places in `corners` of each triangle's corners, in the polygon's sense of turning; n - 2
// triangles of n corners, of which those without area are not left out. Where no ear is found, as
// in a polygon that crosses itself, the next corner is cut off as if it were one.
std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const ModelPoint> corners);

// Whether the three points lie on a line.
bool without_area(const ModelPoint&, const ModelPoint&, const ModelPoint&);

}  // namespace umbra78::tools
