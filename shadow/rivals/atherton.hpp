// Class 2 after Atherton, Weiler & Greenberg 1978, "Polygon Shadow Generation" (SIGGRAPH 78): what
// is lit of a facet is a polygon, concave and with holes, from which the outlines of the facets
// before it are taken away. The second pass draws the polygons.
//
// The paper takes the polygons by their distance from the light, and the nearest one is the
// template by which all others are clipped; where that rough order was wrong the other polygon
// becomes the template within the first. A template is always a polygon's original outline, so what
// is left of one does not hang on the others. So here each facet is taken by itself, its casters
// by their distance; where the rough order was wrong the test of planes has told so. Where the two
// planes cross, the template is the part of the outline that is before the facet. The method is in
// atherton.md.
#pragma once

#include "shadow/rivals/casters.hpp"
#include "shadow/rivals/loops.hpp"
#include "shadow/rivals/split.hpp"

#include <cstdint>
#include <span>

namespace umbra78::shadow::rivals {

struct AthertonCounts {
    std::uint64_t receivers = 0;  // facets that were clipped
    std::uint64_t all_dark = 0;   // of them, that were left before all casters had been tried
    std::uint64_t sorting = 0;    // compares of the rough order: casters, times their number's bits
    std::uint64_t wrong = 0;      // casters that the rough order has behind what they shadow
    std::uint64_t loops = 0;      // that were left
    std::uint64_t sides = 0;      // of them
    std::uint64_t longest = 0;    // sides of a loop
    CasterCounts casters;
    ClipCounts clips;
};

struct ListedCaster {
    std::int64_t depth;
    std::uint32_t facet;
    Before before;
};

// Of the loops that are left of all facets, in the order of the facets.
using LoopStore = LoopList;

// `wanted` may be empty: then all facets are clipped that turn a side to the light. `room` has a
// place for each facet.
PieceStatus clip_by_outlines(LightLines& lines, Casters& casters,
                             std::span<const std::uint8_t> wanted, std::span<ListedCaster> room,
                             LoopClip& lit_part, LoopStore& out, AthertonCounts& counts);

// Sides of the facet that has the most: what mask_of_loops needs room for.
std::size_t most_sides(const LoopStore& store);

struct LoopMaskCounts {
    std::uint64_t loops = 0;      // that were drawn, of facets that are seen and not attached
    std::uint64_t sides = 0;      // asked for each row of their facets
    std::uint64_t crossings = 0;  // of a side and a row
    std::uint64_t pixels = 0;     // that are lit
};

// The mask: a pixel is lit if it is within the loops of the facet that it shows, which they go
// around an odd number of times. `room` has at least most_sides(store) lines, `flips` one more than
// a row has pixels; false if they have less.
bool mask_of_loops(const LightLines& lines, const LoopStore& store,
                   std::span<const std::uint32_t> shown, std::span<ShownLine> room,
                   std::span<std::uint8_t> flips, std::span<std::uint8_t> mask,
                   LoopMaskCounts& counts);

}  // namespace umbra78::shadow::rivals
