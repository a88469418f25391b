// Extreme frames: W near 0, surfaces without area or of enormous size, widths at their ends.
#include "tools/study/stability/stability.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace umbra78::tools::study {
namespace {

using Net = std::array<std::array<double, 3>, 16>;

// The eye of the view `eye` is at (0, 0, 5) and looks along -z.
constexpr std::string_view front = "[observer]\ntarget = [0, 0, 0]\nextent = 2\n";
constexpr std::string_view eye =
    "[observer]\nprojection = \"perspective\"\ntarget = [0, 0, 0]\nextent = 2\ndistance = 5\n"
    "near = 0.0009765625\nfar = 60\n";
constexpr std::string_view low_sun =
    "[light]\nazimuth = -60\nelevation = 30\ntarget = [0, 0, 0]\nextent = 2\n";
constexpr std::string_view ball = "[[sphere]]\ncentre = [0, 0, 0]\nradius = 0.5\n";

std::string patch(const Net& net) {
    std::string text = "[[patch]]\ncontrol = [";
    for (std::size_t j = 0; j < 4; ++j) {
        text += "[";
        for (std::size_t i = 0; i < 4; ++i) {
            const auto& p = net[4 * j + i];
            text += fmt::format("[{}, {}, {}], ", p[0], p[1], p[2]);
        }
        text += "], ";
    }
    return text + "]\n";
}

// The net of a patch over the square -s .. s about (0, 0, z), each point moved by `move`.
template <class Move>
Net net(double s, double z, Move move) {
    Net n{};
    for (std::size_t k = 0; k < 16; ++k) {
        const double u = static_cast<double>(k % 4) / 3, v = static_cast<double>(k / 4) / 3;
        n[k] = {s * (2 * u - 1), s * (2 * v - 1), z};
        move(n[k], u, v);
    }
    return n;
}

// Random control points make folds over folds; a generator of 16 bits is enough for that.
Net crumpled(double s, double z, unsigned seed) {
    return net(0, z, [&](std::array<double, 3>& p, double, double) {
        for (double& c : p) {
            seed = (seed * 25173 + 13849) & 0xffff;  // Grogono's, of the 1970s
            c += s * (static_cast<double>(seed) / 32768 - 1);
        }
    });
}

const auto stay = [](std::array<double, 3>&, double, double) {};

std::vector<FrameCase> surfaces() {
    const std::string view = std::string(front) + std::string(low_sun);
    const std::string floor =
        "[[plane]]\norigin = [-2, -1.5, 2]\nu = [4, 0, 0]\nv = [0, 0, -4]\n";
    std::vector<FrameCase> all;
    const auto add = [&](std::string_view name, std::string_view must, const std::string& scene,
                         std::vector<std::string> set = {}, std::int64_t splits = 50000) {
        all.push_back({name, "extreme", must, scene, std::move(set), "ok", splits});
    };
    add("patch: a point", "nothing drawn, no division by its area",
        view + floor + patch(net(0, 0, stay)));
    add("patch: a line", "at most the drawing slack's width of it is drawn",
        view + floor + patch(net(1, 0, [](auto& p, double u, double) { p[1] = u; })));
    add("patch: one edge a point", "a triangle; the normal at the point is the other edge's",
        view + floor + patch(net(1, 0, [](auto& p, double, double v) { p[0] *= 1 - v; })));
    add("patch: folded in two", "both leaves drawn, the nearer seen",
        view + floor + patch(net(1, 0, [](auto& p, double u, double) {
            p[0] = u * (1 - u) * 4;
            p[2] = u;
        })));
    add("patch: crossing control net", "a surface that intersects itself",
        view + floor + patch(net(1, 0, [](auto& p, double u, double v) {
            p[0] *= 3 * (v - 0.5);
            p[2] = u;
        })));
    add("patch: crumpled", "folds over folds", view + floor + patch(crumpled(1.5, 0, 1)));
    add("patch: a thousand screens wide", "only parts inside the frame are split to pixels",
        view + patch(net(4000, -1, [](auto& p, double u, double v) { p[2] += u * v; })),
        {"light.near=-40", "light.far=40"});
    add("patch: a thousandth of a pixel", "one block, at most a pixel",
        view + floor + patch(net(0.000015, 0.5, stay)));
    add("scene at the words' end", "16-bit object words of 2^-0 unit", view +
        "[[sphere]]\ncentre = [32000, 0, 0]\nradius = 700\n",
        {"observer.target=[32000, 0, 0]", "observer.extent=1000", "light.target=[32000, 0, 0]",
         "light.extent=1000"});
    add("scene of 2^-14", "a sphere of four world quanta",
        view + "[[sphere]]\ncentre = [0, 0, 0]\nradius = 0.00006103515625\n",
        {"observer.extent=0.0001220703125", "light.extent=0.0001220703125"});
    add("scene of 30000 in a window of 2^-16", "24 halvings do not reach a pixel: dropped, counted",
        view + "[[plane]]\norigin = [-16000, -16000, 1]\nu = [32000, 0, 0]\nv = [0, 32000, 0]\n",
        {"observer.extent=0.0000152587890625", "light.extent=0.0000152587890625"});
    all.back().status = "unresolved";
    add("depth 2^-16 about a scene of 30000", "the greatest Z coefficient",
        view + "[[plane]]\norigin = [-16000, -16000, 1]\nu = [32000, 0, 0]\nv = [0, 32000, 3000]\n",
        {"observer.near=100", "observer.far=100.0000152587890625"});
    add("a crumpled scene of 30000 in a depth of 2^-14, 24-bit Z",
        "refused by name: raster words and their corrections would be beyond 64 bits",
        view + patch(net(32000, 0, [](auto& p, double u, double v) {
            p[2] = (std::lround(3 * u) + std::lround(3 * v)) % 2 ? 32000 : -32000;
        })),
        {"z_bits=24", "xy_bits=4", "observer.near=131067", "observer.far=131067.00006103515625"});
    all.back().status = "refused: case: the observer's matrix";
    all.push_back({"empty scene", "extreme", "refused by name, or an empty frame", view, {},
                   "", 0});
    add("only background", "no pixel transformed, none in shadow",
        view + std::string(ball), {"observer.target=[100, 0, 0]"}, 2000);
    return all;
}

std::vector<FrameCase> through_the_eye() {
    const std::string view = std::string(eye) + std::string(low_sun);
    std::vector<FrameCase> all;
    const auto add = [&](std::string_view name, std::string_view must, const std::string& scene,
                         std::vector<std::string> set = {}, std::int64_t splits = 50000) {
        set.insert(set.begin(), "profile=perspective24");
        all.push_back({name, "extreme", must, scene, std::move(set), "ok", splits});
    };
    add("everything behind the eye", "nothing drawn, in a few blocks",
        view + "[[sphere]]\ncentre = [0, 0, 20]\nradius = 2\n", {}, 200);
    add("a floor through the eye's plane", "cut at the near plane",
        view + "[[plane]]\norigin = [-20, -1, 20]\nu = [40, 0, 0]\nv = [0, 0, -40]\n");
    add("a floor that ends just before the eye", "its parts far outside the frame are not split",
        view + "[[plane]]\norigin = [-20, -1, 4.998046875]\nu = [40, 0, 0]\nv = [0, 0, -30]\n");
    add("a wall through the eye", "seen edge-on, W from negative to positive",
        view + "[[plane]]\norigin = [0, -20, 20]\nu = [0, 40, 0]\nv = [0, 0, -40]\n");
    add("the eye in a sphere's skin", "W is 0 on the surface itself",
        view + "[[sphere]]\ncentre = [0, 0, 4]\nradius = 1\n");
    add("a crumpled patch round the eye", "ends, although W is 0 in many places",
        view + patch(crumpled(1, 5, 3)), {}, 200000);
    add("a large crumpled patch through the eye", "ends, although each fold fills the frame",
        view + patch(crumpled(8, 5, 9)), {}, 200000);
    add("a huge crumpled patch through the eye", "ends",
        view + patch(crumpled(40, 5, 27)), {}, 200000);
    const std::string lamp =
        std::string(front) + "[light]\nkind = \"point\"\nposition = [-0.5, 0.25, 0.25]\n"
        "target = [2, 0, 0]\nextent = 1\nnear = 0.01\nfar = 8\n"
        "[[plane]]\norigin = [-2, -2, 0]\nu = [4, 0, 0]\nv = [0, 4, 0]\n"
        "[[sphere]]\ncentre = [1, 0, 0.25]\nradius = 0.25\n";
    add("a lamp behind half of the scene", "W of the light is 0 across the picture", lamp);
    add("a lamp behind half of the scene, 24-bit accumulators", "W is cut before it divides", lamp,
        {"accumulator_bits=24"});
    return all;
}

std::vector<FrameCase> widths() {
    const std::string scene = std::string(front) + "elevation = 30\n" + std::string(low_sun) +
                              "[[plane]]\norigin = [-2, -0.5, 2]\nu = [4, 0, 0]\n"
                              "v = [0, 0, -4]\n" + std::string(ball);
    std::vector<FrameCase> all;
    const auto add = [&](std::string_view name, std::string_view must,
                         std::vector<std::string> set) {
        all.push_back({name, "extreme", must, scene, std::move(set)});
    };
    add("bias zero", "acne everywhere, but a defined frame", {"bias=0"});
    add("bias negative", "all lit surfaces shadow themselves", {"bias=-1024"});
    add("bias of the whole depth", "nothing in shadow", {"bias=65536"});
    add("the greatest bias", "a bias the Z row cannot hold costs its coefficients, not their sign",
        {"bias=16777216"});
    add("the least bias", "as the greatest", {"bias=-16777216"});
    add("4-bit Z", "16 codes; a quantum is many pixels", {"z_bits=4"});
    add("24-bit Z", "256 times finer than 1978's", {"z_bits=24"});
    add("4-bit X and Y, 24-bit Z", "a pixel of 2^20 quanta", {"xy_bits=4", "z_bits=24"});
    add("8-bit coefficients", "a matrix of 7 bits and a sign", {"coefficient_bits=8"});
    add("32-bit coefficients", "the widest accumulator", {"coefficient_bits=32", "z_bits=24"});
    add("no fraction", "texels by whole numbers", {"fraction_bits=0"});
    add("16-bit accumulators", "each product is cut to a pixel's fourth", {"accumulator_bits=16"});
    add("16-bit accumulators, the widest words", "43 bits of each product are cut",
        {"accumulator_bits=16", "coefficient_bits=32", "z_bits=24"});
    return all;
}

}  // namespace

std::vector<FrameCase> extreme_frames() {
    std::vector<FrameCase> all = surfaces();
    for (auto list : {through_the_eye(), widths()})
        for (FrameCase& c : list) all.push_back(std::move(c));
    return all;
}

}  // namespace umbra78::tools::study
