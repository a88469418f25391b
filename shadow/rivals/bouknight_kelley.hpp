// Shadows found while the picture is scanned out, by a second scan: Bouknight & Kelley 1970, as
// Crow 1977 describes it in section V.
//
// The main scan gives the runs of the visible facet of each row. For a run on facet R the edges
// of the facets linked to R (links.hpp) are projected from the light on R's plane and cut by the
// row's plane. Where a linked facet begins to lie before R's points a counter is raised, where it
// ends it is lowered; the crossings are sorted by column, and from one to the next the tone is
// one: lit if the counter is 0.
//
// In the first form every edge of a linked facet is projected, and the facet's own plane, which
// parts what is before the point from what is behind. A crossing is where three planes meet, not
// rounded; its column is the first pixel whose sign is changed. A facet that hides the run's first
// pixel is in the counter from the start.
//
// In the second form, Crow's advice, only borders are projected (borders.hpp): contour edges, and
// facets that pass through R's plane. Such a crossing does not say what the number is, only how it
// changes, so at the run's first pixel it is counted by brute force over R's links.
#pragma once

#include "shadow/rivals/borders.hpp"

#include <cstdint>
#include <span>

namespace umbra78::shadow::rivals {

// In a row: from this column on the counter is changed.
struct CounterChange {
    int column;
    std::int32_t change;
};

// Sorts by column; returns how many were compared. Equal columns may stand in any order.
std::uint64_t sort_changes(std::span<CounterChange> changes);

struct ScanOutCounts {
    std::uint64_t runs = 0;          // of the main scan
    std::uint64_t lit_runs = 0;      // of facets whose seen side is lit: the second scan's
    std::uint64_t casters = 0;       // linked facets, or borders, taken up on a run
    std::uint64_t edges = 0;         // projected on the visible facet, and cut by the row
    std::uint64_t planes = 0;        // of facets, likewise
    std::uint64_t crossings = 0;     // in the lists that are sorted
    std::uint64_t compares = 0;      // of the sort
    std::uint64_t start_facets = 0;  // asked for the count at a run's first pixel (second form)
    std::uint64_t stopped = 0;       // runs given up when nothing of them was lit any more
    std::uint64_t tones = 0;         // pieces of one tone that the second scan put out
    std::uint64_t longest = 0;       // list of crossings
};

struct ScanOutOptions {
    // First form: a shadow at an end of the run shortens what is asked of the next casters, and a
    // run that is wholly dark asks no more.
    bool stop_when_dark = true;
};

// False if `room` is too small for a run's list of crossings: counts.longest is what it needs, and
// the mask is not complete. Twice the longest list of links, or once that of borders, is enough.
// `borders` may be null: the first form.
bool bouknight_kelley(const Setting& setting, std::span<const std::uint32_t> shown,
                      const Links& links, const Borders* borders, const ScanOutOptions& options,
                      std::span<CounterChange> room, std::span<std::uint8_t> mask,
                      ScanOutCounts& counts);

}  // namespace umbra78::shadow::rivals
