// The scene: spheres, planes, bicubic Bezier patches and meshes of triangles in world words, and
// their materials; and the patches that spheres and planes become (hw/MACHINE.md, section 3).
//
// World: right-handed, x right, y up, z toward an observer at azimuth 0. World words are Q15.16.
// A patch's control point (i, j) is control[4 j + i], i along u, j along v.
#pragma once

#include "hw/features.hpp"

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>

namespace umbra78::raster {

inline constexpr int world_fraction = 16;
// Control points lie within this of the origin, so that 16-bit object words hold every scene.
inline constexpr std::int32_t max_world = 32766 << world_fraction;

struct World {
    std::int32_t x, y, z;  // Q15.16
    constexpr bool operator==(const World&) const = default;
};

// The channels of a coloured frame; a grey one has the first alone.
inline constexpr std::size_t max_channels = hw::built(hw::Feature::lights) ? 3 : 1;

// A level for each channel: red, green, blue.
class Levels {
public:
    constexpr Levels(std::int32_t grey) : levels_{grey, grey, grey} {}
    constexpr Levels(std::int32_t red, std::int32_t green, std::int32_t blue)
        : levels_{red, green, blue} {}
    constexpr std::int32_t operator[](std::size_t channel) const { return levels_[channel]; }
    constexpr bool is_grey() const {
        return levels_[0] == levels_[1] && levels_[0] == levels_[2];
    }
    constexpr bool operator==(const Levels&) const = default;

private:
    std::array<std::int32_t, 3> levels_;
};

// Levels are counts of the 8-bit intensity planes.
struct Material {
    Levels diffuse = 200;        // of a surface facing the light, 0..255
    Levels specular = 55;        // added in the highlight, 0..255
    std::int32_t shininess = 5;  // the highlight's exponent is 2^shininess, 0..8
    constexpr bool operator==(const Material&) const = default;
};

struct Patch {
    std::array<World, 16> control{};
    std::uint16_t material = 0;
};

// A triangle of a mesh: numbers of its vertices and of their normals. A facet that has no normals
// of its own is flat: each of its three numbers is `flat`.
struct Facet {
    static constexpr std::uint32_t flat = UINT32_MAX;
    std::array<std::uint32_t, 3> vertex{};
    std::array<std::uint32_t, 3> normal{flat, flat, flat};
    std::uint16_t material = 0;
};

// Triangles that share vertices, seen from both sides. Normals are unit vectors in Q1.14.
struct Mesh {
    std::span<const World> vertices;
    std::span<const std::array<std::int32_t, 3>> normals;
    std::span<const Facet> facets;
};

// What is drawn: patches and a mesh.
struct Surfaces {
    std::span<const Patch> patches;
    Mesh mesh;

    constexpr Surfaces() = default;
    constexpr Surfaces(std::span<const Patch> of_patches, const Mesh& of_mesh)
        : patches(of_patches), mesh(of_mesh) {}
    // From patches alone, in whatever holds them.
    template <class Range>
        requires std::convertible_to<const Range&, std::span<const Patch>>
    constexpr Surfaces(const Range& of_patches) : patches(of_patches) {}

    // Patches and facets.
    constexpr std::size_t count() const { return patches.size() + mesh.facets.size(); }
    constexpr bool empty() const { return count() == 0; }

    // Every control point and every vertex of the mesh.
    template <class Visit>
    constexpr void for_points(Visit&& visit) const {
        for (const Patch& patch : patches)
            for (const World& p : patch.control) visit(p);
        for (const World& p : mesh.vertices) visit(p);
    }
};

struct Sphere {
    World centre{};
    std::int32_t radius = 0;  // Q15.16
    std::uint16_t material = 0;
};

// A finite parallelogram: origin + s u + t v, 0 <= s, t <= 1.
struct Plane {
    World origin{}, u{}, v{};
    std::uint16_t material = 0;
};

inline constexpr int patches_per_sphere = 32;

// Eight patches round the vertical axis by four from pole to pole: patch 8 q + m, for azimuths from
// 45 m degrees and elevations from 45 (q - 2) degrees. Each is the product of two cubic arcs of
// 45 degrees with the handle 4/3 tan(45/4 degrees). A cubic arc of 90 degrees lies up to 0.027 %
// outside its circle; one of 45 degrees 64 times less, a twentieth of a quantum in the figures.
void sphere_patches(const Sphere& s, std::span<Patch, patches_per_sphere> out);

// The plane as one patch with evenly spaced control points.
Patch plane_patch(const Plane& p);

}  // namespace umbra78::raster
