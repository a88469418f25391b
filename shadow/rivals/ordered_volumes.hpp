// Shadow volumes as Crow scans them ("Shadow Algorithms for Computer Graphics", 1977, section
// VII): along each line of pixels the sides that are open are kept in the order of their depth,
// and with them the place of the visible surface among them. The sum of what the sides before it
// change, and the count at the eye, is the number of surfaces between its point and the light.
//
// The order changes where a side begins or ends, where two neighbours pass through each other, and
// where another facet is seen; between such columns no pixel is asked. Only neighbours can change
// places, and only the sides next to the visible surface can come before it or behind it. So for
// each neighbour the first column at which it changes places is known, exactly: two planes change
// their order once in a line of pixels, if at all. What is found at each column is checked there
// and not supposed, and the mask is that of brute force.
//
// Crow supposes that the sides of one light never meet. They do: along rays of the light where two
// contour edges cross in its picture. Each such place is counted (`swaps`).
#pragma once

#include "shadow/rivals/volumes.hpp"

#include <cstdint>
#include <span>

namespace umbra78::shadow::rivals {

struct OrderedCounts {
    std::uint64_t facets = 0, edges = 0;  // classified
    std::uint64_t contour = 0;            // edges with a side
    std::uint64_t sides = 0;              // that are not seen edge-on
    std::uint64_t start_tests = 0;        // of facets, for the count at the eye
    std::uint64_t lines = 0;              // of pixels, on which something is seen
    std::uint64_t rows = 0;               // of sides on them
    std::uint64_t sorts = 0;              // compares of their first columns
    std::uint64_t inserts = 0;            // into the list of open sides
    std::uint64_t compares = 0;           // of two sides at a pixel
    std::uint64_t swaps = 0;              // of two that were in order before
    std::uint64_t asked = 0;              // of a side and the visible surface at a pixel
    std::uint64_t foreseen = 0;           // of neighbours, at the last pixel that both may have
    std::uint64_t crossings = 0;          // of them, where they change places before it
    std::uint64_t stretches = 0;          // of pixels with one answer
    std::uint64_t pixels = 0;             // that show something
    std::uint64_t longest = 0;            // the list
    // Where another facet comes to be seen: how often; the sides that are open there; and those
    // that are compared with it.
    std::uint64_t changes = 0, open_at_changes = 0, asked_at_changes = 0;
    std::uint64_t bytes = 0;  // that suffice
};

// `surfaces` as of count_volumes(). False, with counts.bytes, if `memory`, aligned to
// frame_alignment, is too small.
bool order_volumes(const Setting& setting, std::span<const std::uint32_t> shown,
                   std::span<const ContourEdge> contour, std::span<std::byte> memory,
                   std::span<std::int32_t> surfaces, OrderedCounts& counts);

}  // namespace umbra78::shadow::rivals
