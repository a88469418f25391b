// Stiff frames: every word is in range, but a small change of one quantity is a large change of
// another.
#include "tools/study/stability/stability.hpp"

#include <fmt/format.h>

namespace umbra78::tools::study {
namespace {

constexpr std::string_view observer = "[observer]\ntarget = [0, 0, 0]\nextent = 2\n";
// A square of 4 x 4 at y = -0.5, and a sphere that stands on it: a contact shadow.
constexpr std::string_view floor_and_sphere =
    "[[plane]]\norigin = [-2, -0.5, 2]\nu = [4, 0, 0]\nv = [0, 0, -4]\n"
    "[[sphere]]\ncentre = [0, 0, 0]\nradius = 0.5\n";

std::string sphere(double x, double y, double z, double r) {
    return fmt::format("[[sphere]]\ncentre = [{}, {}, {}]\nradius = {}\n", x, y, z, r);
}

// A light at infinity in the scene's own volume.
std::string sun(double azimuth, double elevation) {
    return fmt::format("[light]\nazimuth = {}\nelevation = {}\ntarget = [0, 0, 0]\nextent = 2\n",
                       azimuth, elevation);
}

std::string lamp(double x, double y, double z) {
    return fmt::format("[light]\nkind = \"point\"\nposition = [{}, {}, {}]\n", x, y, z);
}

// An observer from above, so that the floor is seen.
std::string above() { return std::string(observer) + "elevation = 30\n"; }

// The eye at the origin, 90 degrees wide; a wall from 0.3 to 0.95 of the far depth, a ball in front
// of it. The far depth is 1000.
FrameCase depth_case(std::string_view name, std::int64_t far_over_near) {
    return {name, "stiff", "Z codes fall as far / near; words within their bound",
            fmt::format("[observer]\nprojection = \"perspective\"\ntarget = [0, 0, -10]\n"
                        "extent = 10\ndistance = 10\nnear = {}\nfar = 1000\n",
                        1000.0 / static_cast<double>(far_over_near)) +
                "[light]\nazimuth = -30\nelevation = 20\n"
                "[[plane]]\norigin = [-300, -950, -300]\nu = [1250, 0, -650]\nv = [0, 1900, 0]\n" +
                sphere(0, 0, -250, 30),
            {"profile=perspective24"}, "ok", 50000, far_over_near};
}

std::vector<FrameCase> directions() {
    const std::string both = above() + std::string(floor_and_sphere);
    const std::string plain = std::string(observer) + std::string(floor_and_sphere);
    std::vector<FrameCase> all;
    const auto add = [&](std::string_view name, std::string_view must, const std::string& scene) {
        all.push_back({name, "stiff", must, scene});
    };
    add("opposed: light straight behind", "Z is reversed; all pixels are in shadow or at its edge",
        plain + sun(180, 0));
    add("opposed: light at 179.99 degrees", "the light's X depends on the last bits of Z",
        plain + sun(179.99, 0));
    add("aligned: light in the observer's eye", "the matrix is the identity; shadow is acne alone",
        plain + sun(0, 0));
    add("aligned: light 2^-16 degree off", "coefficients below a quantum round to 0",
        plain + sun(0.0000152587890625, 0));
    add("light straight overhead", "a defined frame, though the azimuth has no meaning",
        both + sun(0, 90));
    add("light straight below", "the floor is seen from its unlit side", both + sun(0, -90));
    add("observer edge-on to the floor", "a plane of no area draws nothing or its rim",
        plain + sun(-60, 30));
    const std::pair<std::string_view, double> grazing[] = {
        {"grazing: 10 degrees", 10},          {"grazing: 1 degree", 1},
        {"grazing: 2^-4 degree", 0.0625},     {"grazing: 2^-10 degree", 0.0009765625},
        {"grazing: 2^-14 degree", 0.00006103515625},
    };
    for (const auto& [name, angle] : grazing)
        add(name, "the floor's Z is exact to a texel's length along it", both + sun(-90, angle));
    return all;
}

std::vector<FrameCase> proportions() {
    const std::string both = above() + std::string(floor_and_sphere);
    std::vector<FrameCase> all;
    const auto add = [&](std::string_view name, std::string_view must, const std::string& scene,
                         std::vector<std::string> set = {}) {
        all.push_back({name, "stiff", must, scene, std::move(set)});
    };
    add("light's window 30000 wide", "the scene in less than a texel: nearly rank-deficient",
        both + sun(-60, 30), {"light.extent=30000"});
    add("light's window a thousandth", "nearly all is outside the light's volume and so lit",
        both + sun(-60, 30), {"light.extent=0.002"});
    add("light's depth 60000", "the scene in a few Z codes", both + sun(-60, 30),
        {"light.near=-30000", "light.far=30000"});
    add("light's depth a thousandth", "Z magnified a thousandfold, mostly outside the volume",
        both + sun(-60, 30), {"light.near=-0.001", "light.far=0.001"});
    add("observer's window 30000, light's 0.01", "six orders between the views",
        both + sun(-60, 30), {"observer.extent=30000", "light.extent=0.01"});
    add("narrow field of view: 0.01 degree", "nearly orthographic, W nearly constant",
        both + sun(-60, 30),
        {"observer.projection=perspective", "observer.distance=10000", "observer.extent=1"});
    add("wide field of view: 177 degrees", "the frame's edge is at 40 times the distance",
        both + sun(-60, 30),
        {"observer.projection=perspective", "observer.distance=0.8", "observer.extent=30",
         "observer.near=0.05", "observer.far=8"});
    add("light almost in the scene", "a lamp 2^-8 above the sphere", both + lamp(0, 0.50390625, 0));
    add("lamp in the floor's plane", "the lamp sees the floor edge-on",
        both + lamp(-3, -0.5, 0));
    add("lamp inside the sphere", "all outside the sphere is in its shadow",
        both + lamp(0.1, 0.1, 0.1));
    all.push_back(depth_case("far/near 10", 10));
    all.push_back(depth_case("far/near 100", 100));
    all.push_back(depth_case("far/near 1000", 1000));
    all.push_back(depth_case("far/near 10000", 10000));
    all.push_back(depth_case("far/near 100000", 100000));
    all.push_back(depth_case("far/near 1000000", 1000000));
    return all;
}

std::vector<FrameCase> neighbours() {
    const std::string view = std::string(observer);
    std::vector<FrameCase> all;
    const auto add = [&](std::string_view name, std::string_view must, const std::string& scene) {
        all.push_back({name, "stiff", must, scene});
    };
    const auto square = [](double z) {
        return fmt::format("[[plane]]\norigin = [-1, -1, {}]\nu = [2, 0, 0]\nv = [0, 2, 0]\n", z);
    };
    add("two planes a quantum apart", "the nearer is seen; rounding decides which one shadows",
        view + sun(-30, 20) + square(0) + square(0.00006103515625));
    add("two planes in one place", "the result does not depend on their order",
        view + sun(-30, 20) + square(0) + square(0));
    add("tangent spheres", "the shadow begins at the point of contact",
        view + sun(-60, 10) + sphere(-0.5, 0, 0, 0.5) + sphere(0.5, 0, 0, 0.5));
    add("a sphere in a sphere's skin", "two surfaces nearly coincide all over",
        view + sun(-60, 10) + sphere(0, 0, 0, 1) + sphere(0, 0, 0.001, 1));
    add("contact: a sphere on the floor", "a shadow that touches what casts it",
        above() + sun(-60, 40) + std::string(floor_and_sphere));
    add("contact: a wall on the floor", "a shadow that begins at an edge",
        above() + sun(-60, 40) +
            "[[plane]]\norigin = [-2, -0.5, 2]\nu = [4, 0, 0]\nv = [0, 0, -4]\n"
            "[[plane]]\norigin = [0, -0.5, 1]\nu = [0, 0, -2]\nv = [0, 1, 0]\n");
    return all;
}

}  // namespace

std::vector<FrameCase> stiff_frames() {
    std::vector<FrameCase> all = directions();
    for (auto list : {proportions(), neighbours()})
        for (FrameCase& c : list) all.push_back(std::move(c));
    return all;
}

}  // namespace umbra78::tools::study
