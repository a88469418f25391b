// Spheres and planes as patches: how near the sphere they are, and that neighbours share edges.
#include "raster/scene.hpp"

#include "tests/raster/exact_surface.hpp"
#include "tests/raster/truth.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace umbra78::raster {
namespace {

using namespace test;

std::array<Patch, patches_per_sphere> patches_of(const Sphere& s) {
    std::array<Patch, patches_per_sphere> p;
    sphere_patches(s, p);
    return p;
}

std::array<Control, 3> coordinates(const Patch& p) {
    std::array<Control, 3> c{};
    for (std::size_t k = 0; k < 16; ++k) {
        c[0][k] = p.control[k].x;
        c[1][k] = p.control[k].y;
        c[2][k] = p.control[k].z;
    }
    return c;
}

// 0.00042 % of the radius outside (a 64th of the arc of 90 degrees), and the words' rounding.
TEST(SpherePatches, StayNearTheSphere) {
    for (const Sphere s : {Sphere{{0, 0, 0}, 1 << 16, 0}, Sphere{{-68813, 39322, 0}, 47186, 3},
                           Sphere{{1, 2, 3}, 1000 << 16, 0}, Sphere{{5, -5, 5}, 16, 1}}) {
        double min = 0, max = 0;
        for (const Patch& patch : patches_of(s)) {
            EXPECT_EQ(patch.material, s.material);
            const auto c = coordinates(patch);
            for (int j = 0; j <= 16; ++j) {
                for (int i = 0; i <= 16; ++i) {
                    const double radius = std::hypot(value(c[0], i, j, 16) - s.centre.x,
                                                     value(c[1], i, j, 16) - s.centre.y,
                                                     value(c[2], i, j, 16) - s.centre.z);
                    min = std::min(min, radius - s.radius);
                    max = std::max(max, radius - s.radius);
                }
            }
        }
        EXPECT_GT(min, -1.5) << "words, radius " << s.radius;
        EXPECT_LT(max, 8.6e-6 * s.radius + 1.5) << "words, radius " << s.radius;
    }
}

TEST(SpherePatches, NeighboursShareTheirEdges) {
    const auto p = patches_of({{12345, -54321, 777}, 98765, 0});
    const auto at = [&](int meridian, int parallel, int i, int j) {
        return p[static_cast<std::size_t>(8 * parallel + (meridian + 8) % 8)]
            .control[static_cast<std::size_t>(4 * j + i)];
    };
    for (int m = 0; m < 8; ++m) {
        for (int q = 0; q < 4; ++q) {
            for (int k = 0; k < 4; ++k) {
                EXPECT_EQ(at(m, q, 3, k), at(m + 1, q, 0, k)) << "meridian " << m;
                if (q == 3) continue;
                EXPECT_EQ(at(m, q, k, 3), at(m, q + 1, k, 0)) << "parallel " << q;
            }
        }
        for (int k = 0; k < 4; ++k) {  // the poles are points
            EXPECT_EQ(at(m, 0, k, 0), (World{12345, -54321 - 98765, 777}));
            EXPECT_EQ(at(m, 3, k, 3), (World{12345, -54321 + 98765, 777}));
        }
    }
}

TEST(PlanePatch, IsEvenlySpacedWithExactCorners) {
    const Plane plane{{100, -200, 300}, {3000, 60, -9}, {-1, 70000, 10}, 5};
    const Patch p = plane_patch(plane);
    EXPECT_EQ(p.material, 5);
    EXPECT_EQ(p.control[0], plane.origin);
    EXPECT_EQ(p.control[3], (World{3100, -140, 291}));
    EXPECT_EQ(p.control[12], (World{99, 69800, 310}));
    EXPECT_EQ(p.control[15], (World{3099, 69860, 301}));
    const auto c = coordinates(p);
    for (int j = 0; j <= 6; ++j) {
        for (int i = 0; i <= 6; ++i) {
            const double u = i / 6.0, v = j / 6.0;
            EXPECT_NEAR(value(c[0], i, j, 6), 100 + 3000 * u - v, 1);
            EXPECT_NEAR(value(c[1], i, j, 6), -200 + 60 * u + 70000 * v, 1);
            EXPECT_NEAR(value(c[2], i, j, 6), 300 - 9 * u + 10 * v, 1);
        }
    }
}

}  // namespace
}  // namespace umbra78::raster
