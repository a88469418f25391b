// What stands still from one frame to the next: each buffer whose inputs are the same.
//
// A buffer depends on less than its view and all settings: the light map on the control points,
// the light's matrix words and the widths and roundings of drawing; the observer's Z on the same
// of the observer; its intensities on materials, ambient and both directions, too; the mask on
// both Z planes, the matrix between them and how it is looked up. What is compared is what is
// read: a view that moved by less than its words can tell has not moved.
#pragma once

#include "shadow/frame/inputs.hpp"

namespace umbra78::shadow {

struct Reuse {
    bool light_map = false;
    bool depth = false;     // the observer's Z
    bool observer = false;  // and its intensities
    bool mask = false;
    bool picture = false;   // and the masks after each filter
    constexpr bool operator==(const Reuse&) const = default;
};

Reuse find_reuse(const FrameInputs& before, const FrameInputs& now);

}  // namespace umbra78::shadow
