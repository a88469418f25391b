// Blobs: the ellipse against its definition in exact rationals, and the patches against it.
#include "raster/blob.hpp"

#include "fixed/rational.hpp"
#include "tests/fixed/boundary.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace umbra78::raster {
namespace {

using BlobReal = fixed::Rational;

Vector<BlobReal> real_of(const World& a, const World& b) {
    return {BlobReal(std::int64_t{a.x} - b.x), BlobReal(std::int64_t{a.y} - b.y),
            BlobReal(std::int64_t{a.z} - b.z)};
}

World blob_place(fixed::test::Random& random, int reach) {
    const auto word = [&] { return static_cast<std::int32_t>(random.between(-reach, reach)); };
    return {word(), word(), word()};
}

// By Cramer's rule on p - o = s u + t v + h n, whose three products with u, v and n are equations.
TEST(Blob, IsTheEllipseOfTheBoxAlongThePlane) {
    fixed::test::Random random;
    for (int k = 0; k < 300; ++k) {
        const Patch ground = plane_patch({blob_place(random, 1 << 20), blob_place(random, 1 << 18),
                                          blob_place(random, 1 << 18), 0});
        const World& o = ground.control[0];
        const auto u = real_of(ground.control[3], o), v = real_of(ground.control[12], o);
        const auto n = cross(u, v);
        const BlobReal volume = dot(cross(u, v), n);
        if (volume.is_zero()) continue;
        EllipseFit fit(ground);
        std::vector<BlobReal> s, t;
        for (int point = 0; point < 5; ++point) {
            const World p = blob_place(random, 1 << 20);
            fit.add(p);
            const auto w = real_of(p, o);
            s.push_back(dot(cross(w, v), n) / volume);
            t.push_back(dot(cross(u, w), n) / volume);
        }
        Ellipse e;
        if (!fit.fit(e)) continue;
        const auto [s0, s1] = std::minmax_element(s.begin(), s.end());
        const auto [t0, t1] = std::minmax_element(t.begin(), t.end());
        const std::int32_t centre[] = {e.centre.x, e.centre.y, e.centre.z};
        const std::int32_t a[] = {e.a.x, e.a.y, e.a.z}, b[] = {e.b.x, e.b.y, e.b.z};
        const std::int32_t at[] = {o.x, o.y, o.z};
        const BlobReal half(1, 2);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto expect = [&](std::int32_t word, const BlobReal& exact) {
                std::int64_t expected = 0;
                ASSERT_TRUE(exact.round_scaled(0, fixed::Rounding::half_even, expected));
                ASSERT_EQ(word, expected) << k;
            };
            expect(centre[axis],
                   BlobReal(at[axis]) + half * ((*s0 + *s1) * u[axis] + (*t0 + *t1) * v[axis]));
            expect(a[axis], half * (*s1 - *s0) * u[axis]);
            expect(b[axis], half * (*t1 - *t0) * v[axis]);
        }
    }
}

TEST(Blob, OfNothingOrOutOfTheWorldThereIsNone) {
    const Patch ground = plane_patch({{0, 0, 0}, {65536, 0, 0}, {0, 0, -65536}, 0});
    EllipseFit none(ground);
    Ellipse e{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}};
    const Ellipse before = e;
    EXPECT_FALSE(none.fit(e));
    EXPECT_EQ(e, before);
    EllipseFit edge(ground);
    edge.add({max_world, 5, 0});
    edge.add({max_world - 2, 5, 0});
    EXPECT_TRUE(edge.fit(e));
    EXPECT_EQ(e.centre.x, max_world - 1);
    edge.add({max_world + 2, 5, 0});
    EXPECT_FALSE(edge.fit(e));
}

// Corners of the eight patches: the centre, and the rim at every 45 degrees; no point of the rim is
// farther from the ellipse than the arcs are from their circle, 64 times less than 0.027 %.
TEST(Blob, IsDrawnAsEightPatchesAboutItsCentre) {
    const Ellipse e{{1000, -2000, 3000}, {400000, 0, 100000}, {-30000, 0, 250000}};
    std::array<Patch, patches_per_ellipse> patches;
    ellipse_patches(e, patches);
    for (std::size_t m = 0; m < patches.size(); ++m) {
        const auto& c = patches[m].control;
        for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(c[i], e.centre);
        EXPECT_EQ(c[15], patches[(m + 1) % 8].control[12]) << "no gap at the rim";
        for (int step = 0; step <= 8; ++step) {
            const double x = step / 8.0, y = 1 - x;
            const double weights[] = {y * y * y, 3 * x * y * y, 3 * x * x * y, x * x * x};
            double px = 0, pz = 0;
            for (std::size_t i = 0; i < 4; ++i) {
                px += weights[i] * (c[12 + i].x - e.centre.x);
                pz += weights[i] * (c[12 + i].z - e.centre.z);
                EXPECT_EQ(c[12 + i].y, e.centre.y);
            }
            const double area = double(e.a.x) * e.b.z - double(e.a.z) * e.b.x;
            const double s = (px * e.b.z - pz * e.b.x) / area;
            const double t = (pz * e.a.x - px * e.a.z) / area;
            EXPECT_NEAR(std::hypot(s, t), 1, 0.00027 / 64 + 1e-5) << m << ", " << step;
        }
    }
}

}  // namespace
}  // namespace umbra78::raster
