// A low-passed hard shadow against a real penumbra, and the width of a penumbra over the source's.
//
// A half plane rises over a floor, from 0 at the near end of its edge to 1 at the far end. The
// square source stands 20 over the floor and 10 to the left, so that the edge's shadow falls to the
// right, where the observer, who looks down, sees it whole. The penumbra grows with the height of
// the edge; a low-pass is as wide everywhere.
#include "shadow/filters/ramp.hpp"
#include "tests/claims/drawn.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace umbra78::claims {
namespace {

std::string rising_edge(const std::string& light, const std::string& settings) {
    return "[observer]\nazimuth = 0\nelevation = 90\ntarget = [0.5, 0, 0]\nextent = 2\n"
           "near = -2\nfar = 2\nrecentre = \"off\"\n"
           "[light]\n" + light + "target = [0, 0, 0]\nextent = 3\n"
           "[[plane]]\norigin = [-1.5, 0, 2]\nu = [4, 0, 0]\nv = [0, 0, -4]\n"
           "[[plane]]\norigin = [-1, 0.001, 2]\nu = [1, 0, 0]\nv = [0, 1, -4]\n"
           "[settings]\nxy_bits = 8\n" + settings;
}

std::string source_of(double side, int samples) {
    return "kind = \"area\"\nposition = [-10, 20, 0]\nsize = " + std::to_string(side) +
           "\nsamples = " + std::to_string(samples) + "\n";
}

// A strip of the floor, across the picture: where the edge is about so high.
struct Strip {
    const char* name;
    double from, to;  // heights of the edge
};
constexpr Strip contact{"near contact", 0.06, 0.16}, middle{"the middle", 0.4, 0.6},
    far{"far from the edge", 0.7, 0.85}, whole{"the whole edge", 0.06, 0.85};

// The floor's pixels whose ray to the source's middle passes the edge at such a height: the source
// is at z = 0 and 20 high, the edge as high as (2 - z)/4 at z.
bool in_strip(const tools::Truth& truth, std::size_t at, const Strip& strip) {
    if (!truth.visible[at] || truth.surface[at] != 0 || truth.position[at][0] < 0.01) return false;
    const double z = truth.position[at][2];
    // A point at z sees the edge at z (1 - h/20), which is h = (2 - z (1 - h/20))/4 high.
    const double h = (2 - z) / (4 - z / 20);
    return h >= strip.from && h <= strip.to;
}

// The rms difference over the strip, in shares of the light.
double rms_in(const Strip& strip, const tools::Truth& truth, const tools::MachineMask& mask) {
    double squares = 0;
    int pixels = 0;
    for (std::size_t at = 0; at < truth.visible.size(); ++at) {
        if (!mask.drawn(at) || !in_strip(truth, at, strip)) continue;
        const double light = 1 - mask.shadow[at] / 255.0, share = truth.light_share(at);
        ++pixels;
        squares += (light - share) * (light - share);
    }
    return pixels > 0 ? std::sqrt(squares / pixels) : 0;
}

// Figure 5's settings, of a light without area where the source's middle is.
const std::string figure_five =
    "lookup = \"bilinear\"\ndither = \"normal\"\nbias = 1.5\nbias_unit = \"texels\"\n"
    "dequantize = 1\nlow_pass = 2\n";

constexpr std::array<double, 12> sides{0.35, 0.5, 0.7, 1, 1.4, 2, 2.8, 4, 5.6, 8, 11, 16};

// Two passes of the 3 x 3 binomial have a variance of one pixel: as much as a ramp of 3.5 pixels,
// which here is the penumbra of a source of about 20 * 3.5/64 over the edge's height.
TEST(LowPass, IsThePenumbraOfOneSourceAtOneDistance) {
    const Drawn hard(rising_edge("kind = \"point\"\nposition = [-10, 20, 0]\n", figure_five));
    std::array<double, 4> best{}, least{1, 1, 1, 1}, at_best_of_whole{};
    const Strip strips[] = {contact, middle, far, whole};
    double best_whole = 0;
    for (int pass = 0; pass < 2; ++pass)
        for (const double side : sides) {
            if (pass == 1 && side != best_whole) continue;
            const auto truth = truth_of(rising_edge(source_of(side, 2), figure_five));
            for (std::size_t k = 0; k < 4; ++k) {
                const double rms =
                    rms_in(strips[k], truth->truth, hard.mask(tools::Plane::filtered));
                if (pass == 1) at_best_of_whole[k] = rms;
                if (rms >= least[k]) continue;
                least[k] = rms;
                best[k] = side;
            }
            if (side == sides.back()) best_whole = best[3];
        }
    for (std::size_t k = 0; k < 4; ++k)
        std::printf("figure 5's low-pass, %s (edge %.2f to %.2f high): most like a source of side "
                    "%.2f, rms %.3f; like one of %.2f, rms %.3f\n",
                    strips[k].name, strips[k].from, strips[k].to, best[k], least[k], best_whole,
                    at_best_of_whole[k]);
    // A source as large as is best in the middle is too large near contact and too small far off.
    EXPECT_GT(best[0], 2.5 * best[1]);
    EXPECT_LT(best[2], best[1]);
    // Side times height is the same: that of the low-pass, 3.5/64 * 20, within a step of the sides.
    for (std::size_t k = 0; k < 3; ++k) {
        const double height = (strips[k].from + strips[k].to) / 2;
        EXPECT_NEAR(std::log2(best[k] * height / (3.46 / 64 * 20)), 0, 0.75) << strips[k].name;
    }
    EXPECT_GT(at_best_of_whole[0], 1.3 * least[0]);
}

// Crow's ramp has one width. Around the shadow of the source's middle it is best with a quarter of
// the penumbra's: half of the penumbra lies on the other side of that edge, where the ramp is dark.
TEST(CrowsRamp, FitsAtOneDistanceAndOnOneSide) {
    const std::string settings = "lookup = \"bilinear\"\nbias = 1\nbias_unit = \"texels\"\n";
    constexpr double side = 8;
    const auto truth = truth_of(rising_edge(source_of(side, 1), settings));
    const Strip strips[] = {contact, middle, far};
    std::array<double, 3> hard{}, least{1, 1, 1}, at_best_of_middle{};
    std::array<int, 3> best{};
    std::array<std::array<double, 3>, shadow::max_ramp_px + 1> rms{};
    for (int width = 0; width <= shadow::max_ramp_px; ++width) {
        const Drawn ramped(rising_edge(source_of(side, 1) + "ramp = " + std::to_string(width) +
                                       "\n", settings));
        for (std::size_t k = 0; k < 3; ++k) {
            const double at = rms_in(strips[k], truth->truth, ramped.mask(tools::Plane::filtered));
            rms[static_cast<std::size_t>(width)][k] = at;
            if (width == 0) hard[k] = at;
            if (at >= least[k]) continue;
            least[k] = at;
            best[k] = width;
        }
    }
    at_best_of_middle = rms[static_cast<std::size_t>(best[1])];
    for (std::size_t k = 0; k < 3; ++k)
        std::printf("Crow's ramp, %s (edge %.2f to %.2f high, penumbra %.1f px): best %d px wide, "
                    "rms %.3f; with the middle's %d px %.3f; hard %.3f\n",
                    strips[k].name, strips[k].from, strips[k].to,
                    side / 20 * (strips[k].from + strips[k].to) / 2 * 64, best[k], least[k],
                    best[1], at_best_of_middle[k], hard[k]);
    EXPECT_LT(best[0], best[1]);
    EXPECT_LT(best[1], best[2]);
    EXPECT_LT(least[1], 0.95 * hard[1]);                // it helps where it fits
    EXPECT_GT(least[1], 0.5 * hard[1]);                 // on one side alone
    EXPECT_GT(at_best_of_middle[0], 1.3 * hard[0]);     // and near contact it harms
}

// Mean width of the penumbra, in pixels, across the strip: shares within 5 .. 95 %, over 0.9.
template <class Share>
double penumbra_px(const tools::Truth& truth, const Strip& strip, Share share) {
    std::vector<int> rows(static_cast<std::size_t>(truth.size), -1);
    int between = 0;
    for (std::size_t at = 0; at < truth.visible.size(); ++at) {
        if (!in_strip(truth, at, strip)) continue;
        int& row = rows[at / static_cast<std::size_t>(truth.size)];
        row = 1;
        between += share(at) > 0.05 && share(at) < 0.95;
    }
    return between / 0.9 / static_cast<double>(std::count(rows.begin(), rows.end(), 1));
}

TEST(Penumbra, OfASourceTwiceAsWideIsTwiceAsWide) {
    const std::string settings = "lookup = \"bilinear\"\nbias = 1\nbias_unit = \"texels\"\n";
    for (const Strip& strip : {middle, far}) {
        std::array<double, 2> exact{}, drawn{};
        for (std::size_t k = 0; k < 2; ++k) {
            const double side = k == 0 ? 4 : 8;
            const std::string text = rising_edge(source_of(side, 8), settings);
            const auto truth = truth_of(text);
            const Drawn machine(text);
            const auto mask = machine.job.bytes(tools::Plane::darkness);
            exact[k] = penumbra_px(truth->truth, strip, [&](std::size_t at) {
                return truth->truth.light_share(at);
            });
            drawn[k] = penumbra_px(truth->truth, strip,
                                   [&](std::size_t at) { return 1 - mask[at] / 255.0; });
        }
        std::printf("penumbra of %s, sides 4 and 8: in truth %.1f and %.1f px, drawn %.1f and "
                    "%.1f px: ratios %.3f and %.3f\n", strip.name, exact[0], exact[1], drawn[0],
                    drawn[1], exact[1] / exact[0], drawn[1] / drawn[0]);
        EXPECT_NEAR(exact[1] / exact[0], 2, 0.1);
        EXPECT_NEAR(drawn[1] / drawn[0], 2, 0.25);
        EXPECT_NEAR(drawn[1] / exact[1], 1, 0.15);
    }
}

}  // namespace
}  // namespace umbra78::claims
