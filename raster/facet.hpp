// Facets: the triangles of a mesh on their way to the screen, and their shading there
// (hw/MACHINE.md, section 21).
//
//   vertices --transform unit--> places in the view --clip to the guard band--> a convex polygon
//   --divide in perspective--> corners in raster units --fan--> triangles (triangle.hpp)
//
// The guard band is far wider than the frame, so that only what reaches far out of the picture, to
// the eye or out of the depth range is cut. Where an edge is cut depends on its two ends alone, so
// facets that share an edge are cut at the same place and leave no crack.
//
// A facet is shaded at the pixel's centre, by its corners' normals weighted by nearness (Phong
// 1975), or by its own normal if it is flat. Which side is seen is the facet's own side.
// The machine keeps no vertices: those that facets share are transformed for each facet anew, and
// are costed so. The host keeps the last ones, which changes no bit.
#pragma once

#include "raster/facet_form.hpp"
#include "raster/footprint.hpp"
#include "raster/projection.hpp"
#include "raster/shading.hpp"
#include "raster/triangle.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace umbra78::raster {

struct FacetVertex {
    ScreenPlace screen{};  // affine: raster units and 1; perspective: X, Y, Z, W
    WideVector world{};    // object words with guard bits
    WideVector normal{};   // Q1.14
};

// |X| <= limit[0] W and so on; W is 1 where the view is affine.
using GuardBand = std::array<std::int64_t, 3>;
inline constexpr std::int64_t guard_px = 1 << 14;
GuardBand guard_band(const MachineSpec& spec, bool affine);

// Three vertices, and one more for each of the six planes that may cut them.
struct FacetPolygon {
    std::array<FacetVertex, 9> vertex;
    std::size_t count = 0;

    // Cuts it to the guard band: near and far, then left, right, top and bottom. False if nothing
    // is left. `cut` says whether a vertex lay outside.
    bool clip(const GuardBand& band, bool& cut);
};

// A triangle of a polygon. It refers to the polygon's vertices.
struct FacetTriangle {
    std::array<const FacetVertex*, 3> vertex;
    std::array<Corner, 3> screen;
};

// A triangle's shading. What it refers to outlives it.
class FacetShading {
public:
    // `facet`: the three vertices as the mesh gives them. `flat`: the facet has no normals.
    FacetShading(const FacetTriangle& triangle, const std::array<WideVector, 3>& facet, bool flat,
                 const ShadingSpec& spec, const Material& material)
        : triangle_(triangle), facet_(facet), flat_(flat), spec_(spec), material_(material) {}

    // At a covered pixel's centre.
    Shades shade(const Sample& s, Shadowed shadowed) const;
    // What the store keeps of every sample: the facet's own normal.
    UnitVector normal(const Sample&) const;

private:
    using Weights = std::array<std::int64_t, 3>;  // of 1024
    Weights weights(const Sample& s) const;
    Shades shade_sample(const Sample& s, Shadowed shadowed, bool to_points) const;
    const UnitVector& side() const;

    const FacetTriangle& triangle_;
    const std::array<WideVector, 3>& facet_;
    bool flat_;
    const ShadingSpec& spec_;
    const Material& material_;
    mutable bool has_side_ = false, has_lit_ = false;
    mutable UnitVector side_{};  // the facet's own normal, made when it is needed
    mutable Shades lit_{};       // where all samples are alike: a flat facet, nothing at a point
};

// Everything of a facet but its samples.
class FacetWalk {
public:
    // `form`: another than the fastest.
    FacetWalk(const MachineSpec& spec, const MatrixWords& matrix, WordFormat object,
              hw::UnitWork work, bool shades, const FacetForm* form = nullptr);

    // Before the facets of another mesh.
    void begin(const Mesh& mesh);

    enum class Outcome : std::uint8_t { ready, cut, outside, unresolved };
    Outcome project(const Facet& facet);

    // Of the facet that was projected last, if it is ready or cut:
    bool footprint(Footprint& out) const;  // false if it lies outside the cube
    // The mesh's vertices from `first` on, 16 or as many as there are. One without a corner counts
    // as beyond the guard band. A facet of which all lie in the cube is neither cut nor unseen.
    static constexpr std::uint32_t run = 16;
    void see_run(std::uint32_t first, SeenVertex* out);
    // Whether a facet with this outcome has no sample in the view.
    bool unseen(Outcome outcome) const {
        Footprint f;
        return outcome == Outcome::outside || (outcome <= Outcome::cut && !footprint(f));
    }
    std::size_t triangles() const { return polygon_.count - 2; }
    FacetTriangle triangle(std::size_t k) const;
    const std::array<WideVector, 3>& facet() const { return facet_; }

private:
    // A vertex in the view, as far as it does not depend on its facet.
    struct Seen {
        std::uint32_t number, mesh;  // which vertex of which mesh; 0 is none
        unsigned outside;            // planes of the band
        bool has_corner;
        Corner corner;
        ScreenPlace screen;
        WideVector world;
    };
    const Seen& see(std::uint32_t number);
    SeenVertex corner_of(std::uint32_t number);
    bool make_job();
    void fill(const Facet& facet, std::size_t k, const Seen& seen);
    bool to_corner(const ScreenPlace& place, Corner& out) const;

    MachineSpec spec_;
    hw::TransformUnit unit_;
    WordFormat object_;
    bool shades_;
    GuardBand band_;
    const FacetForm& form_;
    VertexJob job_{};
    bool by_lanes_;  // whether the job covers the view
    FacetPolygon polygon_;
    std::array<Corner, 9> corner_{};
    std::array<WideVector, 3> facet_{};
    Mesh mesh_;
    // The host keeps what it has transformed last: neighbouring facets share vertices.
    std::array<Seen, 64> seen_{};
    std::uint32_t mesh_number_ = 0;
};

}  // namespace umbra78::raster
