// Dicing: a patch as a mesh of k x k cells of two facets each (hw/MACHINE.md, section 22).
//
// In: a patch in world words, the most levels (k = 2^levels) and how far a facet may be from the
// patch. Out: a mesh in the caller's memory. A vertex is the exact Bernstein sum, rounded once, so
// it depends on its edge's control points alone where it lies on one: patches that share a border
// get the same words there, in either direction.
//
// A patch takes as few levels as its curvature allows, and so does each of its edges by itself. An
// edge with fewer levels than the patch keeps every second, fourth, ... vertex; the vertices
// between move to one of these. So patches of different levels share their border's vertices, and
// there is no crack.
// Not emulated: in what words a machine of 1978 would have evaluated the sums.
#pragma once

#include "raster/scene.hpp"
#include "raster/shading.hpp"

#include <array>
#include <cstdint>

namespace umbra78::raster {

inline constexpr int max_dice_levels = 5;
inline constexpr int max_dice_cells = 1 << max_dice_levels;

struct DiceMemory {
    static constexpr std::size_t side = max_dice_cells + 1;
    std::array<World, side * side> vertices;
    std::array<UnitVector, side * side> normals;
    std::array<Facet, 2 * max_dice_cells * max_dice_cells> facets;
};

struct DiceLevels {
    int patch = 0;
    std::array<int, 4> edge{};  // v = 0, v = 1, u = 0, u = 1
};

// The least levels, at most `most`, whose facets are within `tolerance` world words of the patch,
// component by component. A tolerance of 0 takes `most` wherever anything is curved.
DiceLevels dice_levels(const Patch& patch, int most, std::int64_t tolerance);

// `normals`: facets get those of their vertices; else they are flat.
Mesh dice(const Patch& patch, const DiceLevels& levels, bool normals, DiceMemory& memory);

}  // namespace umbra78::raster
