// The parts of the study of lights: how well a light's map serves a picture, over the map's size
// beside the picture's, the angle between light and observer, and a lamp's height over a surface.
#pragma once

#include "tools/study/measures.hpp"
#include "tools/study/study.hpp"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace umbra78::tools::study {

// What is varied, on which ground: the scene's own surfaces, or a ground of the study's.
enum class Question : std::uint8_t { size, angle, opposed_lamp, low_lamp };
inline constexpr std::string_view question_names[] = {"size", "angle", "opposed lamp", "low lamp"};
Question question_of(const Case&);

// Nine balls on a square floor, under a lamp that is as far from their middle and as high as the
// observer: at an angle of 0 both see the same, at 180 they face each other.
std::string opposed_lamp_scene(double degrees);
// Balls on a floor before a wall, and a lamp beside them at that height over the floor.
std::string low_lamp_scene(double height);

// What makes a texel of the light's map so many times as large as a pixel of the observer, each
// relative to the scene's own. A coarser map has a larger window; its depth range stays. A finer
// one has more bits of X and Y, and so has the observer's picture, whose window grows by as much:
// its pixels keep their size. `texels` is a power of two.
std::vector<std::string> size_overrides(const LoadedScene&, double texels);

// The light's azimuth at that angle from the observer's.
std::string angle_override(const LoadedScene&, double degrees);

// How many pixels the side of a texel covers, over the lit pixels: the square root of the pixels'
// area in texels, inverted. The middle value, and what 95 % of the pixels do not exceed; NaN where
// nothing is lit.
struct TexelSides {
    double median, most;
};
TexelSides texel_sides(const SceneTruth&);

// The scene of a case; without a ground of the study's it is the request's.
LoadedScene lights_scene(const Request&, const Case&);

std::unique_ptr<Study> make_lights_study();

void report_lights(const Request&, std::span<const Row>, Report&);

}  // namespace umbra78::tools::study
