// Solids: their points against the closed form, seams word for word, placing.
#include "raster/solids.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace umbra78::raster {
namespace {

constexpr std::int32_t one = 1 << world_fraction;
using Point = std::array<double, 3>;
using Patches = std::vector<Patch>;

Point in_units(const World& w) { return {w.x / 65536.0, w.y / 65536.0, w.z / 65536.0}; }

// The surface's point in double precision.
Point at(const Patch& patch, double u, double v) {
    const auto weights = [](double t) {
        const double s = 1 - t;
        return std::array{s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
    };
    const auto a = weights(u), b = weights(v);
    Point sum{};
    for (std::size_t n = 0; n < 16; ++n) {
        const Point p = in_units(patch.control[n]);
        for (std::size_t k = 0; k < 3; ++k) sum[k] += a[n % 4] * b[n / 4] * p[k];
    }
    return sum;
}

// The greatest |distance(point)| over 9 x 9 points of every patch.
template <class Distance>
double greatest(const Patches& patches, Distance distance) {
    double most = 0;
    for (const Patch& patch : patches)
        for (int n = 0; n < 81; ++n)
            most = std::max(most, std::abs(distance(at(patch, n % 9 / 8.0, n / 9 / 8.0))));
    return most;
}

template <std::size_t Count, class Make>
Patches made(Make make) {
    std::array<Patch, Count> patches;
    EXPECT_TRUE(make(std::span<Patch, Count>(patches)));
    return {patches.begin(), patches.end()};
}

Patches torus(std::int32_t radius, std::int32_t tube, const Placing& placing = {}) {
    return made<patches_per_torus>(
        [&](auto out) { return torus_patches(radius, tube, placing, out); });
}
Patches wall(std::int32_t base, std::int32_t top, std::int32_t height) {
    return made<patches_round>([&](auto out) { return wall_patches(base, top, height, {}, out); });
}

// A cubic arc of 45 degrees lies up to 4.3e-6 of its radius outside its circle; a word is within
// 2^-17 of its value in each coordinate.
const double arc_error = 4.3e-6, word_error = std::sqrt(3.0) / 131072;

double from_torus(const Point& p, double radius, double tube) {
    return std::hypot(std::hypot(p[0], p[2]) - radius, p[1]) - tube;
}

TEST(Solids, ATorusLiesOnItsSurface) {
    for (const auto& [radius, tube] : {std::pair{2.0, 0.5}, {1.0, 1.0}, {300.25, 100.0}}) {
        const Patches patches =
            torus(static_cast<std::int32_t>(radius * one), static_cast<std::int32_t>(tube * one));
        const double error = greatest(patches, [r = radius, t = tube](const Point& p) {
            return from_torus(p, r, t);  // clang 14 captures no structured binding by name
        });
        EXPECT_LE(error, arc_error * (radius + 2 * tube) + word_error);
        EXPECT_GT(error, 0);
    }
}

// Corners of a torus' patches are the words nearest to the closed form.
TEST(Solids, CornersOfATorusAreTheNearestWords) {
    const Patches patches = torus(2 * one, one / 2);
    for (int q = 0; q < 8; ++q)
        for (int k = 0; k < 8; ++k) {
            const double tube = q * std::acos(-1.0) / 4, round = k * std::acos(-1.0) / 4;
            const double radius = 2 + 0.5 * std::cos(tube);
            const World& corner = patches[static_cast<std::size_t>(8 * q + k)].control[0];
            EXPECT_NEAR(corner.x, 65536 * radius * std::sin(round), 0.501);
            EXPECT_NEAR(corner.y, 65536 * 0.5 * std::sin(tube), 0.501);
            EXPECT_NEAR(corner.z, 65536 * radius * std::cos(round), 0.501);
        }
}

TEST(Solids, AConesWallAndDiscsLieOnTheirSurfaces) {
    const auto wall_distance = [](double base, double top, double height) {
        return [=](const Point& p) {
            return std::hypot(p[0], p[2]) - (base + (top - base) * p[1] / height);
        };
    };
    EXPECT_LE(greatest(wall(3 * one, 3 * one, 5 * one), wall_distance(3, 3, 5)),
              3 * arc_error + 2 * word_error);
    EXPECT_LE(greatest(wall(3 * one, 0, 5 * one), wall_distance(3, 0, 5)),
              3 * arc_error + 2 * word_error);
    EXPECT_LE(greatest(wall(one, 2 * one, one / 2), wall_distance(1, 2, 0.5)),
              2 * arc_error + 4 * word_error);
    const Patches disc = made<patches_round>(
        [](auto out) { return disc_patches(3 * one, 5 * one, {}, out); });
    EXPECT_EQ(greatest(disc, [](const Point& p) { return p[1] - 5; }), 0);
    const auto beyond = [](const Point& p) { return std::max(std::hypot(p[0], p[2]) - 3, 0.0); };
    EXPECT_LE(greatest(disc, beyond),
              3 * arc_error + word_error);
}

// Side s of a patch (0: j = 0, 1: j = 3, 2: i = 0, 3: i = 3), point k of it.
World side(const Patch& patch, int s, int k) {
    const int n = s == 0 ? k : s == 1 ? 12 + k : s == 2 ? 4 * k : 4 * k + 3;
    return patch.control[static_cast<std::size_t>(n)];
}

void expect_seam(const Patch& a, int side_a, const Patch& b, int side_b) {
    for (int k = 0; k < 4; ++k) EXPECT_EQ(side(a, side_a, k), side(b, side_b, k));
}

// Turned by odd angles and moved, patches that meet still have the same words.
TEST(Solids, SeamsAreClosedWordForWord) {
    const Placing odd{{12345, -54321, 777}, rotation_of({1234567, -7654321, 424242})};
    const Patches ring = torus(2 * one + 1, one / 2 + 1, odd);
    for (std::size_t q = 0; q < 8; ++q)
        for (std::size_t k = 0; k < 8; ++k) {
            expect_seam(ring[8 * q + k], 3, ring[8 * q + (k + 1) % 8], 2);
            expect_seam(ring[8 * q + k], 1, ring[8 * ((q + 1) % 8) + k], 0);
        }
    const Patches can = made<patches_round>(
        [&](auto out) { return wall_patches(one + 1, 2 * one - 1, 3 * one, odd, out); });
    const Patches floor =
        made<patches_round>([&](auto out) { return disc_patches(one + 1, 0, odd, out); });
    const Patches lid = made<patches_round>(
        [&](auto out) { return disc_patches(2 * one - 1, 3 * one, odd, out); });
    for (std::size_t k = 0; k < 8; ++k) {
        expect_seam(can[k], 3, can[(k + 1) % 8], 2);
        expect_seam(can[k], 0, floor[k], 1);
        expect_seam(can[k], 1, lid[k], 1);
        for (int n = 0; n < 4; ++n) EXPECT_EQ(side(lid[k], 0, n), side(lid[0], 0, 0));
    }
}

TEST(Solids, ABoxHasSixFlatFacesThatShareTheirEdges) {
    const Placing moved{{10 * one, 20 * one, 30 * one}, rotation_of({})};
    const Patches box = made<patches_per_box>(
        [&](auto out) { return box_patches({2 * one, 3 * one, 5}, moved, out); });
    const auto axis = [](const World& w, std::size_t k) { return std::array{w.x, w.y, w.z}[k]; };
    std::vector<std::array<std::int32_t, 3>> corners;
    for (std::size_t face = 0; face < 6; ++face) {
        for (const World& p : box[face].control)
            EXPECT_EQ(axis(p, face / 2), axis(box[face].control[0], face / 2));
        for (const std::size_t n : {0u, 3u, 12u, 15u}) {
            const World& p = box[face].control[n];
            corners.push_back({p.x, p.y, p.z});
        }
    }
    std::sort(corners.begin(), corners.end());
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    ASSERT_EQ(corners.size(), 8u);
    // 5/2 words beside 30: 2.5 and -2.5 go to the even words.
    EXPECT_EQ(corners.front(), (std::array{9 * one, 18 * one + one / 2, 30 * one - 2}));
    EXPECT_EQ(corners.back(), (std::array{11 * one, 21 * one + one / 2, 30 * one + 2}));
    // Points on an edge are a third apart.
    EXPECT_EQ(box[0].control[1].y - box[0].control[0].y, one);
}

TEST(Solids, APointOutsideTheWorldIsToldOf) {
    std::array<Patch, patches_per_torus> out;
    const std::int32_t reach = 32767 * one;
    EXPECT_TRUE(torus_patches(reach - one, one, {}, out));
    EXPECT_FALSE(torus_patches(reach - one, one + 1, {}, out));
    EXPECT_FALSE(torus_patches(reach, reach, {{reach, -reach, reach}, rotation_of({})}, out));
    std::array<Patch, patches_per_box> box;
    EXPECT_FALSE(box_patches({reach, reach, reach}, {{reach, 0, 0}, rotation_of({})}, box));
    EXPECT_TRUE(box_patches({reach, reach, reach}, {{reach / 2, 0, 0}, rotation_of({})}, box));
}

// Rows of a rotation are of length 1 and at right angles, within the roundings of their words.
TEST(Placing, ARotationIsOrthogonal) {
    for (std::int32_t n = 1; n < 200; ++n) {
        const Rotation r = rotation_of({n * 7919 * 17, n * 104729, -n * 1299709});
        for (std::size_t a = 0; a < 3; ++a)
            for (std::size_t b = 0; b <= a; ++b) {
                double sum = 0;
                for (std::size_t k = 0; k < 3; ++k)
                    sum += std::ldexp(r[a][k], -30) * std::ldexp(r[b][k], -30);
                EXPECT_NEAR(sum, a == b ? 1 : 0, 8e-9);
            }
    }
}

}  // namespace
}  // namespace umbra78::raster
