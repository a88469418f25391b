// Scenes of the study of rivals, for what a given scene cannot vary.
#include "tools/study/rivals/rivals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace umbra78::tools::study {
namespace {

constexpr double degree = pi / 180;

std::string floor_of(double half, std::string_view ground = "off") {
    return fmt::format("[[plane]]\norigin = [{0}, 0, {1}]\nu = [{2}, 0, 0]\nv = [0, 0, {3}]\n"
                       "ground = \"{4}\"\n", -half, half, 2 * half, -2 * half, ground);
}

std::string light_at(int azimuth, int elevation, int share_of) {
    return fmt::format("[[light]]\nkind = \"directional\"\nazimuth = {}\nelevation = {}\n"
                       "level = {:.6f}\n", azimuth, elevation, 1.0 / share_of);
}

}  // namespace

std::string boxes_scene(int side, int lights) {
    std::string text = "[observer]\nazimuth = 25\nelevation = 40\ntarget = [0, 0, 0]\n"
                       "extent = 3\n";
    for (int l = 0; l < lights; ++l) text += light_at(-60 + 45 * l, 35, lights);
    text += floor_of(2.4);
    const double pitch = 4.0 / side, size = 0.5 * pitch;
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column)
            text += fmt::format("[[box]]\ncentre = [{}, {}, {}]\nsize = [{}, {}, {}]\n",
                                (column + 0.5) * pitch - 2, size / 2, (row + 0.5) * pitch - 2,
                                size, size, size);
    return text;
}

std::string layers_scene(int sheets) {
    std::string text = "[observer]\nazimuth = 0\nelevation = 24\ntarget = [0, 0.8, 0]\n"
                       "extent = 2.6\n";
    text += light_at(15, 75, 1) + floor_of(2.4);
    for (int k = 0; k < sheets; ++k)
        text += fmt::format("[[plane]]\norigin = [-1, {}, 1]\nu = [2, 0, 0]\nv = [0, 0, -2]\n",
                            1.0 + 0.1 * k);
    return text;
}

std::string textbook_scene(double ramp_px) {
    std::string text = "[observer]\nprojection = \"perspective\"\nazimuth = 28\nelevation = 24\n"
                       "target = [0.3, 0.2, 0.1]\nextent = 1.6\ndistance = 9\n";
    if (ramp_px > 0) {
        // Within the machine's words, and so far that its shadow is that of the other light.
        const double a = -52 * degree, e = 38 * degree, away = 400;
        text += fmt::format("[light]\nkind = \"area\"\nsamples = 1\nsize = 0.01\nramp = {}\n"
                            "target = [0, 0.4, 0]\nposition = [{:.6f}, {:.6f}, {:.6f}]\n",
                            ramp_px, away * std::sin(a) * std::cos(e), 0.4 + away * std::sin(e),
                            away * std::cos(a) * std::cos(e));
    } else {
        text += "[light]\nkind = \"directional\"\nazimuth = -52\nelevation = 38\n"
                "target = [0, 0.4, 0]\n";
    }
    return text + floor_of(2.4, "on") +
           "[[sphere]]\ncentre = [-0.9, 0.5, 0.2]\nradius = 0.5\n"
           "[[box]]\ncentre = [0.5, 0.45, -0.7]\nsize = [0.7, 0.9, 0.7]\nturn = [0, 20, 0]\n"
           "[[cone]]\nbase = [0.3, 0, 0.9]\nradius = 0.3\nheight = 0.8\n"
           "[[torus]]\ncentre = [1.35, 0.5, 0.35]\nradius = 0.38\ntube = 0.11\n"
           "turn = [70, 20, 0]\n";
}

}  // namespace umbra78::tools::study
