// Reuse: which buffers of the frame before are still right, because their inputs are the same.
//
// A buffer depends on less than its view and all settings. The light's map depends on the control
// points, the light's matrix words, and the widths and roundings of drawing; the observer's Z on
// the same of the observer. The intensities depend on materials, ambient and both directions too.
// The mask depends on both Z planes, the matrix between them, and how the map is looked up; and
// where normals are kept, which are drawn with the intensities, on those. Words
// are compared, and not the views they come from: a view that moved by less than its words resolve
// has not moved.
#pragma once

#include "shadow/frame/inputs.hpp"

#include <array>

namespace umbra78::shadow {

struct Reuse {
    std::array<bool, max_lights> light_map{}, mask{};
    bool depth = false;     // the observer's Z
    bool observer = false;  // and its intensities, and its normals if they are kept
    bool picture = false;   // and the masks after each filter
    constexpr bool operator==(const Reuse&) const = default;
};

Reuse find_reuse(const FrameInputs& before, const FrameInputs& now);

}  // namespace umbra78::shadow
