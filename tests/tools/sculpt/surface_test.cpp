// Surfaces of revolution, tubes and lofts against their closed forms.
#include "tools/sculpt/surface.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace umbra78::tools {
namespace {

constexpr double quarter_error = 2.8e-4;  // of a quarter circle's radius, by its handles

// All points of a surface, on a grid in each patch.
template <class Visit>
void walk(const Surface& surface, Visit visit) {
    for (const Net& net : surface)
        for (int j = 0; j <= 8; ++j)
            for (int i = 0; i <= 8; ++i) visit(point_on(net, i / 8., j / 8.));
}

TEST(Sculpt, AnArcIsACircleToItsError) {
    for (const int arcs : {4, 8}) {
        const Chain chain = circle(arcs);
        EXPECT_EQ(chain.size(), 3u * arcs + 1);
        EXPECT_EQ(chain.front(), chain.back());
        double worst = 0;
        walk(lathe(Pen(1, 0).line(1, 1), chain), [&](Point p) {
            worst = std::max(worst, std::abs(std::hypot(p.x, p.z) - 1));
        });
        EXPECT_LT(worst, arcs == 4 ? quarter_error : quarter_error / 50);
        EXPECT_GT(worst, 0);
    }
}

TEST(Sculpt, AnEllipsoidFulfilsItsEquation) {
    const Surface surface = ellipsoid(2, 0.5, 1.25);
    EXPECT_EQ(surface.size(), 8u);
    walk(surface, [](Point p) {
        const double r = std::hypot(p.x / 2, p.y / 0.5, p.z / 1.25);
        EXPECT_NEAR(r, 1, 2 * quarter_error);
    });
}

TEST(Sculpt, ALimbIsAConeBetweenTwoHemispheres) {
    const Point from{1, 2, 3}, to{2, 4, 5};  // 3 apart
    walk(limb(from, to, 0.5, 0.2), [&](Point p) {
        const double t = dot(p - from, to - from) / 3, far = length(p - from);
        const double aside = std::sqrt(std::max(0., far * far - t * t));
        const double error = t < 0   ? far - 0.5
                             : t > 3 ? length(p - to) - 0.2
                                     : aside - (0.5 - 0.1 * t);
        EXPECT_NEAR(error, 0, 3e-4);
    });
}

TEST(Sculpt, ABentTubeIsATorus) {
    const Surface surface = ring(2, 0.5, 8);
    EXPECT_EQ(surface.size(), 32u);
    walk(surface, [](Point p) {
        EXPECT_NEAR(std::hypot(std::hypot(p.x, p.z) - 2, p.y), 0.5, 3e-4);
    });
    // An eighth of a turn in a plane that stands askew.
    const Point centre{1, -1, 2}, a{0.6, 0.8, 0}, b{0, 0, 1}, axis = cross(a, b);
    walk(tube(arc(centre, a, b, 3, 45, 1), {0.7, 0.7}), [&](Point p) {
        const double height = dot(p - centre, axis);
        const double out = length(p - centre - height * axis);
        EXPECT_NEAR(std::hypot(out - 3, height), 0.7, 3e-4);
    });
}

TEST(Sculpt, AStraightTubeIsACone) {
    walk(tube(Pen(0, 0).line(0, 2).line(0, 5), {1, 0.6, 0.6}), [](Point p) {
        const double radius = p.y < 2 ? 1 - 0.2 * p.y : 0.6;
        EXPECT_NEAR(std::hypot(p.x, p.z), radius, quarter_error);
    });
}

TEST(Sculpt, ALoftPassesThroughItsSectionsSmoothly) {
    std::vector<Chain> sections;
    for (int k = 0; k < 4; ++k) {
        Chain chain = circle(4);
        for (Point& p : chain) p = {(1 + k % 2) * p.x, 2. * k, p.z};
        sections.push_back(chain);
    }
    const Surface surface = loft(sections);
    ASSERT_EQ(surface.size(), 12u);
    for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t q = 0; q < 4; ++q)
            for (std::size_t i = 0; i < 4; ++i) {
                EXPECT_EQ(surface[4 * k + q][i], sections[k][3 * q + i]);
                EXPECT_EQ(surface[4 * k + q][12 + i], sections[k + 1][3 * q + i]);
            }
    // The handles on both sides of a section are one straight line, of equal lengths.
    for (std::size_t n = 0; n < 8; ++n)
        for (std::size_t i = 0; i < 4; ++i) {
            const Net &before = surface[n], &after = surface[n + 4];
            EXPECT_LT(length(before[12 + i] - before[8 + i] - (after[4 + i] - after[i])), 1e-12);
        }
}

// A quarter with the handle h passes through ((4 + 3 h) / 8, (4 + 3 h) / 8).
TEST(Sculpt, ABoxBulgesAsItsHandleSays) {
    const double h = 0.8, c = (4 + 3 * h) / 8;
    for (const Net& net : rounded_box(1, 2, 3, h)) {
        const Point corner = point_on(net, 0.5, 0.5);
        EXPECT_NEAR(std::abs(corner.x), c * c, 1e-12);
        EXPECT_NEAR(std::abs(corner.y), 2 * c, 1e-12);
        EXPECT_NEAR(std::abs(corner.z), 3 * c * c, 1e-12);
    }
    walk(rounded_box(1, 1, 1, h), [](Point p) {
        EXPECT_LE(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}), 1 + 1e-12);
        EXPECT_GE(length(p), 1 - 1e-12);
    });
}

TEST(Sculpt, APlacementScalesTurnsAboutXYZAndMoves) {
    const auto near = [](Point a, Point b) { EXPECT_LT(length(a - b), 1e-12); };
    near(placed(Point{1, 2, 3}, {{10, 20, 30}, {}, {2, 1, 0}}), {12, 22, 30});
    near(placed(Point{0, 1, 0}, {{}, {90, 0, 0}}), {0, 0, 1});
    near(placed(Point{0, 0, 1}, {{}, {0, 90, 0}}), {1, 0, 0});
    near(placed(Point{1, 0, 0}, {{}, {0, 0, 90}}), {0, 1, 0});
    near(placed(Point{0, 1, 0}, {{}, {90, 90, 90}}), {0, 1, 0});
}

}  // namespace
}  // namespace umbra78::tools
