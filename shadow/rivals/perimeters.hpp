// Class 2 by footprints (Crow 1977, section VI): the facets in their order from the light, each
// clipped by the footprints of those before it. What is inside a footprint is dark.
//
// A fragment of which something stays lit joins the footprints, with its whole outline: what of the
// outline is dark is inside earlier footprints, so it darkens nothing more. A fragment that is
// wholly dark does not join. The order answers which of two is before the other, so no line where
// planes meet is needed here; the order has cut what needed it. Boxes are compared first, and
// facets that lie in one plane do not shadow each other.
#pragma once

#include "shadow/rivals/footprint_pairs.hpp"
#include "shadow/rivals/light_order.hpp"
#include "shadow/rivals/split.hpp"

#include <cstdint>

namespace umbra78::shadow::rivals {

struct PerimeterCounts {
    std::uint64_t fragments = 0;  // in the order
    std::uint64_t joined = 0;     // of them, that are footprints
    std::uint64_t edges = 0;      // lines of the footprints
    std::uint64_t compared = 0;   // pairs of a fragment and a footprint, past boxes and planes
    std::uint64_t pairs = 0;      // of these, of two footprints merged
    CasterCounts casters;         // of the given casters, so far
    CutCounts cuts;
};

// `order` was made with `lines`. All its fragments are clipped, whoever sees them. Where both
// facets of a pair have become footprints, were not cut by the order, and are before a fragment,
// they clip it as one; `pairs` may have none.
PieceStatus clip_by_perimeters(LightLines& lines, Casters& casters, LightOrder& order,
                               FootprintPairs& pairs, LitPart& lit_part, PieceStore& out,
                               PerimeterCounts& counts);

}  // namespace umbra78::shadow::rivals
