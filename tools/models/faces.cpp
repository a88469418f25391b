#include "tools/models/faces.hpp"

#include "tools/models/polygon.hpp"

namespace umbra78::tools {
namespace {

using raster::Facet;

void keep_used(const std::vector<ModelPoint>& all, std::array<std::uint32_t, 3> Facet::*names,
               std::vector<Facet>& facets, std::vector<ModelPoint>& kept) {
    std::vector<std::uint32_t> place(all.size(), Facet::flat);
    for (const Facet& facet : facets)
        for (const std::uint32_t n : facet.*names)
            if (n != Facet::flat) place[n] = 0;
    for (std::size_t k = 0; k < all.size(); ++k) {
        if (place[k] == Facet::flat) continue;
        place[k] = static_cast<std::uint32_t>(kept.size());
        kept.push_back(all[k]);
    }
    for (Facet& facet : facets)
        for (std::uint32_t& n : facet.*names)
            if (n != Facet::flat) n = place[n];
}

}  // namespace

void append_face(std::span<const FaceCorner> face, const std::vector<ModelPoint>& points,
                 ModelData& model) {
    std::vector<ModelPoint> corners;
    bool smooth = true;
    for (const FaceCorner& corner : face) {
        corners.push_back(points[corner.vertex]);
        smooth = smooth && corner.normal != Facet::flat;
    }
    for (const auto& [a, b, c] : triangulate(corners)) {
        if (without_area(corners[a], corners[b], corners[c])) {
            ++model.no_area;
            continue;
        }
        Facet facet;
        for (std::size_t k = 0; k < 3; ++k) {
            const FaceCorner& corner = face[std::array{a, b, c}[k]];
            facet.vertex[k] = corner.vertex;
            if (smooth) facet.normal[k] = corner.normal;
        }
        model.facets.push_back(facet);
    }
}

void keep_used_points(const std::vector<ModelPoint>& points, const std::vector<ModelPoint>& normals,
                      ModelData& model) {
    keep_used(points, &Facet::vertex, model.facets, model.vertices);
    keep_used(normals, &Facet::normal, model.facets, model.normals);
}

}  // namespace umbra78::tools
