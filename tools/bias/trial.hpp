// The least bias by experiment: a plane is drawn into a depth map of a format, texel by texel, and
// compared with itself at points all over the middle of it, in integers (depth_format.hpp).
//
// The bias is put on the caster's side before it is stored, as the raster stages of all interfaces
// do: depth + constant r + slope m. A normal offset moves the point along the normal before it is
// looked up. No point may be in false shadow, at any tap.
#pragma once

#include "tools/bias/need.hpp"

#include <optional>

namespace umbra78::tools::bias {

// In the units of the interfaces. Nothing: none suffices up to the search's end.
struct Found {
    std::optional<int> constant;  // of r
    // Beside a constant of 1, in steps of 1/64: of m = max(|zx|, |zy|); of texels.
    std::optional<double> slope, normal;
};
Found experiment(const MapSetup&);

}  // namespace umbra78::tools::bias
