// The grounds of the study of lights, and what it changes in a scene.
#include "tools/study/lights/lights.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace umbra78::tools::study {
namespace {

constexpr double degree = pi / 180;

// A word of 2^-16 as a decimal, with all its digits.
std::string decimal(std::int64_t q16) {
    return fmt::format("{:.16f}", std::ldexp(static_cast<double>(q16), -16));
}

std::string scaled(std::int32_t q16, double factor) {
    return decimal(std::llround(q16 * factor));
}

}  // namespace

std::string opposed_lamp_scene(double degrees) {
    constexpr double away = 6, elevation = 20 * degree, middle = 0.2;
    const double a = degrees * degree, level = away * std::cos(elevation);
    std::string text = fmt::format(
        "[observer]\nprojection = \"perspective\"\nazimuth = 0\nelevation = 20\ndistance = {}\n"
        "target = [0, {}, 0]\n[light]\nkind = \"point\"\ntarget = [0, {}, 0]\n"
        "position = [{:.9f}, {:.9f}, {:.9f}]\n",
        away, middle, middle, level * std::sin(a), middle + away * std::sin(elevation),
        level * std::cos(a));
    text += "[[plane]]\norigin = [-3, 0, 3]\nu = [6, 0, 0]\nv = [0, 0, -6]\n";
    for (const double x : {-1.8, 0.0, 1.8})
        for (const double z : {-1.8, 0.0, 1.8})
            text += fmt::format("[[sphere]]\ncentre = [{}, 0.3, {}]\nradius = 0.3\n", x, z);
    return text;
}

std::string low_lamp_scene(double height) {
    std::string text = fmt::format(
        "[observer]\nazimuth = -20\nelevation = 35\ntarget = [0.2, 0.3, 0]\nextent = 2.6\n"
        "[light]\nkind = \"point\"\nposition = [-3, {}, 0]\ntarget = [0, 0, 0]\n",
        height);
    text += "[[plane]]\norigin = [-2, 0, 2]\nu = [4, 0, 0]\nv = [0, 0, -4]\n"
            "[[plane]]\norigin = [2, 0, 2]\nu = [0, 0, -4]\nv = [0, 1.5, 0]\n";
    for (const auto& [x, z] : {std::pair{-1.0, 0.6}, {0.0, -0.7}, {0.9, 0.4}})
        text += fmt::format("[[sphere]]\ncentre = [{}, 0.15, {}]\nradius = 0.15\n", x, z);
    return text;
}

std::vector<std::string> size_overrides(const LoadedScene& scene, double texels) {
    const raster::View &light = scene.light(), &observer = scene.observer;
    std::vector<std::string> set{"light.near=" + decimal(light.near_depth),
                                 "light.far=" + decimal(light.far_depth)};
    const int finer = texels < 1 ? static_cast<int>(std::lround(std::log2(1 / texels))) : 0;
    set.push_back("light.extent=" + scaled(light.extent, texels < 1 ? 1 : texels));
    set.push_back("observer.near=" + decimal(observer.near_depth));
    set.push_back("observer.far=" + decimal(observer.far_depth));
    set.push_back("observer.extent=" + scaled(observer.extent, 1 << finer));
    set.push_back(fmt::format("xy_bits={}", scene.settings.machine.xy_bits + finer));
    return set;
}

std::string angle_override(const LoadedScene& scene, double degrees) {
    const raster::Axis& back = scene.observer.axes.back;
    double azimuth = std::atan2(back[0], back[2]) / degree + degrees;
    if (azimuth > 180) azimuth -= 360;
    return fmt::format("light.azimuth={:.4f}", azimuth);
}

TexelSides texel_sides(const SceneTruth& s) {
    const Truth& t = s.truth;
    const auto size = static_cast<std::size_t>(t.size);
    const auto place = [&](std::size_t at) { return s.light_view.project(t.position[at]); };
    std::vector<double> sides;
    for (std::size_t y = 0; y + 1 < size; ++y)
        for (std::size_t x = 0; x + 1 < size; ++x) {
            const std::size_t at = y * size + x, beside = at + 1, below = at + size;
            const auto on_it = [&](std::size_t k) {
                return t.visible[k] && t.lit[k] && t.surface[k] == t.surface[at];
            };
            if (!on_it(at) || !on_it(beside) || !on_it(below)) continue;
            const Real3 here = place(at), a = minus(place(beside), here),
                        b = minus(place(below), here);
            const double area = std::abs(a[0] * b[1] - a[1] * b[0]);
            if (area > 0) sides.push_back(1 / std::sqrt(area));
        }
    if (sides.empty()) return {std::nan(""), std::nan("")};
    const auto at_share = [&](double share) {
        const auto k = static_cast<std::ptrdiff_t>(share * static_cast<double>(sides.size() - 1));
        std::nth_element(sides.begin(), sides.begin() + k, sides.end());
        return sides[static_cast<std::size_t>(k)];
    };
    return {at_share(0.5), at_share(0.95)};
}

}  // namespace umbra78::tools::study
