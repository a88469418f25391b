#include "shadow/rivals/mesh.hpp"

#include <algorithm>

namespace umbra78::shadow::rivals {
namespace {

struct Pieces {
    std::span<Point> vertices, welded;
    std::span<std::uint32_t> order, number;
    std::span<Triangle> facets;
    std::span<Edge> edges;
    std::span<HalfEdge> half_edges;
    std::span<std::array<std::uint32_t, 3>> sides;
};

Pieces lay_out(Carver& carver, const MeshSize& size) {
    return {carver.take<Point>(size.vertices),
            carver.take<Point>(size.vertices),
            carver.take<std::uint32_t>(size.vertices),
            carver.take<std::uint32_t>(size.vertices),
            carver.take<Triangle>(size.facets),
            carver.take<Edge>(3 * size.facets),
            carver.take<HalfEdge>(3 * size.facets),
            carver.take<std::array<std::uint32_t, 3>>(size.facets)};
}

Triangle from(std::uint32_t first, const std::array<std::uint32_t, 3>& v) {
    return {{first + v[0], first + v[1], first + v[2]}};
}

}  // namespace

std::size_t MeshBuilder::bytes(const MeshSize& size) {
    Carver carver(static_cast<std::byte*>(nullptr));
    lay_out(carver, size);
    return carver.used();
}

MeshBuilder::MeshBuilder(std::span<std::byte> memory, const MeshSize& size) {
    Carver carver(memory);
    const Pieces p = lay_out(carver, size);
    fits_ = carver.fits();
    vertices_ = p.vertices;
    welded_ = p.welded;
    order_ = p.order;
    number_ = p.number;
    facets_ = p.facets;
    edges_ = p.edges;
    half_edges_ = p.half_edges;
    sides_ = p.sides;
}

bool MeshBuilder::room_for(std::size_t vertices, std::size_t facets) {
    needed_.vertices += vertices;
    needed_.facets += facets;
    fits_ = fits_ && needed_.vertices <= vertices_.size() && needed_.facets <= facets_.size();
    return fits_;
}

void MeshBuilder::add(const raster::Mesh& mesh, const ToWords& to) {
    if (!room_for(mesh.vertices.size(), mesh.facets.size())) return;
    const auto first = static_cast<std::uint32_t>(used_.vertices);
    for (const raster::World& v : mesh.vertices)
        in_range_ = to.point(v, vertices_[used_.vertices++]) && in_range_;
    for (const raster::Facet& f : mesh.facets)
        facets_[used_.facets++] = from(first, f.vertex);
}

void MeshBuilder::add(std::span<const Point> vertices, std::span<const Triangle> facets) {
    if (!room_for(vertices.size(), facets.size())) return;
    const auto first = static_cast<std::uint32_t>(used_.vertices);
    for (const Point& p : vertices) vertices_[used_.vertices++] = p;
    for (const Triangle& f : facets)
        facets_[used_.facets++] = from(first, f.vertex);
}

// Vertices of equal words become one, in the order of their words. A facet that has lost a vertex,
// as those at a sphere's poles, is left out.
void MeshBuilder::weld() {
    const auto order = order_.first(used_.vertices);
    for (std::size_t v = 0; v < order.size(); ++v) order[v] = static_cast<std::uint32_t>(v);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return vertices_[a] != vertices_[b] ? vertices_[a] < vertices_[b] : a < b;
    });
    std::size_t count = 0;
    for (const std::uint32_t v : order) {
        if (count == 0 || welded_[count - 1] != vertices_[v]) welded_[count++] = vertices_[v];
        number_[v] = static_cast<std::uint32_t>(count - 1);
    }
    used_.vertices = count;
    std::size_t kept = 0;
    for (Triangle f : facets_.first(used_.facets)) {
        for (std::uint32_t& v : f.vertex) v = number_[v];
        const auto [a, b, c] = f.vertex;
        if (a != b && b != c && c != a) facets_[kept++] = f;
    }
    used_.facets = kept;
}

// Sorts the facets' sides so that those of one edge follow each other. Returns how many edges.
std::size_t MeshBuilder::join_sides() {
    std::size_t sides = 0;
    for (std::uint32_t f = 0; f < used_.facets; ++f) {
        const auto& v = facets_[f].vertex;
        for (std::uint8_t k = 0; k < 3; ++k) {
            const std::uint32_t a = v[k], b = v[(k + 1) % 3];
            half_edges_[sides++] = {std::min(a, b), std::max(a, b), f, k, a < b};
        }
    }
    const auto half_edges = half_edges_.first(sides);
    std::sort(half_edges.begin(), half_edges.end(), [](const HalfEdge& a, const HalfEdge& b) {
        return a.low != b.low       ? a.low < b.low
               : a.high != b.high   ? a.high < b.high
               : a.facet != b.facet ? a.facet < b.facet
                                    : a.side < b.side;
    });
    std::size_t edges = 0;
    for (std::uint32_t h = 0; h < sides; ++h) {
        const HalfEdge& side = half_edges[h];
        const bool same = edges > 0 && edges_[edges - 1].low == side.low &&
                          edges_[edges - 1].high == side.high;
        if (!same) edges_[edges++] = {side.low, side.high, h, 0};
        ++edges_[edges - 1].count;
        sides_[side.facet][side.side] =
            static_cast<std::uint32_t>(2 * (edges - 1)) + (side.forward ? 0 : 1);
    }
    return edges;
}

MeshStatus MeshBuilder::finish(Mesh& out) {
    if (!fits_) return MeshStatus::no_room;
    if (!in_range_) return MeshStatus::too_wide;
    weld();
    const std::size_t edges = join_sides();
    out = {welded_.first(used_.vertices), facets_.first(used_.facets), edges_.first(edges),
           half_edges_.first(3 * used_.facets), sides_.first(used_.facets)};
    return MeshStatus::ok;
}

}  // namespace umbra78::shadow::rivals
