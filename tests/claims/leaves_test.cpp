// Shadows of thin leaves break up as the light's map gets coarser.
//
// Blades hang over a floor, 0.03 wide and 0.9 long, in all directions. The observer looks straight
// down at their shadows and does not see them. A pixel is 1/128; the light's texel is that times 1
// to 16, by the light's window.
#include "tests/claims/drawn.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <numbers>
#include <vector>

namespace umbra78::claims {
namespace {

constexpr int blades_a_side = 3;

std::string leaves(int coarser) {
    std::string text =
        "[observer]\nazimuth = 0\nelevation = 90\ntarget = [0, 0, 0]\nextent = 2\n"
        "near = -5\nfar = 5\n"
        "[light]\nazimuth = -90\nelevation = 45\ntarget = [0, 0, 0]\nextent = " +
        std::to_string(2 * coarser) + "\nnear = -8\nfar = 8\n"
        "[[plane]]\norigin = [-2, 0, 2]\nu = [4, 0, 0]\nv = [0, 0, -4]\n";
    const auto number = [](double v) { return std::to_string(v); };
    // 4 high and 4 to the left: each blade's shadow is that blade moved 4 down and 4 to the right.
    for (int k = 0; k < blades_a_side * blades_a_side; ++k) {
        const double turn = k * std::numbers::pi / 9 + 0.1, c = std::cos(turn), s = std::sin(turn);
        const double x = (k % 3 - 1) * 1.1 - 4, z = (k / 3 - 1) * 1.1;
        text += "[[plane]]\norigin = [" + number(x - 0.45 * c + 0.015 * s) + ", 4, " +
                number(z - 0.45 * s - 0.015 * c) + "]\nu = [" + number(0.9 * c) + ", 0, " +
                number(0.9 * s) + "]\nv = [" + number(-0.03 * s) + ", 0, " + number(0.03 * c) +
                "]\n";
    }
    return text + "[settings]\nlookup = \"nearest\"\nbias = 1\nbias_unit = \"texels\"\n";
}

// The floor's pixels with that answer, and how many pieces they form: pixels that touch, at a
// corner, too, are of one piece. Pieces of a single pixel count.
struct Pieces {
    int pixels = 0, pieces = 0;
};

template <class Shadowed>
Pieces pieces_of(int size, Shadowed shadowed) {
    Pieces found;
    std::vector<std::uint8_t> left;
    for (int at = 0; at < size * size; ++at) left.push_back(shadowed(static_cast<std::size_t>(at)));
    std::vector<int> stack;
    for (int from = 0; from < size * size; ++from) {
        if (!left[static_cast<std::size_t>(from)]) continue;
        ++found.pieces;
        stack.push_back(from);
        left[static_cast<std::size_t>(from)] = 0;
        while (!stack.empty()) {
            const int at = stack.back(), x = at % size, y = at / size;
            stack.pop_back();
            ++found.pixels;
            for (int v = std::max(y - 1, 0); v <= std::min(y + 1, size - 1); ++v)
                for (int u = std::max(x - 1, 0); u <= std::min(x + 1, size - 1); ++u) {
                    std::uint8_t& other = left[static_cast<std::size_t>(v * size + u)];
                    if (!other) continue;
                    other = 0;
                    stack.push_back(v * size + u);
                }
        }
    }
    return found;
}

TEST(Leaves, ShadowsOfThinOnesBreakUpInACoarseMap) {
    const auto truth = truth_of(leaves(1));
    const tools::Truth& t = truth->truth;
    const auto on_floor = [&](std::size_t at) { return t.visible[at] && t.surface[at] == 0; };
    const Pieces exact =
        pieces_of(t.size, [&](std::size_t at) { return on_floor(at) && !t.lit[at]; });
    std::printf("leaves in truth: %d pixels of shadow in %d pieces\n", exact.pixels, exact.pieces);
    EXPECT_EQ(exact.pieces, blades_a_side * blades_a_side);
    std::vector<double> false_light;
    std::vector<int> pieces;
    for (const int coarser : {1, 2, 4, 8, 16}) {
        const Drawn drawn(leaves(coarser));
        const auto mask = drawn.mask();
        const Pieces seen = pieces_of(t.size, [&](std::size_t at) {
            return on_floor(at) && mask.drawn(at) && mask.in_shadow(at);
        });
        const tools::ShadowError e = shadow_error(t, mask, truth->unlit_side);
        std::printf("texel %d/128, %.2f of a leaf's width: %d pixels of shadow, %.3f of the true "
                    "ones, in %d pieces; false light %.3f\n",
                    coarser, coarser / 128.0 / 0.03, seen.pixels,
                    static_cast<double>(seen.pixels) / exact.pixels, seen.pieces,
                    e.false_light_rate());
        false_light.push_back(e.false_light_rate());
        pieces.push_back(seen.pieces);
    }
    // Whole while a leaf is two texels wide; one texel wide, each breaks into pieces; then texels
    // stand for it here and there, as much shadow as before but not where it belongs.
    EXPECT_EQ(pieces[0], exact.pieces);
    EXPECT_EQ(pieces[1], exact.pieces);
    EXPECT_GT(pieces[2], 2 * exact.pieces);
    EXPECT_GT(pieces[3], 2 * exact.pieces);
    for (std::size_t k = 1; k < false_light.size(); ++k)
        EXPECT_GT(false_light[k], false_light[k - 1]);
    EXPECT_LT(false_light[0], 0.1);
    EXPECT_GT(false_light[4], 0.6);
}

}  // namespace
}  // namespace umbra78::claims
