// What the planar shadow costs beside its drawing, in operations (hw/MACHINE.md, section 26).
#pragma once

#include "hw/operations.hpp"

namespace umbra78::shadow::cost {

using hw::Operations;

// A sample of the observer's view writes a light's mask with its record.
inline constexpr Operations mask_with_record{0, 0, 0, 0, 0, 1};

}  // namespace umbra78::shadow::cost
