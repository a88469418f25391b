// Shading: Lambert's cosine and Phong's highlight (Phong 1975), in 8-bit levels.
//
//   I = diffuse (ambient + (1 - ambient) max(0, N.L)) + specular max(0, R.V)^(2^shininess)
//   R = 2 (N.L) N - L,   no highlight where N.L <= 0 or in shadow
//
// A block has a unit normal, Q1.14, at each of its corners, from its own tangents in the world;
// a leaf's normal is the bilinear mean at the leaf's centre, and its length is divided out. It is
// turned toward the viewer, so an open surface has two sides. Cosines are Q1.14, floored.
#pragma once

#include "raster/block.hpp"
#include "raster/scene.hpp"
#include "raster/view.hpp"

#include <array>
#include <cstdint>

namespace umbra78::raster {

inline constexpr int unit_fraction = 14;
using Unit = std::array<std::int32_t, 3>;    // Q1.14
using Vector = std::array<std::int64_t, 3>;  // any scale

constexpr std::int64_t dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// v / |v| in Q1.14, rounded half up; 0 for 0.
Unit unit(Vector v);

// A light's or a viewer's direction: constant, or from the place to a point.
struct Toward {
    bool to_point = false;
    Unit direction{};  // toward it, where it is at infinity
    Vector point{};    // object words with guard bits, where it is not
};

struct ShadingSpec {
    std::int32_t ambient_q8 = 77;  // 0..256
    Toward light{}, viewer{};
};

// Normals and places at a block's four corners (2 v + u), ready for its 256 leaves.
class BlockShading {
public:
    BlockShading(const std::array<Component, 3>& world, const ShadingSpec& spec,
                 const Material& material);

    // The level of leaf (i, j), lit or in the shadow of something else.
    std::uint8_t level(int i, int j, bool in_shadow) const;

private:
    Unit direction(const Toward& toward, int i, int j) const;

    const ShadingSpec& spec_;
    const Material& material_;
    std::array<Unit, 4> normal_{};
    std::array<Vector, 4> place_{};
};

}  // namespace umbra78::raster
