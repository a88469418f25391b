// Figures 1 to 6 of Williams 1978, as this machine draws them: scene words and settings.
//
// The paper shows four spheres of smooth patches under a light at infinity, 100 degrees about the
// vertical axis to the left of the observer; it gives no coordinates. Places, radius, materials
// and the numbers of bias, dither and filters are this project's choice. The scene file
// tools/scenes/figures.toml says the same in decimals; a test holds the two equal.
#pragma once

#include "raster/draw.hpp"
#include "shadow/frame/profiles.hpp"

#include <array>
#include <cstdint>

namespace umbra78::shadow {

inline constexpr int figure_count = 6;

// World words, Q15.16.
inline constexpr std::array<raster::Sphere, 4> figure_spheres{{
    {{-68813, 39322, 0}, 47186, 0},      // (-1.05,  0.60, 0.00) radius 0.72
    {{62259, 77332, 19661}, 47186, 0},   // ( 0.95,  1.18, 0.30)
    {{-49152, -73400, 13107}, 47186, 0}, // (-0.75, -1.12, 0.20)
    {{68813, -27525, 29491}, 47186, 0},  // ( 1.05, -0.42, 0.45)
}};
inline constexpr raster::Material figure_material{215, 90, 5};
inline constexpr std::int32_t figure_azimuth_q16 = -100 * 65536;

using FigurePatches = std::array<raster::Patch, 4 * raster::patches_per_sphere>;

inline FigurePatches figure_patches() {
    FigurePatches patches;
    constexpr std::size_t n = raster::patches_per_sphere;
    for (std::size_t k = 0; k < figure_spheres.size(); ++k)
        raster::sphere_patches(figure_spheres[k],
                               std::span<raster::Patch, n>(patches.data() + k * n, n));
    return patches;
}

// Both views are orthographic, 2 world units from the centre to the edge: a cube, 128 pixels a
// unit and 128 Z quanta a pixel.
inline raster::View figure_view(std::int32_t azimuth_q16) {
    raster::View v;
    v.axes = raster::axes_from_angles(azimuth_q16, 0);
    v.extent = 2 << 16;
    v.near_depth = -(2 << 16);
    v.far_depth = 2 << 16;
    return v;
}

// What all figures share, and what each adds: 1 and 2 are the two views, 3 the bare shadow with
// too little bias, 4 with more bias, interpolation and dither, 5 with its edges filtered, 6 the
// shadow on the picture.
constexpr Settings figure_settings(int figure) {
    Settings s;
    s.ambient_q8 = 90;   // 0.35
    s.density_q8 = 141;  // 0.55
    if (figure < 4) return s;
    s.lookup = Lookup::bilinear;
    s.bias_q16 = 192 << 16;
    s.dither.shape = hw::DitherShape::normal;
    if (figure < 5) return s;
    s.dequantize_passes = 4;
    s.low_pass_passes = 1;
    return s;
}

// The same on an AP-120B with standard memory.
inline Settings array_figure_settings(int figure) {
    Settings s = figure_settings(figure);
    apply(*find_profile("ap120b"), s);
    return s;
}

}  // namespace umbra78::shadow
