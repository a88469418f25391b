// What sorting a pixel into its sector costs beside the post-process, in operations
// (hw/operations.hpp): section 25's row of hw/MACHINE.md.
#pragma once

#include "hw/operations.hpp"

namespace umbra78::shadow::cost {

// Three magnitudes, two compares between them and one with 0.
inline constexpr hw::Operations sector_pixel{6, 0, 0, 0, 0, 0};

}  // namespace umbra78::shadow::cost
