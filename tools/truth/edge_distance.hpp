// How far the edges of the machine's shadow are from those of truth.
#pragma once

#include "tools/truth/metrics.hpp"

namespace umbra78::tools {

// Distances in pixels, NaN where either shadow has no edge. An edge is the pixels in shadow that
// have a lit 4-neighbour, where both truth and the machine see something. The distance of an edge
// pixel is that to the nearest pixel of the other edge. The pixels round acne (false shadow on a
// lit surface) are edge pixels, too, and count with their distance from a true edge.
struct EdgeDistance {
    double mean;       // over every pixel of both edges
    double hausdorff;  // the largest
};
EdgeDistance edge_distance(const Truth&, const MachineMask&,
                           std::span<const std::uint8_t> leave_out = {});

}  // namespace umbra78::tools
