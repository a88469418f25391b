// Reach: where the patches of a scene may come to lie, before anything is drawn.
//
// A patch's bounds in a view, the block rule's own, hold every sample it can give; in the
// observer's view they make a box of input words for the unit. A row's result, rounded, or a
// quotient of two rows whose divisor is positive, is greatest and least at corners of the box, so
// eight points tell whether anything in it can come into the light's volume. Never an estimate:
// what cannot be told may be reached.
#pragma once

#include "shadow/frame/inputs.hpp"

#include <cstdint>

namespace umbra78::shadow {

struct Reach {
    std::uint64_t outside_light = 0, outside_observer = 0;  // patches left out whole
    bool into_light = false;  // what the observer may see may lie in the light's volume
};

Reach cull(const FrameInputs&);

}  // namespace umbra78::shadow
