// Scenes of a floor and what shadows it, with answers that can be counted by hand.
//
// The eye looks straight down on a floor of 64 x 64 pixels. The light comes from the right at 45
// degrees, so that a point at height h above the floor has its shadow h to its left; what casts
// hangs so high that it lies outside the frame.
#pragma once

#include "tests/shadow/rivals/scenes.hpp"

#include <functional>

namespace umbra78::shadow::rivals::test {

inline constexpr int words_a_pixel = 16;
inline constexpr std::int32_t high = 1536;  // words; beyond the frame's half of 512

// The point whose shadow is (x, y), in pixels, from `above` words over `high`.
inline Point casting(double x, double y, std::int32_t above = 0) {
    const std::int32_t h = high + above;
    return {static_cast<std::int32_t>(x * words_a_pixel) + h,
            static_cast<std::int32_t>(y * words_a_pixel), -h};
}

struct Answered {
    Polygons polygons;
    std::function<bool(double, double)> is_dark;  // of a pixel's centre, in pixels from the middle
    std::size_t dark_pixels;
};

inline Polygons floor_under_light(const std::string& name) {
    Polygons p;
    p.name = name;
    p.light = {1 << 10, 0, -(1 << 10), 0};
    const std::int32_t half = 32 * words_a_pixel;
    p.quad({-half, -half, 0}, {half, -half, 0}, {half, half, 0}, {-half, half, 0});
    return p;
}

inline bool within(double v, double from, double to) { return v > from && v < to; }

// Three bars, each over the next.
inline Answered cycle_of_three() {
    Polygons p = floor_under_light("cycle_of_three");
    p.quad(casting(-20, -12, -80), casting(20, -12, 80), casting(20, -8, 80),
           casting(-20, -8, -80));
    p.quad(casting(8, -20, -80), casting(12, -20, -80), casting(12, 20, 80), casting(8, 20, 80));
    p.quad(casting(-18.5, -21, 80), casting(-21, -18.5, 80), casting(18.5, 21, -80),
           casting(21, 18.5, -80));
    return {p,
            [](double x, double y) {
                return (within(x, -20, 20) && within(y, -12, -8)) ||
                       (within(x, 8, 12) && within(y, -20, 20)) ||
                       (within(y - x, -2.5, 2.5) && within(x + y, -39.5, 39.5));
            },
            // 160 and 160, less their 4 x 4, and of the third's 198 what is beside them
            462};
}

// Two plates whose planes cross in their middle.
inline Answered through_each_other() {
    Polygons p = floor_under_light("through_each_other");
    p.quad(casting(-16, -12, -128), casting(16, -12, 128), casting(16, 4, 128),
           casting(-16, 4, -128));
    p.quad(casting(-16, -4, 128), casting(16, -4, -128), casting(16, 12, -128),
           casting(-16, 12, 128));
    return {p, [](double x, double y) { return within(x, -16, 16) && within(y, -12, 12); },
            32 * 24};
}

inline Answered shared_edge() {
    Polygons p = floor_under_light("shared_edge");
    p.quad(casting(-8, -8), casting(8, -8), casting(8, 8), casting(-8, 8));
    return {p, [](double x, double y) { return within(x, -8, 8) && within(y, -8, 8); }, 256};
}

// The same plate in four, about a point of its diagonal.
inline Answered split_in_four() {
    Polygons p = floor_under_light("split_in_four");
    const Point middle = casting(2, 2);
    const std::array corner{casting(-8, -8), casting(8, -8), casting(8, 8), casting(-8, 8)};
    for (std::size_t k = 0; k < 4; ++k) p.triangle(corner[k], corner[(k + 1) % 4], middle);
    return {p, [](double x, double y) { return within(x, -8, 8) && within(y, -8, 8); }, 256};
}

// Three pages on one edge, one of them over another.
inline Answered book() {
    Polygons p = floor_under_light("book");
    const Point a = casting(0, -8), b = casting(0, 8);
    p.quad(a, b, casting(12, 8), casting(12, -8));
    p.quad(a, b, casting(-10, 8, 64), casting(-10, -8, 64));
    p.quad(a, b, casting(6, 8, 96), casting(6, -8, 96));
    return {p, [](double x, double y) { return within(x, -10, 12) && within(y, -8, 8); },
            22 * 16};
}

// A plate, and a facet along the light's rays that passes through it.
inline Answered edge_on_facet() {
    Answered a = shared_edge();
    a.polygons.name = "edge_on_facet";
    a.polygons.triangle(casting(-12, 1, -200), casting(12, 1, -200), casting(0, 1, 200));
    return a;
}

// A random scene of words as long as they may be, many of them the longest: what the bounds of the
// signs are derived for, and where a word too short would trap.
inline Polygons wide_polygons(std::uint32_t seed) {
    std::mt19937 random(seed);
    const auto below = [&](std::uint32_t n) { return static_cast<std::int32_t>(random() % n); };
    const auto word = [&](std::int32_t most) {
        const std::int32_t v = below(2 * static_cast<std::uint32_t>(most) + 1) - most;
        return below(2) == 0 ? v : v < 0 ? -most : most;
    };
    const auto point = [&] { return Point{word(max_word), word(max_word), word(max_word)}; };
    Polygons p;
    p.name = "wide " + std::to_string(seed);
    p.xy_bits = 3, p.fraction = 19;
    if (below(2) == 0) p.eye = {0, 0, -max_word, 1};
    const std::int32_t w = below(2);
    const std::int32_t most = w == 0 ? 1 << direction_fraction : max_word;
    do {
        p.light = {word(most), word(most), word(most), w};
    } while (p.light.x == 0 && p.light.y == 0 && p.light.z == 0);
    for (int n = 8; n > 0; --n) p.triangle(point(), point(), point());
    return p;
}

inline std::vector<Answered> answered_scenes() {
    return {cycle_of_three(), through_each_other(), shared_edge(),
            split_in_four(), book(), edge_on_facet()};
}

}  // namespace umbra78::shadow::rivals::test
