// The self-shadow of polygons against that of the curved surface: the figures' spheres diced into
// triangles, and subdivided to the pixel. Truth is that of the spheres.
#include "tests/claims/ground.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <numbers>
#include <span>
#include <string>
#include <vector>

namespace umbra78::claims {
namespace {

// The surfaces' own shadow lines: where the normal is within 15 degrees of being at right angles
// to the light, and nothing but the sphere itself can shadow the pixel.
bool at_the_line(const tools::Truth& t, std::size_t at) {
    const bool cast = t.n_dot_l[at] > 0 && !t.lit[at];
    return t.visible[at] && !cast && std::abs(t.n_dot_l[at]) < 0.26;
}

struct LineErrors {
    int pixels = 0, wrong = 0;
    double ragged_px = 0;  // mean over the rows of a line, of the pixels between first and last
    double least = 1, most = 0;  // of the rates of several lights
    double swing() const { return most - least; }
    double rate() const { return pixels > 0 ? static_cast<double>(wrong) / pixels : 0; }
};

// The light is on the left: a row of a sphere is lit up to the line, and dark from there on. It is
// ragged from its first dark pixel to its last lit one.
LineErrors line_errors(const Machine& machine, const tools::Truth& t) {
    const auto mask = machine.compared();
    LineErrors e;
    int lines = 0;
    for (int y = 0; y < t.size; ++y)
        for (std::int32_t sphere = 0; sphere < 4; ++sphere) {
            int first_dark = t.size, last_lit = -1;
            bool any = false;
            for (int x = 0; x < t.size; ++x) {
                const std::size_t at = static_cast<std::size_t>(y) * t.size + x;
                if (t.surface[at] != sphere || !at_the_line(t, at) || machine.visible[at] == 0)
                    continue;
                any = true;
                ++e.pixels;
                e.wrong += mask.in_shadow(at) == (t.lit[at] != 0);
                if (mask.in_shadow(at)) first_dark = std::min(first_dark, x);
                else last_lit = x;
            }
            if (!any) continue;
            ++lines;
            e.ragged_px += std::max(last_lit - first_dark + 1, 0);
        }
    e.ragged_px /= lines;
    return e;
}

// Over lights from eight azimuths in 24 degrees, half a facet's angle of the coarsest level and
// more than one of the others: a crease that is near the true line by chance counts for little.
LineErrors mean_line(const std::string& name, const Settings& s, std::span<const Ground> grounds) {
    LineErrors sum;
    for (const Ground& g : grounds) {
        const double back_x = g.light.direction[0], back_z = g.light.direction[2];
        const double azimuth = std::atan2(back_x, back_z) * 180 / std::numbers::pi;
        const LineErrors e =
            line_errors(Machine(s, static_cast<int>(std::lround(azimuth))), g.truth);
        sum.pixels += e.pixels;
        sum.wrong += e.wrong;
        sum.least = std::min(sum.least, e.rate());
        sum.most = std::max(sum.most, e.rate());
        sum.ragged_px += e.ragged_px / static_cast<double>(grounds.size());
    }
    std::printf("%s: the spheres' own shadow lines are ragged over %.2f px; of the pixels about "
                "them %.3f are wrong, from %.3f to %.3f over the lights\n",
                name.c_str(), sum.ragged_px, sum.rate(), sum.least, sum.most);
    return sum;
}

// A polyhedron's shadow line lies on creases and jumps from one to the next as the light turns, now
// near the true line, now half a facet away. On the mean it is no worse than the curved surface's
// line, which the bias moves; but how wrong it is depends on the light. Fine facets are the curved
// surface.
TEST(Polygons, TheirOwnShadowLineJumpsWhereTheCurvedOneMoves) {
    std::vector<Ground> grounds;
    for (int azimuth = -100; azimuth <= -79; azimuth += 3) grounds.emplace_back(azimuth);
    for (const int figure : {3, 4}) {
        Settings s = shadow::figure_settings(figure);
        const std::string of = "figure " + std::to_string(figure) + ", ";
        const LineErrors curved = mean_line(of + "curved", s, grounds);
        s.surface = raster::PatchForm::diced;
        std::array<LineErrors, 6> diced{};
        for (int levels = 0; levels <= 5; ++levels) {
            s.dice_levels = levels;
            const LineErrors e =
                mean_line(of + "diced with " + std::to_string(levels) + " levels", s, grounds);
            EXPECT_NEAR(e.rate() / curved.rate(), 1, 0.15) << "on the mean";
            diced[static_cast<std::size_t>(levels)] = e;
        }
        EXPECT_GT(curved.pixels, 100000);
        EXPECT_GT(diced[0].swing(), 3 * curved.swing());
        EXPECT_GT(diced[1].swing(), 3 * curved.swing());
        EXPECT_LT(diced[5].swing(), 1.5 * curved.swing());
        EXPECT_NEAR(diced[5].rate() / curved.rate(), 1, 0.05);
    }
}

}  // namespace
}  // namespace umbra78::claims
