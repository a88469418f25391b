// Solids as bicubic patches: torus, cylinder, cone and box (hw/MACHINE.md, section 20).
//
// Round ones are surfaces of revolution: a cubic profile of radius and height, carried round the
// local y axis through the eight arcs of 45 degrees of which spheres are made. Patches that meet
// have the same words along the seam. Each coordinate is rounded once, when it is placed.
#pragma once

#include "raster/placing.hpp"

#include <span>

namespace umbra78::raster {

inline constexpr int profile_fraction = world_fraction + axis_fraction;

// Control point j of a profile, words of 46 fraction bits.
struct ProfilePoint {
    std::int64_t radius, height;
};
using Profile = std::array<ProfilePoint, 4>;

inline constexpr int patches_round = 8;

// All functions below write each patch's control points and leave its material. False if a point
// lies outside the world; then the patches are not to be used. Lengths are Q15.16, not negative.

// Control point (i, j) of patch k is profile point j at point i of the arc from azimuth 45 k.
[[nodiscard]] bool revolve(const Profile&, const Placing&, std::span<Patch, patches_round> out);

// About the local y axis, in the plane of x and z: patch 8 q + k has elevations from 45 q on the
// tube. tube <= radius.
inline constexpr int patches_per_torus = 64;
[[nodiscard]] bool torus_patches(std::int32_t radius, std::int32_t tube, const Placing&,
                                 std::span<Patch, patches_per_torus> out);

// The wall of a cone from radius `base` at height 0 to radius `top` at `height`.
[[nodiscard]] bool wall_patches(std::int32_t base, std::int32_t top, std::int32_t height,
                                const Placing&, std::span<Patch, patches_round> out);

// A disc at a height.
[[nodiscard]] bool disc_patches(std::int32_t radius, std::int32_t height, const Placing&,
                                std::span<Patch, patches_round> out);

// The box about its centre, size along the local x, y and z. Face 2 a is the one at -size/2 along
// axis a, face 2 a + 1 the one at +size/2.
inline constexpr int patches_per_box = 6;
[[nodiscard]] bool box_patches(const World& size, const Placing&,
                               std::span<Patch, patches_per_box> out);

}  // namespace umbra78::raster
