#include "raster/facet_batch.hpp"

#include <algorithm>

namespace umbra78::raster {
namespace {

static_assert(FacetWalk::run == leaves);

WideVector minus(const hw::Words& a, const hw::Words& b) {
    return {std::int64_t{a.x} - b.x, std::int64_t{a.y} - b.y, std::int64_t{a.z} - b.z};
}

// The sign of v . own for the facet's own rounded unit normal `own` along g, and 0 where it could
// be either. Each component of own is rounded by less than 0.51, so where v . g is 33 or more for
// each unit of |g|, v . own is 2^19 or more, for a v of 2^14. Then means of such vectors by weights
// of 1024, of which one may be -1, have that sign, too.
int sure_sign(const WideVector& v, const WideVector& g) {
    const auto magnitude = [](std::int64_t k) { return k < 0 ? -k : k; };
    const std::int64_t least = 33 * (magnitude(g[0]) + magnitude(g[1]) + magnitude(g[2]));
    const std::int64_t along = dot(v, g);
    return along >= least ? 1 : along <= -least ? -1 : 0;
}

// Unit vectors as their rounding leaves them, each within 60 degrees of the others.
bool lie_together(const std::array<WideVector, 3>& n) {
    constexpr std::int64_t square = std::int64_t{1} << (2 * unit_fraction);
    for (std::size_t k = 0; k < 3; ++k) {
        if (dot(n[k], n[k]) < square - (1 << 18) || dot(n[k], n[k]) > square + (1 << 18))
            return false;
        if (dot(n[k], n[(k + 1) % 3]) < square / 2) return false;
    }
    return true;
}

}  // namespace

void SeenVertices::make(std::uint32_t group, FacetWalk& walk) {
    walk.see_run(group * size, vertex_[group % groups].data());
    group_[group % groups] = group;
}

bool find_facet_normals(const Mesh& mesh, const Facet& facet, WordFormat object,
                        const UnitVector& viewer, const TriangleBatch& batch, std::size_t slot,
                        FacetNormals& out) {
    if (batch.area[slot] >= std::int64_t{1} << 56) return false;  // the lanes cut to 24 of 56 bits
    std::array<WideVector, 3> n{};
    std::array<hw::Words, 3> place{};
    for (std::size_t k = 0; k < 3; ++k) {
        if (facet.normal[k] == Facet::flat) return false;
        n[k] = wide(mesh.normals[facet.normal[k]]);
        place[k] = to_object_words(mesh.vertices[facet.vertex[k]], object);
    }
    const WideVector own = cross(minus(place[1], place[0]), minus(place[2], place[0]));
    const int side = sure_sign(n[0], own), seen = sure_sign(wide(viewer), own);
    if (side == 0 || seen == 0 || sure_sign(n[1], own) != side || sure_sign(n[2], own) != side ||
        !lie_together(n))
        return false;
    if (batch.exchanged[slot] != 0) std::swap(n[1], n[2]);
    const std::int64_t turned = side == seen ? 1 : -1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto word = [&](std::int64_t v) { return static_cast<std::int32_t>(turned * v); };
        out.base[axis][slot] = word(1024 * n[0][axis]);
        out.to_b[axis][slot] = word(n[1][axis] - n[0][axis]);
        out.to_c[axis][slot] = word(n[2][axis] - n[0][axis]);
    }
    return true;
}

}  // namespace umbra78::raster
