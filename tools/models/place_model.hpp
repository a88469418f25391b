// A model at its place in the world: words of 32 fraction bits to world words
// (hw/MACHINE.md, section 20).
//
//   world word = place + half_even(scale x rotation x model word)
//
// The sum of products is exact, so each coordinate is rounded once.
#pragma once

#include "raster/placing.hpp"
#include "raster/shading.hpp"
#include "tools/io/first_error.hpp"
#include "tools/models/model.hpp"

#include <string>
#include <vector>

namespace umbra78::tools {

inline constexpr int scale_fraction = 48;

struct ModelPlacing {
    raster::Placing placing{};
    std::int64_t scale = std::int64_t{1} << scale_fraction;  // > 0, Q15.48
    bool z_up = false;   // the file's z points up: (x, y, z) counts as (x, z, -y)
    bool smooth = true;  // facets have the file's normals, or where it has none their vertices'
};

struct PlacedModel {
    std::vector<raster::Patch> patches;
    std::vector<raster::World> vertices;
    std::vector<raster::UnitVector> normals;
    std::vector<raster::Facet> facets;
};

// Reports the first point that leaves the world, -32767 .. 32767, by its line in the model's file,
// with `remedy`; then the placed model is not to be used. A vertex's normal is the sum of its
// facets' normals, each as long as twice the facet's area; a facet with a normal of no length is
// flat.
PlacedModel place_model(const ModelData&, const ModelPlacing&, const std::string& remedy,
                        FirstError&);

}  // namespace umbra78::tools
