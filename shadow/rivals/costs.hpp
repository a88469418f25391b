// What a rival takes, in operations of the machine's units (hw/operations.hpp): its counts times
// what each thing costs in words of 16 bits (f = 7 at 9 bits of X and Y), with wider products in
// several passes. The table is section 8 of RIVALS.md.
//
// What is seen is the observer's store, which has been drawn, and what it takes is the drawing's.
#pragma once

#include "raster/drawing_cost.hpp"
#include "shadow/rivals/brute.hpp"
#include "shadow/rivals/volumes.hpp"

namespace umbra78::shadow::rivals {

namespace cost {

using hw::Operations;

// Two differences of places, their product, and the offset: six products of a pass, three of two.
inline constexpr Operations plane{11, 9, 12, 0, 0, 0};
// On which side of a plane a place lies.
inline constexpr Operations plane_side{3, 3, 6, 0, 0, 0};
inline constexpr Operations facet_side = plane + plane_side;
inline constexpr Operations edge_multiplicity{2, 0, 0, 0, 0, 0};
// A facet that may lie before a point: the values of four planes.
inline constexpr Operations asked_facet = 4 * plane_side;
// A side of a volume is filled as a triangle is: three lines bound it, and its depth steps.
inline constexpr Operations side_setup = raster::cost::triangle_setup;
inline constexpr Operations side_row = raster::cost::triangle_line;
inline constexpr Operations side_pixel{3, 0, 0, 0, 0, 1};     // its depth steps; the compare
inline constexpr Operations count_update{1, 0, 0, 0, 0, 2};
inline constexpr Operations read_pixel{0, 0, 0, 0, 0, 1};
inline constexpr Operations masked_pixel{0, 0, 0, 0, 0, 2};   // the count read, the mask written

}  // namespace cost

// Once for a scene and a light; and for each frame of an observer.
struct Work {
    hw::Operations once{}, frame{};
};

// `pixels` of the frame, of which each has its mask written.
inline Work work_of(const BruteCounts& c, const Mesh& mesh, std::uint64_t pixels) {
    return {mesh.facets.size() * cost::facet_side + mesh.edges.size() * cost::plane,
            pixels * cost::masked_pixel + c.points * cost::read_pixel +
                c.facets * cost::asked_facet};
}

inline Work work_of(const VolumeCounts& c, std::uint64_t pixels) {
    return {c.facets * cost::facet_side + c.edges * cost::edge_multiplicity,
            pixels * cost::masked_pixel + c.start_tests * cost::asked_facet +
                c.sides * cost::side_setup + c.rows * cost::side_row +
                c.fills * cost::side_pixel + c.updates * cost::count_update};
}

}  // namespace umbra78::shadow::rivals
