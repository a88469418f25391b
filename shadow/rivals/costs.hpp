// What a rival takes, in operations of the machine's units (hw/operations.hpp): its counts times
// what each thing costs in words of 16 bits (f = 7 at 9 bits of X and Y), with wider products in
// several passes. The table is section 8 of RIVALS.md.
//
// What is seen is the observer's store, which has been drawn, and what it takes is the drawing's.
#pragma once

#include "raster/drawing_cost.hpp"
#include "shadow/rivals/appel.hpp"
#include "shadow/rivals/atherton.hpp"
#include "shadow/rivals/bouknight_kelley.hpp"
#include "shadow/rivals/irregular.hpp"
#include "shadow/rivals/ordered_volumes.hpp"
#include "shadow/rivals/perimeters.hpp"
#include "shadow/rivals/split.hpp"
#include "shadow/rivals/stencil.hpp"
#include "shadow/rivals/volumes.hpp"

#include <bit>

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
// Which of two planes is nearer at a pixel: the values of both, each times the other's at the eye.
inline constexpr Operations depth_order{5, 6, 20, 0, 0, 0};
// A vertex in the light's picture: four products of a word and a direction.
inline constexpr Operations picture_place{2, 4, 4, 0, 0, 0};
inline constexpr Operations picture_facet = 3 * picture_place + Operations{12, 0, 0, 0, 0, 0};
inline constexpr Operations box_test{4, 0, 0, 0, 0, 1};
inline constexpr Operations depth_test{1, 0, 0, 0, 0, 0};
// Two planes meet in a line on the screen, and a row cuts it: eight products of 32 bits, a
// quotient.
inline constexpr Operations projected_edge{6, 8, 32, 1, 31, 0};
inline constexpr Operations listed_crossing{1, 0, 0, 0, 0, 2};  // written, read, the counter
inline constexpr Operations compare{1, 0, 0, 0, 0, 0};
inline constexpr Operations written_pixel{0, 0, 0, 0, 0, 1};
// A visible point in the light's picture, and into its texel's list.
inline constexpr Operations placed_sample = picture_place + Operations{2, 0, 0, 0, 0, 3};
// A visible point through the machine's own transform unit, and its code compared; in perspective
// with three quotients.
inline constexpr Operations moved_point{10, 9, 9, 0, 0, 3};
inline constexpr Operations divided_point{13, 12, 12, 3, 3 * 31, 3};
inline constexpr Operations scanned_texel{1, 0, 0, 0, 0, 1};
// The sign of three lines: a determinant of 3 x 3, of 32-bit words; with a meeting line, of 64.
inline constexpr Operations line_sign{5, 9, 36, 0, 0, 0};
inline constexpr Operations meeting_sign{5, 9, 144, 0, 0, 0};
// Where two lines of a piece meet: their product, two quotients, the box is widened.
inline constexpr Operations piece_corner{7, 6, 24, 2, 62, 0};
inline constexpr Operations cut_piece{0, 0, 0, 0, 0, 8};         // its lines are written again
inline constexpr Operations piece_row = 4 * projected_edge;      // its lines, cut by a row
inline constexpr Operations read_pixel{0, 0, 0, 0, 0, 1};
inline constexpr Operations masked_pixel{0, 0, 0, 0, 0, 2};   // the count read, the mask written

}  // namespace cost

// Once for a scene and a light; and for each frame of an observer. And what the method adds to the
// scene's entries: sides of volumes, links, borders, pieces or samples that it makes and keeps.
struct Work {
    hw::Operations once{}, frame{};
    std::uint64_t entries = 0;
};

// `pixels` of the frame, of which each has its mask written.
inline Work work_of(const BruteCounts& c, const Mesh& mesh, std::uint64_t pixels) {
    return {mesh.facets.size() * cost::facet_side + mesh.edges.size() * cost::plane,
            pixels * cost::masked_pixel + c.points * cost::read_pixel +
                c.facets * cost::asked_facet};
}

// `count` of side_setups: what is drawn of volumes.
inline hw::Operations drawn_volumes(std::uint64_t count, std::uint64_t rows, std::uint64_t fills,
                                    std::uint64_t updates) {
    return count * cost::side_setup + rows * cost::side_row + fills * cost::side_pixel +
           updates * cost::count_update;
}

inline Work work_of(const VolumeCounts& c, std::uint64_t pixels) {
    return {c.facets * cost::facet_side + c.edges * cost::edge_multiplicity,
            pixels * cost::masked_pixel + c.start_tests * cost::asked_facet +
                drawn_volumes(c.sides, c.rows, c.fills, c.updates),
            c.contour};
}

inline Work work_of(const OrderedCounts& c, std::uint64_t pixels) {
    return {c.facets * cost::facet_side + c.edges * cost::edge_multiplicity,
            pixels * cost::masked_pixel + c.start_tests * cost::asked_facet +
                drawn_volumes(c.sides, c.rows, 0, 0) + c.sorts * cost::compare +
                c.inserts * cost::listed_crossing +
                (c.compares + c.asked + c.foreseen) * cost::depth_order +
                c.crossings * cost::projected_edge,
            c.contour};
}

inline Work work_of(const StencilCounts& c, std::uint64_t pixels) {
    return {c.facets * cost::facet_side + c.edges * cost::edge_multiplicity,
            pixels * cost::masked_pixel + (c.start_tests + c.end_tests) * cost::asked_facet +
                drawn_volumes(c.sides + c.near_ends + c.far_ends, c.rows, c.fills, c.updates),
            c.contour + c.near_ends + c.far_ends};
}

// The links are made anew for each observer, since they are of what is seen.
inline hw::Operations link_operations(const LinkCounts& c, std::uint64_t facets) {
    return facets * cost::picture_facet + c.box_tests * cost::box_test +
           c.depth_tests * cost::depth_test + c.plane_tests * cost::plane_side;
}

inline Work work_of(const LinkCounts& links, const ScanOutCounts& c, const Mesh& mesh,
                    std::uint64_t pixels) {
    return {mesh.facets.size() * cost::facet_side + mesh.edges.size() * cost::plane,
            link_operations(links, mesh.facets.size()) + pixels * cost::written_pixel +
                (c.edges + c.planes) * cost::projected_edge +
                c.crossings * cost::listed_crossing + c.compares * cost::compare +
                c.start_facets * cost::asked_facet,
            links.links};
}

inline Work work_of(const LinkCounts& links, const BorderCounts& borders, const AppelCounts& c,
                    const Mesh& mesh, std::uint64_t pixels) {
    return {mesh.facets.size() * cost::facet_side +
                mesh.edges.size() * (cost::plane + cost::edge_multiplicity),
            link_operations(links, mesh.facets.size()) + borders.signs * cost::plane_side +
                borders.box_tests * cost::box_test + pixels * cost::written_pixel +
                c.seed_facets * cost::asked_facet + c.borders * cost::projected_edge +
                c.crossings * cost::listed_crossing + c.compares * cost::compare,
            links.links + borders.edges + borders.facets};
}

inline Work work_of(const IrregularCounts& c, const Mesh& mesh, std::uint64_t pixels) {
    return {mesh.facets.size() * (cost::facet_side + cost::picture_facet) +
                mesh.edges.size() * cost::plane,
            pixels * cost::written_pixel + c.samples * cost::placed_sample +
                c.facet_texels * cost::scanned_texel + c.visits * cost::box_test +
                c.facets_asked * cost::asked_facet,
            c.samples};
}

// The pieces of all facets serve every observer.
inline hw::Operations piece_operations(const CasterCounts& casters, const CutCounts& cuts) {
    return (casters.boxes + cuts.boxes) * cost::box_test +
           casters.planes * (6 * cost::plane_side) + cuts.footprints * cost::picture_facet +
           cuts.corners * cost::piece_corner +
           cuts.signs.edges * cost::line_sign + cuts.signs.meetings * cost::meeting_sign +
           cuts.cuts * cost::cut_piece;
}

inline Work work_of(const SplitCounts& c, const MaskCounts& mask, std::uint64_t pieces,
                    const Mesh& mesh, std::uint64_t pixels) {
    return {mesh.facets.size() * (cost::facet_side + cost::picture_facet) +
                mesh.edges.size() * cost::plane + piece_operations(c.casters, c.cuts),
            pixels * cost::written_pixel + mask.rows * cost::piece_row, pieces};
}

// The casters' counts of perimeters have the order's in them.
inline Work work_of(const OrderCounts& order, const PerimeterCounts& c, const MaskCounts& mask,
                    std::uint64_t pieces, const Mesh& mesh, std::uint64_t pixels) {
    const std::uint64_t facets = mesh.facets.size();
    return {facets * (cost::facet_side + cost::picture_facet + 3 * cost::plane_side) +
                facets * std::bit_width(facets) * cost::compare +
                mesh.edges.size() * cost::plane + piece_operations(c.casters, c.cuts) +
                piece_operations({}, order.cuts),
            pixels * cost::written_pixel + mask.rows * cost::piece_row, pieces};
}

// Each loop that is left of a clip is written again. A row of a facet is cut by all its sides.
inline Work work_of(const AthertonCounts& c, const LoopMaskCounts& mask, const Mesh& mesh,
                    std::uint64_t pixels) {
    const std::uint64_t facets = mesh.facets.size();
    const ClipCounts& clips = c.clips;
    const CutCounts signs{.cuts = clips.walks + clips.holes, .signs = clips.moved.signs};
    return {facets * (cost::facet_side + cost::picture_facet + 3 * cost::plane_side) +
                c.sorting * cost::compare + mesh.edges.size() * cost::plane +
                piece_operations(c.casters, signs),
            pixels * cost::written_pixel + mask.sides * cost::projected_edge +
                mask.crossings * cost::listed_crossing,
            c.loops};
}

}  // namespace umbra78::shadow::rivals
