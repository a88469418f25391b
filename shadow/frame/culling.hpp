// Culling: which surfaces lie outside a view, and whether a shadow can fall on what is seen, found
// before anything is drawn.
//
// A patch's bounds in a view (the block rule's own; of a diced one DicedView's), and a facet's
// corners, hold every sample that it can give. In the observer's view they make a box of input
// words for the transform unit. A row's rounded result, and a quotient of two rows with a positive
// divisor, takes its min and max at corners of the box; so eight points show whether anything in
// the box can come into the light's volume. The answer is never an estimate: what cannot be decided
// counts as reached.
#pragma once

#include "shadow/frame/inputs.hpp"

#include <cstddef>
#include <cstdint>

namespace umbra78::shadow {

struct Reach {
    std::uint64_t outside_light = 0, outside_observer = 0;  // patches and facets
    bool into_light = false;  // something the observer may see may lie in the light's volume
};

// For one light.
Reach cull(const FrameInputs&, std::size_t light);

}  // namespace umbra78::shadow
