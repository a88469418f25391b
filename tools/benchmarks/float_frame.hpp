// The float frame: the figures' four spheres as triangles, drawn from the observer and from the
// light, tested and darkened, as one would write it in plain floating point in an afternoon.
//
// It stands beside the integer machine's whole frames. It is no truth and no part of a figure.
#pragma once

#include "raster/scene.hpp"
#include "raster/view.hpp"
#include "tools/benchmarks/float_baseline.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace umbra78::tools {

// Spheres as the integer machine's mesh has them: 2 rings slices of `rings` stacks each.
struct SphereMesh {
    std::vector<raster::World> vertices;
    std::vector<std::array<std::int32_t, 3>> normals;
    std::vector<raster::Facet> facets;

    explicit SphereMesh(int rings);
    raster::Mesh mesh() const { return {vertices, normals, facets}; }
};

class FloatFrame {
public:
    explicit FloatFrame(const SphereMesh& mesh);
    void draw();
    // Pixels that the observer sees, and those of them in shadow.
    int visible() const;
    int shadowed() const;

private:
    using Vector = std::array<float, 3>;
    static constexpr int size = 512;

    void draw_view(const std::array<Vector, 3>& axes, bool shades,
                   std::vector<std::uint16_t>& codes);
    void draw_triangle(const std::array<std::uint32_t, 3>& vertex, bool shades);

    std::vector<Vector> points_, normals_, screen_;
    std::vector<std::array<std::uint32_t, 3>> triangles_;
    std::vector<float> light_, depth_, lambert_;  // by vertex, by pixel, by pixel
    std::vector<std::uint16_t> observer_, map_;
    std::vector<std::uint8_t> mask_, picture_;
    std::array<Vector, 3> observer_axes_, light_axes_;  // right, up, back
    FloatMatrix to_light_{};
};

}  // namespace umbra78::tools
