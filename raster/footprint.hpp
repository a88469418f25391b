// Footprint: the pixels and Z codes that the samples of a block, or of a whole patch, can have.
//
// It follows from the bounds of X, Y and Z that the block rule uses (block_rule.hpp). It holds
// every sample, and usually more than the samples reach.
#pragma once

#include "hw/band.hpp"
#include "raster/projection.hpp"
#include "raster/scene.hpp"

#include <cstdint>

namespace umbra78::raster {

struct Footprint {
    int x0, y0, x1, y1;              // pixels of the frame, both ends inclusive
    std::uint32_t nearest, farthest;  // Z codes, both ends inclusive
};

Footprint whole_frame(const MachineSpec& spec);

// Of what has these bounds and is not `outside` for the block rule. X and Y: from the pixel that
// holds the lower bound less the sampling's slack to the one that holds the upper bound plus it,
// clamped to the frame. Z: a quantum beyond the bounds, because rounding moves the corners that
// are computed; 0 or the deepest code drawn where that is outside the volume.
Footprint footprint(const ScreenBounds& bounds, const MachineSpec& spec);

// Its lines in a band alone.
constexpr Footprint clipped(Footprint f, const hw::Band& band) {
    if (f.y0 < band.first) f.y0 = band.first;
    if (f.y1 >= band.end) f.y1 = band.end - 1;
    return f;
}

// Of a whole patch in a view whose loaded matrix is `matrix`. `out` is set unless the patch is
// outside; where its bounds are unknown it is the whole frame.
Visibility patch_footprint(const Patch& patch, const MatrixWords& matrix, const MachineSpec& spec,
                           WordFormat object, Footprint& out);

}  // namespace umbra78::raster
