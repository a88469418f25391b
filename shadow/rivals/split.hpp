// Crow's second class: two passes in object space. The first by splitting (Crow 1977, "Shadow
// Algorithms for Computer Graphics", section VI, after Sutherland 1973): each facet is cut by the
// edges of those that can shadow it, projected from the light, into lit and dark pieces. The
// second pass draws the pieces; it may be repeated for any eye, and asks nothing of the light.
//
// For each facet R and each facet F before it (casters.hpp), each lit piece of R is cut by F's
// three lines and, where the two cross, by the line where their planes meet. What is outside a
// line stays lit and goes on to the next F; what is inside all of them is dark. If nothing is
// inside, the piece is left whole. No order of the facets is needed. The method is in
// object_space.md.
#pragma once

#include "shadow/rivals/casters.hpp"
#include "shadow/rivals/lit_part.hpp"

#include <cstdint>
#include <span>

namespace umbra78::shadow::rivals {

struct SplitCounts {
    std::uint64_t receivers = 0;  // facets that were cut
    std::uint64_t all_dark = 0;   // of them, that were left before all casters had been tried
    CasterCounts casters;
    CutCounts cuts;
};

enum class PieceStatus : std::uint8_t {
    ok,
    no_room,       // for pieces or lines of the store: its needed() is exact
    no_work_room,  // for one facet's pieces: LitPart's needed() is what would have let it go on
    no_meetings,   // for meeting lines: LightLines' meetings_needed() would have let it go on
};

// Which facets are to be cut: those that are seen and not attached. `wanted` has a flag for each.
void find_receivers(const Setting& setting, std::span<const std::uint32_t> shown,
                    std::span<std::uint8_t> wanted);

// `wanted` may be empty: then all facets are cut that turn a side to the light.
PieceStatus split(LightLines& lines, Casters& casters, std::span<const std::uint8_t> wanted,
                  LitPart& lit_part, PieceStore& out, SplitCounts& counts);

}  // namespace umbra78::shadow::rivals
