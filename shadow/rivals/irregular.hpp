// The alias-free shadow map (Johnson, Mark & Burns 2004, "The irregular Z-buffer and its
// application to shadow mapping", and 2005 in hardware; Aila & Laine 2004, "Alias-free shadow
// maps").
//
// A depth map samples the light's picture at the centres of its texels, which are not where the
// visible points are. Here each visible point's own place in the light's picture is the sample.
// The points are kept in lists, one a texel of a grid over the picture; every facet is scanned
// over the texels that its box touches, and each point listed there that is still lit and whose
// place is in the box is asked whether the facet shadows it. That is asked of the exact plane
// (pencil.hpp), so the mask equals brute force at every size of the grid; the grid decides only
// what it costs.
//
// A place is rounded down as LightPicture rounds it, and a box is closed, so no point that a facet
// shadows is left out.
#pragma once

#include "shadow/rivals/brute.hpp"

#include <cstdint>
#include <span>

namespace umbra78::shadow::rivals {

// A visible point whose seen side is lit.
struct IrregularSample {
    std::int64_t u, v;    // its place
    std::uint32_t pixel;  // row by row
    std::uint32_t next;   // of its texel
};

struct IrregularOptions {
    int texels = 256;  // the grid's side on a face: a power of two, 1 .. 4096
};

struct IrregularCounts {
    std::uint64_t samples = 0;
    std::uint64_t texels = 0;         // of all faces
    std::uint64_t texels_filled = 0;  // that have a sample
    std::uint64_t longest = 0;        // list
    std::uint64_t facet_texels = 0;   // texels that facets were scanned over
    std::uint64_t visits = 0;         // of a sample in such a texel
    std::uint64_t facets_asked = 0;   // for a sample: the place is in the box
    std::uint64_t bytes = 0;          // of the lists
};

// `mask` as of brute(). False if the memory is too small; counts.bytes is what it takes.
bool irregular(const Setting& setting, std::span<const std::uint32_t> shown,
               const IrregularOptions& options, std::span<std::byte> memory,
               std::span<std::uint8_t> mask, IrregularCounts& counts);

}  // namespace umbra78::shadow::rivals
