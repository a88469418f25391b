// The size of a shadow over the lamp's place, against the ratio of similar triangles.
//
// A square of side 0.5 hangs 1 over a floor, straight under a lamp at height H. Its shadow is a
// square H/(H - 1) times as wide. The observer looks straight down: the square hides the middle of
// its shadow, which is counted by the square's own pixels.
#include "tests/claims/drawn.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

namespace umbra78::claims {
namespace {

std::string hanging_square(double height) {
    return "[observer]\nazimuth = 0\nelevation = 90\ntarget = [0, 0, 0]\nextent = 1\n"
           "near = -2\nfar = 2\n"
           "[light]\nkind = \"point\"\nposition = [0, " + std::to_string(height) +
           ", 0]\ntarget = [0, 0, 0]\nextent = 1\n"
           "[[plane]]\norigin = [-1, 0, 1]\nu = [2, 0, 0]\nv = [0, 0, -2]\n"
           "[[plane]]\norigin = [-0.25, 1, 0.25]\nu = [0.5, 0, 0]\nv = [0, 0, -0.5]\n"
           "[settings]\nlookup = \"nearest\"\nbias = 1\nbias_unit = \"texels\"\n";
}

TEST(LampsPlace, MakesTheShadowAsLargeAsSimilarTriangles) {
    double before = 0;
    for (const double height : {8.0, 4.0, 3.0, 2.0, 1.6}) {
        const Drawn drawn(hanging_square(height));
        const auto truth = truth_of(hanging_square(height));
        const auto mask = drawn.mask();
        double machine = 0, exact = 0;
        for (std::size_t at = 0; at < drawn.visible.size(); ++at) {
            const bool square = truth->truth.surface[at] == 1;
            machine += square || (mask.drawn(at) && mask.in_shadow(at));
            exact += square || (truth->truth.visible[at] && !truth->truth.lit[at]);
        }
        const double pixel = 2.0 / 512, ratio = std::sqrt(machine) * pixel / 0.5,
                     by_rule = height / (height - 1);
        std::printf("lamp at height %.1f: shadow %.4f times as wide as what casts it, in truth "
                    "%.4f, by similar triangles %.4f\n",
                    height, ratio, std::sqrt(exact) * pixel / 0.5, by_rule);
        EXPECT_NEAR(std::sqrt(exact) * pixel / 0.5, by_rule, 0.01);
        EXPECT_NEAR(ratio, by_rule, 2 * pixel / 0.5) << "two pixels of its width";
        EXPECT_GT(ratio, before) << "nearer is larger";
        before = ratio;
    }
}

}  // namespace
}  // namespace umbra78::claims
