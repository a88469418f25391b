// Models: surfaces read from files of their own, in exact words.
//
//   .bpt   Bezier patches: their number, then for each "3 3" and its 16 points
//   .bez   Geomview's Bezier patches: BBP or BEZ333, then 16 points a patch
//   .tea   Newell's tea set: the number of patches, 16 vertex numbers from 1 for each, the number
//          of vertices, their points
//   .obj   Wavefront: polygons, which become triangles, and bicubic surfaces
//   .stl   triangles, as text or binary; corners at the same place become one vertex
//   .ply   polygons, as text or binary
//
// A coordinate goes from its decimal, or from the bits of its binary number, to a word of 32
// fraction bits, half to even, and never passes through floating point. Points 0 .. 15 of a patch
// in a file are control points 0 .. 15. Nothing here needs exceptions or files.
#pragma once

#include "raster/scene.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace umbra78::tools {

inline constexpr int model_fraction = 32;
// Coordinates lie within this of 0, so that a triangle's doubled area fits 128 bits.
inline constexpr std::int64_t max_model = std::int64_t{1} << (20 + model_fraction);

struct ModelPoint {
    std::array<std::int64_t, 3> word{};  // x, y, z, of 32 fraction bits
    int line = 0;                        // of the file, or see ModelData::counted
    bool operator==(const ModelPoint& other) const { return word == other.word; }
};

using ModelPatch = std::array<ModelPoint, 16>;

struct ModelData {
    std::string name;          // the file's, for errors
    std::string_view counted;  // what a point's `line` counts in a binary file: "triangle"
    std::vector<ModelPatch> patches;
    std::vector<ModelPoint> vertices;
    std::vector<ModelPoint> normals;    // of any length; 0 is none
    std::vector<raster::Facet> facets;  // numbers of the vertices and normals above
    std::size_t no_area = 0;            // triangles without area, left out
    std::size_t lines_and_points = 0;   // elements that are no surface, left out
};

struct ModelResult {
    ModelData model;        // whole only if there is no error
    std::string error;  // one line: file and line, what is wrong, the remedy

    bool ok() const { return error.empty(); }
};

// Where a point stands, as an error begins: "a.obj:7", "a.stl: triangle 7".
std::string place_in(const ModelData&, int line);

// `name` is the file's; its ending says which format the text has.
ModelResult read_model(std::string_view text, const std::string& name);

}  // namespace umbra78::tools
