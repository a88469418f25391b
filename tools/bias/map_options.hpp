// A depth map as its measures are written: what `umbra78 bias` takes without a scene, and the
// module for Python.
#pragma once

#include "tools/bias/need.hpp"

#include <string>

namespace umbra78::tools::bias {

struct MapOptions {
    int map_px = 0;
    std::string extent, range, slope;  // "": not given
    std::string azimuth = "45", depth = "d16", filter = "nearest", z = "0.75", pixel;
    bool reversed = false;

    bool operator==(const MapOptions&) const = default;
};

// Throws SceneError: one line with the remedy.
MapSetup setup_of(const MapOptions&);

// What is wrong with a text as a number, a depth format, a filter; "" if nothing is.
std::string check_decimal(const std::string&);
std::string check_depth(const std::string&);
std::string check_filter(const std::string&);

}  // namespace umbra78::tools::bias
