// Facets drawn many at a time by the forms of facet_form.hpp: what is kept between their steps.
//
//   facets --corners of a cache of vertices--> a batch --measure--> kinds of triangles
//     --few centres at once | tiles--> samples --those that the sink may take--> shaded at once
//
// Facets that are cut or that have a corner without a quotient are left to FacetWalk.
#pragma once

#include "raster/facet.hpp"
#include "raster/facet_form.hpp"
#include "raster/shade_job.hpp"
#include "raster/tile_walk.hpp"

#include <array>
#include <cstdint>

namespace umbra78::raster {

// The vertices seen last, in groups of 16 that follow each other in the mesh.
class SeenVertices {
public:
    void begin(const Mesh& mesh) {
        mesh_ = mesh;
        group_.fill(none);
    }
    const SeenVertex& see(std::uint32_t number, FacetWalk& walk) {
        fixed::require(number < mesh_.vertices.size(), "facet: no such vertex");
        const std::uint32_t group = number / size;
        if (group_[group % groups] != group) make(group, walk);
        return vertex_[group % groups][number % size];
    }

private:
    static constexpr std::uint32_t size = FacetWalk::run, groups = 64, none = UINT32_MAX;
    void make(std::uint32_t group, FacetWalk& walk);

    Mesh mesh_{};
    std::array<std::uint32_t, groups> group_{};
    std::array<std::array<SeenVertex, size>, groups> vertex_{};
};

struct FacetMemory {
    SeenVertices vertices;
    TriangleBatch batch;
    CentreList centres;
    FacetSamples samples;
    FacetNormals normals;
    LeafLevels levels;
    enum class Shading : std::uint8_t { unknown, lanes, plain };
    std::array<Shading, TriangleBatch::most> shading;  // of the batch's triangles
};

// Puts a facet's normals where the lanes find them, for the slot that its triangle has. False where
// they do not cover it: a flat facet, normals that are no unit vectors or 60 degrees apart, and
// sides that only the facet's own rounded normal could tell.
bool find_facet_normals(const Mesh& mesh, const Facet& facet, WordFormat object,
                        const UnitVector& viewer, const TriangleBatch& batch, std::size_t slot,
                        FacetNormals& out);

}  // namespace umbra78::raster
