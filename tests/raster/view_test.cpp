// Views: frames, and matrices as exact rationals.
#include "raster/view.hpp"

#include "tests/fixed/boundary.hpp"
#include "tests/raster/truth.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace umbra78::raster {
namespace {

using namespace test;
using fixed::test::Random;
using umbra78::test::orthographic;
using umbra78::test::perspective;
using umbra78::test::q16;

double value(const Rational& r) {
    std::int64_t word = 0;
    const int shift = r.is_zero() ? 0 : 50 - r.floor_log2();
    EXPECT_TRUE(r.round_scaled(shift, fixed::Rounding::half_even, word));
    return std::ldexp(static_cast<double>(word), -shift);
}

// Greatest deviation of the frame's six dot products from those of an orthonormal one.
double skew(const ViewAxes& f) {
    const std::array axes{axis3(f.right), axis3(f.up), axis3(f.back)};
    double worst = 0;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = i; j < 3; ++j)
            worst = std::max(worst, std::abs(dot3(axes[i], axes[j]) - (i == j ? 1 : 0)));
    return worst;
}

double determinant(const ViewAxes& f) {
    const Vector3 r = axis3(f.right), u = axis3(f.up), b = axis3(f.back);
    return r[0] * (u[1] * b[2] - u[2] * b[1]) - r[1] * (u[0] * b[2] - u[2] * b[0]) +
           r[2] * (u[0] * b[1] - u[1] * b[0]);
}

constexpr double q30 = 1.0 / (1 << 30);

World random_world(Random& random, int shift) {
    const auto word = [&] { return static_cast<std::int32_t>(random.bits() >> 32) >> shift; };
    return {word(), word(), word()};
}

// The lights of a square source stand in the middles of n x n equal cells: as far to the left of
// its middle as to the right, a cell apart; a byte of noise puts one within its cell.
TEST(AreaPlaces, AreTheCellsOfTheSource) {
    for (int n = 1; n <= 8; ++n) {
        int sum = 0;
        for (int i = 0; i < n; ++i) {
            const AreaPlace at = middle_of_cell(n, i, n - 1 - i);
            sum += at.right;
            EXPECT_EQ(at.over, 2 * n);
            EXPECT_EQ(at.up, -at.right);
            EXPECT_EQ(at.right - middle_of_cell(n, 0, 0).right, 2 * i);
            const AreaPlace first = noise_in_cell(n, i, 0, 0, 255);
            const AreaPlace last = noise_in_cell(n, i, 0, 255, 0);
            EXPECT_EQ(first.over, 512 * n);
            EXPECT_EQ(first.right + last.right, 2 * 256 * at.right) << "about the cell's middle";
            EXPECT_EQ(last.right - first.right, 510);
            EXPECT_EQ(first.up - last.up, 510);
        }
        EXPECT_EQ(sum, 0);
    }
}

TEST(ViewAxes, IsOrthonormalWithinAFewUnits) {
    Random random;
    double worst_angles = 0, worst_points = 0;
    for (int n = 0; n < 20000; ++n) {
        const auto azimuth = static_cast<std::int32_t>(random.between(-360 * 65536, 360 * 65536));
        const auto elevation = static_cast<std::int32_t>(random.between(-90 * 65536, 90 * 65536));
        const ViewAxes a = axes_from_angles(azimuth, elevation);
        worst_angles = std::max(worst_angles, skew(a));
        ASSERT_NEAR(determinant(a), 1, 1e-8);
        const int shift = static_cast<int>(random.between(0, 28));
        const World from = random_world(random, shift), to = random_world(random, shift);
        ViewAxes p;
        if (!axes_from_points(from, to, p)) continue;
        worst_points = std::max(worst_points, skew(p));
        ASSERT_NEAR(determinant(p), 1, 1e-8);
        const Vector3 away = along(world3(from), -1, world3(to));
        const double cosine = dot3(unit3(away), axis3(p.back));
        ASSERT_NEAR(cosine, 1, 1e-8);
        ASSERT_EQ(p.right[1], 0) << "right is level";
        ASSERT_GE(p.up[1], 0) << "up is up";
    }
    std::cout << "[ measured ] frames are orthonormal within " << worst_angles / q30
              << " (angles) and " << worst_points / q30 << " (points) units of 2^-30\n";
    EXPECT_LT(worst_angles, 4 * q30);
    EXPECT_LT(worst_points, 12 * q30);
}

TEST(ViewAxes, LooksWhereItIsTold) {
    constexpr std::int32_t one = 1 << 30;
    const ViewAxes front = axes_from_angles(0, 0);
    EXPECT_EQ(front.right, (Axis{one, 0, 0}));
    EXPECT_EQ(front.up, (Axis{0, one, 0}));
    EXPECT_EQ(front.back, (Axis{0, 0, one}));
    EXPECT_EQ(axes_from_angles(q16(90), 0).back, (Axis{one, 0, 0})) << "azimuth is to the right";
    EXPECT_EQ(axes_from_angles(0, q16(90)).back, (Axis{0, one, 0}));
    EXPECT_EQ(axes_from_angles(0, q16(90)).up, (Axis{0, 0, -one}));

    ViewAxes f;
    EXPECT_FALSE(axes_from_points({1, 2, 3}, {1, 2, 3}, f));
    ASSERT_TRUE(axes_from_points({5, 9, -7}, {5, 2, -7}, f)) << "straight above";
    EXPECT_EQ(f.back, (Axis{0, one, 0}));
    EXPECT_EQ(f.right, (Axis{one, 0, 0}));
    EXPECT_EQ(f.up, (Axis{0, 0, -one}));
    ASSERT_TRUE(axes_from_points({5, 1, -7}, {5, 2, -7}, f)) << "straight below";
    EXPECT_EQ(f.back, (Axis{0, -one, 0}));
    EXPECT_EQ(f.up, (Axis{0, 0, one}));
    ASSERT_TRUE(axes_from_points({INT32_MAX, INT32_MAX, INT32_MAX},
                                  {INT32_MIN, INT32_MIN, INT32_MIN}, f)) << "33-bit differences";
    EXPECT_NEAR(f.back[0] * q30, std::sqrt(1 / 3.0), 2 * q30);
    // The same direction by angles and by points.
    const ViewAxes angles = axes_from_angles(q16(-100), q16(30));
    const auto back = axis3(angles.back);
    ASSERT_TRUE(axes_from_points({q16(20000 * back[0]), q16(20000 * back[1]),
                                   q16(20000 * back[2])}, {}, f));
    for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_NEAR(f.right[k] * q30, angles.right[k] * q30, 1e-8);
        EXPECT_NEAR(f.up[k] * q30, angles.up[k] * q30, 1e-8);
    }
}

void expect_inverse(const View& view, const MachineSpec& spec, double tolerance) {
    const RationalMatrix m = multiply(world_to_screen(view, spec), screen_to_world(view, spec));
    const Rational one = m[3][3];
    ASSERT_FALSE(one.is_zero());
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = 0; j < 4; ++j) {
            const Rational off = m[i][j] / one - Rational(i == j ? 1 : 0);
            if (tolerance == 0) {
                EXPECT_TRUE(off.is_zero()) << i << ", " << j;
            } else {
                EXPECT_NEAR(value(off), 0, tolerance) << i << ", " << j;
            }
        }
    }
}

// Where sines are exact the product is the identity exactly; elsewhere within the frame's skew,
// in pixels of a frame of 512.
TEST(View, ScreenToWorldIsTheInverse) {
    const MachineSpec spec;
    for (const double azimuth : {0.0, 90.0, 180.0, -90.0}) {
        for (const double elevation : {0.0, 90.0, -90.0}) {
            View v = orthographic(azimuth, elevation, 1.7);
            v.target = {q16(0.3), q16(-2), q16(11)};
            v.near_depth = q16(-3);
            v.far_depth = q16(5.5);
            expect_inverse(v, spec, 0);
            v = perspective(azimuth, elevation, 1.7, 6, 0.25, 77);
            v.target = {q16(0.3), q16(-2), q16(11)};
            expect_inverse(v, spec, 0);
        }
    }
    Random random;
    for (int n = 0; n < 50; ++n) {
        const double azimuth = static_cast<double>(random.between(-180, 180)) + 0.3;
        const double elevation = static_cast<double>(random.between(-89, 89)) + 0.7;
        expect_inverse(orthographic(azimuth, elevation, 2), spec, 256 * 6 * q30);
        expect_inverse(perspective(azimuth, elevation, 2, 8, 1, 30), spec, 256 * 60 * q30);
    }
}

struct Screen {
    double x, y, z;
};
Screen project(const View& view, const MachineSpec& spec, const Vector3& p) {
    const RationalMatrix m = world_to_screen(view, spec);
    std::array<double, 4> out{};
    for (std::size_t r = 0; r < 4; ++r)
        out[r] = value(m[r][0]) * p[0] + value(m[r][1]) * p[1] + value(m[r][2]) * p[2] +
                 value(m[r][3]);
    return {out[0] / out[3], out[1] / out[3], out[2] / out[3]};
}

// The cube: half its edge from the target to each of its six sides.
TEST(View, AnOrthographicViewIsACube) {
    MachineSpec spec;
    View v = orthographic(0, 0, 2);
    v.target = {q16(1), q16(2), q16(3)};
    const Screen right = project(v, spec, {3, 2, 3}), top = project(v, spec, {1, 4, 3});
    const Screen near = project(v, spec, {1, 2, 5}), far = project(v, spec, {1, 2, 1});
    EXPECT_DOUBLE_EQ(right.x, 256);
    EXPECT_DOUBLE_EQ(top.y, -256) << "y down";
    EXPECT_DOUBLE_EQ(near.z, -256) << "z away";
    EXPECT_DOUBLE_EQ(far.z, 256);
}

// Near is code 0 and far 2^z, whatever lies between; the target's window is the frame.
TEST(View, NearAndFarAreTheEndsOfZ) {
    MachineSpec spec;
    View v = perspective(0, 0, 1.5, 6, 2, 40);
    EXPECT_NEAR(project(v, spec, {0, 0, 6 - 2}).z, -256, 1e-9) << "code 0";
    EXPECT_NEAR(project(v, spec, {0, 0, 6 - 40}).z, 256, 1e-9) << "2^z";
    EXPECT_NEAR(project(v, spec, {1.5, 0, 0}).x, 256, 1e-9);
    EXPECT_NEAR(project(v, spec, {0, 3, -6}).y, -256, 1e-9) << "twice as far, twice as wide";
    v = orthographic(0, 0, 2);
    v.near_depth = q16(-1);
    v.far_depth = q16(7);
    EXPECT_NEAR(project(v, spec, {0, 0, 1}).z, -256, 1e-9);
    EXPECT_NEAR(project(v, spec, {0, 0, -7}).z, 256, 1e-9);
}

// What the two views see of a point is what observer_to_light says, less the bias.
TEST(View, ObserverToLightCarriesTheBias) {
    const MachineSpec spec;
    const View observer = perspective(20, 10, 2, 9, 2, 30);
    for (const View& light : {orthographic(-100, 30, 3), perspective(-70, 40, 2.5, 12, 3, 50)}) {
        const Vector3 p{0.4, -0.7, 1.1};
        const Screen from = project(observer, spec, p), expected = project(light, spec, p);
        const RationalMatrix m = observer_to_light(observer, light, spec, 24 << 15);  // 12 quanta
        std::array<double, 4> out{};
        for (std::size_t r = 0; r < 4; ++r)
            out[r] = value(m[r][0]) * from.x + value(m[r][1]) * from.y + value(m[r][2]) * from.z +
                     value(m[r][3]);
        EXPECT_NEAR(out[0] / out[3], expected.x, 1e-5);
        EXPECT_NEAR(out[1] / out[3], expected.y, 1e-5);
        EXPECT_NEAR(out[2] / out[3], expected.z - 12 / 128.0, 1e-5);
    }
}

TEST(View, DepthIsFittedToTheScene) {
    umbra78::test::Patches patches;
    umbra78::test::add_sphere(patches, umbra78::test::sphere(0, 0, 3, 1));
    View v = orthographic(0, 0, 2);
    const DepthRange o = depth_range(v, patches);
    EXPECT_EQ(o.min, q16(-4));
    EXPECT_EQ(o.max, q16(-2));
    fit_depth(v, o);
    EXPECT_EQ(v.near_depth, q16(-4)) << "the scene reaches out of the cube";
    EXPECT_EQ(v.far_depth, q16(4));
    fit_depth(v, {q16(-1), q16(1)});
    EXPECT_EQ(v.far_depth, q16(2)) << "the cube";

    v = perspective(0, 0, 2, 10, 1, 2);
    const DepthRange p = depth_range(v, patches);
    EXPECT_EQ(p.min, q16(6));
    EXPECT_EQ(p.max, q16(8));
    fit_depth(v, p);
    EXPECT_LT(v.near_depth, p.min);
    EXPECT_GT(v.near_depth, p.min * 62 / 64);
    EXPECT_GT(v.far_depth, p.max);
    fit_depth(v, {q16(-5), q16(20)});  // behind the eye
    EXPECT_EQ(v.near_depth, v.far_depth / 1024);
    fit_depth(v, {q16(-5), q16(-1)});  // all behind it
    EXPECT_GT(v.near_depth, 0);
    EXPECT_GT(v.far_depth, v.near_depth);
}

}  // namespace
}  // namespace umbra78::raster
