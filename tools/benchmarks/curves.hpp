// How a frame's time grows: `tools/bench --curves [POWER]`.
#pragma once

#include <string>

namespace umbra78::tools {

// Over the pixels, the facets up to 10^power, the surfaces behind one another, the lights, and for
// each rival of the depth map the facets: the processor's time of a frame, as rows of a CSV file,
// and the slope of each curve on logarithmic axes. Slope 1 is linear.
int measure_curves(int power, const std::string& csv);

}  // namespace umbra78::tools
