// The rivals' polygons: triangles with shared vertices in rival words, and their edges.
//
// Vertices of equal words are one. Facets are two-sided shells and their winding does not matter.
// A facet with two equal vertices is left out; one whose three vertices lie on a line has no
// inside, is never seen and casts nothing. Facets that share an edge see one plane through it,
// made from its lower vertex to its higher one, so that no point falls between them.
//
// Memory is the caller's. Whoever adds more than was planned gets a status and the counts needed.
#pragma once

#include "raster/scene.hpp"
#include "shadow/carver.hpp"
#include "shadow/rivals/planes.hpp"

#include <array>
#include <cstdint>
#include <span>

namespace umbra78::shadow::rivals {

struct Triangle {
    std::array<std::uint32_t, 3> vertex{};
};

// A facet's side of an edge: from vertex low to high if `forward`.
struct HalfEdge {
    std::uint32_t low, high, facet;
    std::uint8_t side;  // k: from the facet's vertex k to the next
    bool forward;
};

// An edge with its facets' sides: half_edges [first, first + count).
struct Edge {
    std::uint32_t low, high, first, count;
};

struct Mesh {
    std::span<const Point> vertices;
    std::span<const Triangle> facets;
    std::span<const Edge> edges;
    std::span<const HalfEdge> half_edges;
    // Of facet f and its side k: 2 edge + (0 if the side goes from low to high, else 1).
    std::span<const std::array<std::uint32_t, 3>> sides;

    std::array<Point, 3> corners(std::size_t facet) const {
        const auto& v = facets[facet].vertex;
        return {vertices[v[0]], vertices[v[1]], vertices[v[2]]};
    }
    Plane plane(std::size_t facet) const {
        const auto [a, b, c] = corners(facet);
        return plane_of(a, b, c);
    }
};

struct MeshSize {
    std::size_t vertices = 0, facets = 0;
    friend constexpr bool operator==(const MeshSize&, const MeshSize&) = default;
};

enum class MeshStatus : std::uint8_t {
    ok,
    no_room,   // of vertices, facets or bytes; `needed` says how many
    too_wide,  // a vertex is beyond max_word: the space was not fitted to these surfaces
};

class MeshBuilder {
public:
    static std::size_t bytes(const MeshSize& size);
    // `memory` is aligned to frame_alignment.
    MeshBuilder(std::span<std::byte> memory, const MeshSize& size);

    // Adds a mesh's facets. Several may be added.
    void add(const raster::Mesh& mesh, const ToWords& to);
    void add(std::span<const Point> vertices, std::span<const Triangle> facets);
    // Welds vertices, and makes the edges. `out` refers to the builder's memory.
    MeshStatus finish(Mesh& out);
    const MeshSize& needed() const { return needed_; }

private:
    bool room_for(std::size_t vertices, std::size_t facets);
    void weld();
    std::size_t join_sides();

    std::span<Point> vertices_, welded_;
    std::span<std::uint32_t> order_, number_;
    std::span<Triangle> facets_;
    std::span<Edge> edges_;
    std::span<HalfEdge> half_edges_;
    std::span<std::array<std::uint32_t, 3>> sides_;
    MeshSize needed_{}, used_{};
    bool fits_ = true, in_range_ = true;
};

}  // namespace umbra78::shadow::rivals
