// The planar shadow's exact matrix against the line from the light through a point, cut with the
// plane, in exact rationals.
#include "raster/planar.hpp"

#include "tests/fixed/boundary.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <vector>

namespace umbra78::raster {
namespace {

using fixed::test::Random;
using ExactPlace = Vector<Rational>;

ExactPlace exact_place(const World& p) {
    return {Rational(p.x, 65536), Rational(p.y, 65536), Rational(p.z, 65536)};
}
ExactPlace less(const ExactPlace& a, const ExactPlace& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
ExactPlace along_line(const ExactPlace& p, const ExactPlace& way, const Rational& t) {
    return {p[0] + t * way[0], p[1] + t * way[1], p[2] + t * way[2]};
}

using Homogeneous = std::array<Rational, 4>;
Homogeneous moved(const RationalMatrix& m, const ExactPlace& p) {
    Homogeneous out;
    for (std::size_t r = 0; r < 4; ++r)
        out[r] = m[r][0] * p[0] + m[r][1] * p[1] + m[r][2] * p[2] + m[r][3];
    return out;
}

struct GroundCase {
    std::vector<Patch> patches;
    View observer, light;

    ExactPlace o() const { return exact_place(patches[0].control[0]); }
    ExactPlace n() const {
        return cross(less(exact_place(patches[0].control[3]), o()),
                     less(exact_place(patches[0].control[12]), o()));
    }
    ExactPlace way_to_light(const ExactPlace& p) const {
        return has_eye(light) ? less(origin(light), p) : exact(light.axes.back);
    }
    // The height of a point over that of the light, or over the light's direction.
    Rational share(const ExactPlace& p) const {
        const ExactPlace from = has_eye(light) ? less(origin(light), o()) : exact(light.axes.back);
        return dot(n(), less(p, o())) / dot(n(), from);
    }
};

View random_view(Random& random, bool eye) {
    View v;
    v.projection = eye ? Projection::perspective : Projection::orthographic;
    v.axes = axes_from_angles(static_cast<std::int32_t>(random.between(-180, 180)) * 65536,
                              static_cast<std::int32_t>(random.between(-80, 80)) * 65536);
    v.extent = 4 << 16;
    v.distance = eye ? static_cast<std::int32_t>(random.between(3, 12)) << 16 : 0;
    v.near_depth = eye ? 1 << 15 : -(8 << 16);
    v.far_depth = 20 << 16;
    return v;
}

World random_point(Random& random) {
    const auto word = [&] { return static_cast<std::int32_t>(random.between(-300000, 300000)); };
    return {word(), word(), word()};
}

std::optional<GroundCase> random_case(Random& random, int k) {
    GroundCase c;
    for (int patches = 0; patches < 2; ++patches) {
        const World o = random_point(random), u = random_point(random), v = random_point(random);
        c.patches.push_back(plane_patch({o, u, v, 0}));
    }
    c.observer = random_view(random, k % 2 != 0);
    c.light = random_view(random, k / 2 % 2 != 0);
    if (dot(c.n(), has_eye(c.light) ? less(origin(c.light), c.o()) : exact(c.light.axes.back))
            .is_zero())
        return {};
    return c;
}

// X, Y and W are those of the observer for the point where the line meets the plane, and W has the
// sign of both: the point's shadow lies before the observer's eye, and the point before the lamp.
TEST(PlanarShadow, IsTheObserversViewOfTheLinesEnd) {
    Random random;
    const MachineSpec spec;
    int behind = 0;
    for (int k = 0; k < 400; ++k) {
        const std::optional<GroundCase> c = random_case(random, k);
        if (!c) continue;
        RationalMatrix m;
        ASSERT_TRUE(planar_shadow(c->observer, c->light, c->patches, 0, spec, m));
        const ExactPlace p = exact_place(random_point(random));
        const ExactPlace way = c->way_to_light(p);
        const Rational fall = dot(c->n(), way);
        if (fall.is_zero()) continue;  // its shadow is at infinity
        const ExactPlace foot = along_line(p, way, -(dot(c->n(), less(p, c->o())) / fall));
        const Homogeneous seen = moved(world_to_screen(c->observer, spec), foot);
        const Homogeneous got = moved(m, p);
        ASSERT_EQ(got[0] * seen[3], seen[0] * got[3]) << k;
        ASSERT_EQ(got[1] * seen[3], seen[1] * got[3]) << k;
        const bool anti = has_eye(c->light) && c->share(p) > Rational(1);
        ASSERT_EQ(got[3].is_negative(), seen[3].is_negative() != anti) << k;
        behind += anti;
    }
    EXPECT_GT(behind, 20);
}

// Z is before the near plane where the point lies below the ground, and beyond the far one from
// 64/65 of a lamp's height on.
TEST(PlanarShadow, DepthIsTheHeightOverTheGround) {
    Random random;
    const MachineSpec spec;
    const Rational half = spec.half_px();
    int below = 0, above = 0;
    for (int k = 0; k < 400; ++k) {
        std::optional<GroundCase> c = random_case(random, k);
        if (!c) continue;
        const World point = random_point(random);
        c->patches[1].control.fill(point);  // the highest, if it is above the ground
        RationalMatrix m;
        ASSERT_TRUE(planar_shadow(c->observer, c->light, c->patches, 0, spec, m));
        const ExactPlace p = exact_place(point);
        const Homogeneous got = moved(m, p);
        const Rational share = c->share(p);
        ASSERT_EQ((got[2] + half * got[3]).is_negative(), share.is_negative()) << k;
        below += share.is_negative();
        if (has_eye(c->observer) || share.is_negative()) continue;
        const bool lamp = has_eye(c->light);
        const bool beyond = half * got[3] < got[2];
        ASSERT_EQ(beyond, lamp && share > Rational(64, 65)) << k;
        above += beyond;
        if (!lamp && share > Rational(0)) {
            ASSERT_TRUE(got[2].is_zero()) << "half of the depth " << k;
        }
    }
    EXPECT_GT(below, 50);
    EXPECT_GT(above, 10);
}

// The text's example.
TEST(PlanarShadow, ALampOverAFloor) {
    GroundCase c;
    c.patches = {plane_patch({{-3 << 16, 0, 3 << 16}, {6 << 16, 0, 0}, {0, 0, -6 << 16}, 0})};
    c.observer.axes = axes_from_angles(0, 90 << 16);
    c.observer.extent = 4 << 16;
    c.observer.near_depth = -(4 << 16);
    c.observer.far_depth = 4 << 16;
    c.light.projection = Projection::perspective;
    c.light.extent = c.light.distance = 4 << 16;
    ASSERT_TRUE(axes_from_points({0, 4 << 16, 0}, {0, 0, 0}, c.light.axes));
    const MachineSpec spec;
    RationalMatrix m;
    ASSERT_TRUE(planar_shadow(c.observer, c.light, c.patches, 0, spec, m));
    const Homogeneous got = moved(m, exact_place({1 << 16, 3 << 16, 1 << 16}));
    EXPECT_EQ(got[3], Rational(1, 4));
    EXPECT_EQ(got[0] / got[3], Rational(256)) << "x = 4 is the picture's edge";
    EXPECT_EQ(got[1] / got[3], Rational(256)) << "and z = 4 its lower one";
    EXPECT_TRUE(moved(m, exact_place({1 << 16, 5 << 16, 1 << 16}))[3].is_negative());
    c.light.distance = 0;
    const RationalMatrix before = m;
    EXPECT_FALSE(planar_shadow(c.observer, c.light, c.patches, 0, spec, m));
    EXPECT_EQ(m[0][0], before[0][0]);
}

}  // namespace
}  // namespace umbra78::raster
