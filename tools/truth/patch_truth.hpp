// The shadow of bicubic patches, for which there is no closed form: traced by Embree.
//
// Every patch is cut into cells x cells quads of two triangles, in double precision. Embree's rays
// are in single precision: they say which triangle is met; the point itself is then found on the
// patch in double precision by Newton's steps from there. A shadow ray starts off the surface, on
// the side seen, by what the triangles may depart from their patches (h^2 / 8 of the second
// derivatives, the greatest of all patches) and 2^-20 of the scene's reach for the rounding of
// single precision; nearer than that nothing stands in its way.
//
// Surfaces are two-sided, as the machine shades them: a normal points toward the viewer, which on a
// closed surface seen from outside is outward.
#pragma once

#include "raster/scene.hpp"
#include "tools/truth/truth.hpp"

#include <optional>
#include <span>

namespace umbra78::tools {

inline constexpr int default_patch_cells = 64;

struct PatchTruth {
    Truth truth;             // `surface` is the patch's place among the patches
    double estimated_error;  // the share of pixels that answer otherwise with half as many cells
    double shadow_offset;    // where shadow rays start off the surface, world units
};

// cells >= 2. Nothing where the program is built without Embree.
std::optional<PatchTruth> trace_patches(std::span<const raster::Patch>, const TruthView&,
                                        const TruthLight&, int cells = default_patch_cells);

// Whether it is built with Embree.
bool traces_patches();

}  // namespace umbra78::tools
