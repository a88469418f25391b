// The figures' scene in the words of the machine, made by
//   umbra78 figures --words >shadow/frame/paper_scene_words.hpp
// from tools/scenes/figures.toml. Do not edit it: a test makes it again and compares.
#pragma once

#include "raster/scene.hpp"
#include "shadow/frame/settings.hpp"

#include <array>
#include <cstdint>

namespace umbra78::shadow::paper_scene {

// Places and radii are world words, Q15.16.
inline constexpr std::array<raster::Sphere, 4> spheres{{
    {{-68813, 39322, 0}, 47186, 0},  // (-1.05, 0.6, 0) radius 0.72
    {{62259, 77332, 19661}, 47186, 0},  // (0.95, 1.18, 0.3) radius 0.72
    {{-49152, -73400, 13107}, 47186, 0},  // (-0.75, -1.12, 0.2) radius 0.72
    {{68813, -27525, 29491}, 47186, 0},  // (1.05, -0.42, 0.45) radius 0.72
}};
inline constexpr raster::Material material{215, 90, 5};
inline constexpr std::int32_t light_azimuth_q16 = -6553600;
inline constexpr std::int32_t extent_q16 = 131072;

inline constexpr std::int32_t ambient_q8 = 90;
inline constexpr std::int32_t density_q8 = 218;
inline constexpr std::int64_t bias_q16 = 12582912;
inline constexpr auto lookup = static_cast<Lookup>(1);
inline constexpr auto dither = static_cast<hw::DitherShape>(4);
inline constexpr std::int32_t dequantize_passes = 1;
inline constexpr std::int32_t low_pass_passes = 2;

}  // namespace umbra78::shadow::paper_scene
