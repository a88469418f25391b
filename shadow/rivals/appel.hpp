// Appel's quantitative invisibility, from the light, along the scan lines (Appel 1967, "The
// notion of quantitative invisibility and the machine rendering of solids", and 1968, "Some
// techniques for shading machine renderings of solids"; Crow 1977, section V).
//
// The quantitative invisibility of a point is the number of surfaces that hide it; here from the
// light, so that 0 is lit. It is counted by brute force at one point, the seed, and carried along
// the row of pixels; it changes where a border is passed (borders.hpp). From one facet to the next
// it is carried if the row goes through an edge that both share:
//
//   the edge is of these two facets alone and is no contour edge (multiplicity 0), both are seen
//   lit (so the edge's plane through the eye parts the two pixels), and where the row crosses it,
//   it is between the edge's ends.
//
// Then the borders on the first facet from its last pixel to the edge, and those on the second
// from the edge to its first pixel, are taken. In every other case the number does not survive,
// and is seeded anew: at the first lit facet after background or after an unlit one, where a facet
// begins before or behind another, at a contour edge, at a vertex between two pixels, and where a
// border falls on the shared edge itself.
#pragma once

#include "shadow/rivals/bouknight_kelley.hpp"

#include <cstdint>
#include <span>

namespace umbra78::shadow::rivals {

struct AppelCounts {
    std::uint64_t runs = 0;           // of facets whose seen side is lit
    std::uint64_t seeds = 0;          // all of them; the sum of the next five
    std::uint64_t first = 0;          // no number to carry: background, an unlit facet, the frame
    std::uint64_t not_joined = 0;     // the two facets share no edge of two facets
    std::uint64_t contour = 0;        // they do, and it is a contour edge
    std::uint64_t vertex = 0;         // it is not the edge that the row goes through
    std::uint64_t border_on_edge = 0; // a border falls on it
    std::uint64_t carried = 0;        // from facet to facet
    std::uint64_t seed_facets = 0;    // asked for the seeds
    std::uint64_t borders = 0;        // taken up, on runs and between them
    std::uint64_t crossings = 0;      // that change the number
    std::uint64_t compares = 0;       // of the sort
    std::uint64_t longest = 0;        // list of crossings of a run
};

struct AppelOptions {
    bool carry = true;  // from facet to facet; else each run is seeded
};

// `surfaces`: how many lie between each pixel's point and the light; 0 where nothing is seen and
// where the facet is attached. The seeds ask the facets of `grid`, or all if it is null. False if
// `room` is too small, as for bouknight_kelley; the longest list of borders is enough.
bool appel(const Setting& setting, std::span<const std::uint32_t> shown, const LightGrid* grid,
           const Borders& borders, const AppelOptions& options, std::span<CounterChange> room,
           std::span<std::int32_t> surfaces, AppelCounts& counts);

}  // namespace umbra78::shadow::rivals
