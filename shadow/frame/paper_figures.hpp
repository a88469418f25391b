// Figures 1 to 6 of Williams 1978, as this machine draws them: scene words and settings.
//
// The paper shows four spheres of smooth patches under a light at infinity, 100 degrees about the
// vertical axis to the left of the observer; it gives no coordinates. Places, radius, materials
// and the numbers of bias, dither and filters are this project's choice. They are written once, in
// the scene file tools/scenes/figures.toml; paper_scene_words.hpp holds its words.
#pragma once

#include "raster/draw.hpp"
#include "shadow/frame/paper_scene_words.hpp"
#include "shadow/frame/profiles.hpp"

#include <array>
#include <cstdint>

namespace umbra78::shadow {

inline constexpr int figure_count = 6;

inline constexpr const auto& figure_spheres = paper_scene::spheres;
inline constexpr const raster::Material& figure_material = paper_scene::material;
inline constexpr std::int32_t figure_azimuth_q16 = paper_scene::light_azimuth_q16;

using FigurePatches = std::array<raster::Patch, figure_spheres.size() * raster::patches_per_sphere>;

inline FigurePatches figure_patches() {
    FigurePatches patches;
    constexpr std::size_t n = raster::patches_per_sphere;
    for (std::size_t k = 0; k < figure_spheres.size(); ++k)
        raster::sphere_patches(figure_spheres[k],
                               std::span<raster::Patch, n>(patches.data() + k * n, n));
    return patches;
}

// Both views are orthographic and see a cube of 4 world units: 128 pixels a unit, 128 Z quanta a
// pixel.
inline raster::View figure_view(std::int32_t azimuth_q16) {
    raster::View v;
    v.axes = raster::axes_from_angles(azimuth_q16, 0);
    v.extent = paper_scene::extent_q16;
    v.near_depth = -paper_scene::extent_q16;
    v.far_depth = paper_scene::extent_q16;
    return v;
}

// What all figures share, and what each adds: 1 and 2 are the two views, 3 the bare shadow with
// too little bias, 4 with more bias, interpolation and dither, 5 with its edges filtered, 6 the
// shadow on the picture.
constexpr Settings figure_settings(int figure) {
    Settings s;
    s.ambient_q8 = paper_scene::ambient_q8;
    s.density_q8 = paper_scene::density_q8;
    if (figure < 4) return s;
    s.lookup = paper_scene::lookup;
    s.bias_q16 = paper_scene::bias_q16;
    s.dither.shape = paper_scene::dither;
    if (figure < 5) return s;
    s.dequantize_passes = paper_scene::dequantize_passes;
    s.low_pass_passes = paper_scene::low_pass_passes;
    return s;
}

// The same on an AP-120B with standard memory.
inline Settings array_figure_settings(int figure) {
    Settings s = figure_settings(figure);
    apply(*find_profile("ap120b"), s);
    return s;
}

}  // namespace umbra78::shadow
