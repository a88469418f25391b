#include "tools/scene/open_surfaces.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <tuple>
#include <vector>

namespace umbra78::tools {
namespace {

using raster::World;

auto key(const World& p) { return std::tuple(p.x, p.y, p.z); }

// The same for both directions.
using Border = std::vector<World>;
struct Less {
    bool operator()(const Border& a, const Border& b) const {
        return std::ranges::lexicographical_compare(a, b, {}, key, key);
    }
};

Border border(Border b) {
    Border reversed(b.rbegin(), b.rend());
    return Less{}(reversed, b) ? reversed : b;
}

bool is_a_place(const Border& b) {
    return std::ranges::all_of(b, [&](const World& p) { return p == b.front(); });
}

std::vector<Border> borders_of(const raster::Patch& patch) {
    std::vector<Border> all;
    for (const auto& [from, step] : {std::pair{0u, 1u}, {12u, 1u}, {0u, 4u}, {3u, 4u}}) {
        Border b;
        for (unsigned k = 0; k < 4; ++k) b.push_back(patch.control[from + k * step]);
        all.push_back(border(b));
    }
    return all;
}

std::vector<Border> borders_of(const raster::Mesh& mesh, const raster::Facet& facet) {
    std::vector<Border> all;
    for (std::size_t k = 0; k < 3; ++k)
        all.push_back(border({mesh.vertices[facet.vertex[k]],
                              mesh.vertices[facet.vertex[(k + 1) % 3]]}));
    return all;
}

}  // namespace

std::uint64_t open_surfaces(const raster::Surfaces& surfaces) {
    std::vector<std::vector<Border>> of;
    for (const raster::Patch& patch : surfaces.patches) of.push_back(borders_of(patch));
    for (const raster::Facet& facet : surfaces.mesh.facets)
        of.push_back(borders_of(surfaces.mesh, facet));
    std::map<Border, int, Less> uses;
    for (const auto& borders : of)
        for (const Border& b : borders) ++uses[b];
    return static_cast<std::uint64_t>(std::ranges::count_if(of, [&](const auto& borders) {
        return std::ranges::any_of(
            borders, [&](const Border& b) { return !is_a_place(b) && uses[b] == 1; });
    }));
}

}  // namespace umbra78::tools
