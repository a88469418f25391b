// Shadow volumes counted in a frame store, fragment by fragment (Heidmann 1991; z-fail: Bilodeau
// & Songy 1999; Everitt & Kilgard 2002). The third class as graphics machines have it: its depths
// are the store's Z codes.
//
// Each polygon of the volumes is drawn against the codes of what is seen, and where it passes its
// weight is added to a counter in the store: 1 if the eye's ray enters a volume there, -1 if it
// leaves one, m times that for a side on an edge of multiplicity m.
//
//   z-pass  begins with the number of volumes in which the eye is, and adds the weights of the
//           sides with code < the seen one's;
//   z-fail  begins with 0, and takes away the weights of all that has code >= the seen one's: the
//           sides, the facets, which are the near ends of their volumes, and the far ends.
//
// In a closed volume the weights along a ray and the count at the eye add up to 0, so that both
// have the same sum in every pixel, whatever the codes are. A facet never has a code below the seen
// one's, since a plane's code is one function of its depth; so z-pass draws no facets.
//
// Sides have no end, so a far end lies infinitely far: it covers the pixels whose rays end in the
// volume. Of a light at a place those are the pixels that the cone behind the facet covers; of a
// direction, only rays parallel to it end in a volume.
//
// Where a side and what is seen have codes that are equal, or rounded to the wrong order, the count
// is not that of the polygons. Those pixels are this method's error. Attached shadow has none.
#pragma once

#include "shadow/rivals/depth_code.hpp"
#include "shadow/rivals/volumes.hpp"

#include <cstdint>
#include <span>

namespace umbra78::shadow::rivals {

enum class StencilPass : std::uint8_t { z_pass, z_fail };

struct StencilOptions {
    StencilPass pass = StencilPass::z_pass;
    int counter_bits = 16;  // 1..16; it wraps
};

struct StencilCounts {
    std::uint64_t facets = 0, edges = 0;  // classified
    std::uint64_t contour = 0;            // edges with a side
    std::uint64_t sides = 0;              // that are not seen edge-on
    std::uint64_t near_ends = 0, far_ends = 0;  // drawn
    std::uint64_t rows = 0;               // of all these: three crossings each, four of a far end
    std::uint64_t fills = 0;              // their pixels
    std::uint64_t updates = 0;            // of the counter
    std::uint64_t start_tests = 0;        // of facets, for the count at the eye
    std::uint64_t end_tests = 0;          // of facets, for rays that end in their volumes
};

// The store: a code and a counter, below 2^counter_bits, a pixel. Each has space.pixels() numbers.
struct StencilStore {
    std::span<std::uint32_t> codes;
    std::span<std::int32_t> counters;
};

// The counters are 0 where nothing is seen; mask_of_counts() makes a mask of them.
void count_stencil(const Setting& setting, std::span<const std::uint32_t> shown,
                   std::span<const ContourEdge> contour, const DepthScale& scale,
                   const StencilOptions& options, const StencilStore& store,
                   StencilCounts& counts);

}  // namespace umbra78::shadow::rivals
