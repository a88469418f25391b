// Spheres and planes as patches: their control points word by word, how near the sphere they are,
// and that neighbours share edges.
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

std::int32_t mul30(std::int64_t a, std::int64_t b) {
    return static_cast<std::int32_t>(
        fixed::test::model_round(Int128{a} * b, Int128{1} << 30, fixed::Rounding::half_even));
}

// Every control point is that of hw/MACHINE.md, section 3. The handle is 4/3 tan(45/4 degrees) in
// Q2.30; the sines of multiples of 45 degrees are 0, +-1 and +-sqrt(1/2).
TEST(SpherePatches, AreTheTextsControlPoints) {
    const double quarter = 3.14159265358979323846 / 16;
    const std::int64_t h = std::lround(std::ldexp(4.0 / 3 * std::tan(quarter), 30));
    const auto s = [](int k) {
        return std::lround(std::ldexp(std::sin(k * 3.14159265358979323846 / 4), 30));
    };
    const auto c = [&](int k) { return s(k + 2); };
    const auto arc = [&](int k, int i) {
        switch (i) {
            case 0: return std::pair{s(k), c(k)};
            case 1: return std::pair{s(k) + mul30(h, c(k)), c(k) - mul30(h, s(k))};
            case 2: return std::pair{s(k + 1) + mul30(-h, c(k + 1)),
                                     c(k + 1) - mul30(-h, s(k + 1))};
            default: return std::pair{s(k + 1), c(k + 1)};
        }
    };
    for (const Sphere sphere : {Sphere{{0, 0, 0}, 1 << 16, 0}, Sphere{{-68813, 39322, 5}, 47186, 3},
                                Sphere{{7, -9, 11}, 2000 << 16, 1}, Sphere{{1, 1, 1}, 3, 2}}) {
        const auto patches = patches_of(sphere);
        for (int n = 0; n < patches_per_sphere; ++n) {
            for (int k = 0; k < 16; ++k) {
                const auto [su, cu] = arc(n % 8, k % 4);
                const auto [sv, cv] = arc(n / 8 - 2, k / 4);
                const World expected{sphere.centre.x + mul30(sphere.radius, mul30(su, cv)),
                                     sphere.centre.y + mul30(sphere.radius, sv),
                                     sphere.centre.z + mul30(sphere.radius, mul30(cu, cv))};
                ASSERT_EQ(patches[static_cast<std::size_t>(n)].control[static_cast<std::size_t>(k)],
                          expected)
                    << "patch " << n << ", control point " << k << ", radius " << sphere.radius;
            }
        }
    }
}

// Every control point is that of hw/MACHINE.md, section 3: p + half_even(v j / 3) with
// p = o + half_even(u i / 3), for every remainder of both signs.
TEST(PlanePatch, IsTheTextsControlPoints) {
    fixed::test::Random random;
    const auto point = [](std::int64_t o, std::int64_t u, std::int64_t v, int i, int j) {
        const auto part = [](std::int64_t edge, int k) {
            return static_cast<std::int64_t>(
                fixed::test::model_round(Int128{edge} * k, 3, fixed::Rounding::half_even));
        };
        return static_cast<std::int32_t>(o + part(u, i) + part(v, j));
    };
    for (int n = 0; n < 3000; ++n) {
        const std::int64_t size = std::int64_t{1} << random.between(1, 29);
        const auto any = [&] { return static_cast<std::int32_t>(random.between(-size, size)); };
        const Plane plane{{any(), any(), any()}, {any(), any(), any()}, {any(), any(), any()}, 5};
        const Patch p = plane_patch(plane);
        ASSERT_EQ(p.material, 5);
        const auto &o = plane.origin, &u = plane.u, &v = plane.v;
        for (int k = 0; k < 16; ++k) {
            const World expected{point(o.x, u.x, v.x, k % 4, k / 4),
                                 point(o.y, u.y, v.y, k % 4, k / 4),
                                 point(o.z, u.z, v.z, k % 4, k / 4)};
            ASSERT_EQ(p.control[static_cast<std::size_t>(k)], expected)
                << "plane " << n << ", control point " << k;
        }
    }
}

}  // namespace
}  // namespace umbra78::raster
