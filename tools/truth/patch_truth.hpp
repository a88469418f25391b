// The shadow of bicubic patches and of meshes, for which there is no closed form: traced by Embree.
//
// A mesh's facets are taken as they are; a ray meets the plane of one in double precision.
// Every patch is cut into cells x cells quads of two triangles, in double precision. Embree's rays,
// in single precision, find the triangle that is met; from there Newton's method finds the point on
// the patch itself, in double precision. A shadow ray starts off the surface, on the side seen.
// The start's distance from it is the largest distance of the triangles from their patches (h^2 / 8
// of the second derivatives, the maximum over all patches) plus 2^-20 of the scene's reach for the
// rounding of single precision. What is nearer than that casts no shadow.
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
// Embree takes about 110 bytes a triangle, so these are some 460 MB. Scenes of more than 512
// patches get fewer cells a patch: 5 for 60 000.
inline constexpr std::size_t max_patch_triangles = std::size_t{1} << 22;
// The cells a patch that so many patches get beside so many facets, at least 2.
int cells_within_budget(std::size_t patches, int cells, std::size_t facets = 0);

struct PatchTruth {
    Truth truth;             // `surface` is the patch's index; facets are numbered after patches
    double estimated_error;  // the share of pixels whose answer differs with half as many cells
    double shadow_offset;    // from the surface to where shadow rays start, world units
};

// cells >= 2; more than cells_within_budget() are cut to it. Nothing where the program is built
// without Embree, or where there is no memory for the triangles.
std::optional<PatchTruth> trace_patches(const raster::Surfaces&, const TruthView&,
                                        const TruthLight&, int cells = default_patch_cells);

// Whether it is built with Embree.
bool traces_patches();

}  // namespace umbra78::tools
