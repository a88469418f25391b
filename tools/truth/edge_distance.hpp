// How far the edges of the machine's shadow are from those of truth.
#pragma once

#include "tools/truth/metrics.hpp"

namespace umbra78::tools {

// In pixels. An edge is the pixels in shadow with a
// lit 4-neighbour, both seen by truth and the machine; each is as far from the other edge as its
// nearest pixel. NaN where either shadow has no edge. Acne is edge, too: it counts by its distance
// from a true one.
struct EdgeDistance {
    double mean;       // of every pixel of both edges
    double hausdorff;  // the greatest
};
EdgeDistance edge_distance(const Truth&, const MachineMask&,
                           std::span<const std::uint8_t> leave_out = {});

}  // namespace umbra78::tools
