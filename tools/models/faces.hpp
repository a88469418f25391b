// The faces of a file's polygons as a model's facets, of its numbered points and normals.
#pragma once

#include "tools/models/model.hpp"

#include <span>
#include <vector>

namespace umbra78::tools {

// A polygon has at most this many corners: ears are looked for in a time of its square.
inline constexpr std::size_t most_corners = 1024;

// Numbers from 0 in the file's order, of points and normals that are there.
struct FaceCorner {
    std::uint32_t vertex = 0, normal = raster::Facet::flat;
};

// Appends a face's triangles, with the file's numbers; those without area are counted. A face whose
// corners do not all name a normal has none.
void append_face(std::span<const FaceCorner>, const std::vector<ModelPoint>& points, ModelData&);

// Takes those points and normals of the file that facets name into the model, in the file's order,
// and renumbers the facets.
void keep_used_points(const std::vector<ModelPoint>& points, const std::vector<ModelPoint>& normals,
                      ModelData&);

}  // namespace umbra78::tools
