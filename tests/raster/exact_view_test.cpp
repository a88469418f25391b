// Views word by word: axes, depth ranges, near and far, and the eye as shading needs it are those
// of hw/MACHINE.md, sections 4 and 9, in 128-bit integers.
#include "fixed/sine.hpp"
#include "raster/shading.hpp"
#include "raster/view.hpp"
#include "tests/raster/exact_drawing.hpp"
#include "tests/support/effort.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace umbra78::raster {
namespace {

using namespace test;
using fixed::Rounding;
using fixed::test::model_round;
using umbra78::test::effort;

std::int32_t mul30(std::int64_t a, std::int64_t b) {
    return static_cast<std::int32_t>(model_round(Int128{a} * b, power(30), Rounding::half_even));
}

// Of a vector that is not 0.
Axis unit30(std::array<std::int64_t, 3> v) {
    const int bits = bits_of(std::max({magnitude(v[0]), magnitude(v[1]), magnitude(v[2])}));
    const int down = bits - 30;
    Int128 squares = 0;
    ExactVector w{};
    for (std::size_t k = 0; k < 3; ++k) {
        w[k] = down > 0 ? model_round(v[k], power(down), Rounding::half_even)
                        : v[k] * power(-down);
        squares += w[k] * w[k];
    }
    Axis out{};
    for (std::size_t k = 0; k < 3; ++k)
        out[k] = static_cast<std::int32_t>(
            model_round(w[k] * power(30), exact_root(squares), Rounding::half_even));
    return out;
}

World random_world(Random& random, int shift) {
    const auto word = [&] { return static_cast<std::int32_t>(random.bits() >> 32) >> shift; };
    return {word(), word(), word()};
}

TEST(ViewAxes, FromAnglesAreTheTexts) {
    Random random;
    for (int n = 0; n < effort(20000); ++n) {
        const auto azimuth = static_cast<std::int32_t>(random.between(-360 * 65536, 360 * 65536));
        const auto elevation = static_cast<std::int32_t>(random.between(-90 * 65536, 90 * 65536));
        const auto a = fixed::sine_cosine(azimuth), e = fixed::sine_cosine(elevation);
        const ViewAxes axes = axes_from_angles(azimuth, elevation);
        ASSERT_EQ(axes.right, (Axis{a.cosine, 0, -a.sine}));
        ASSERT_EQ(axes.up, (Axis{-mul30(a.sine, e.sine), e.cosine, -mul30(a.cosine, e.sine)}));
        ASSERT_EQ(axes.back, (Axis{mul30(a.sine, e.cosine), e.sine, mul30(a.cosine, e.cosine)}));
    }
}

// Differences of up to 33 bits, and of so few that nothing is shifted away; odd ones make ties.
TEST(ViewAxes, FromPointsAreTheTexts) {
    Random random;
    for (int n = 0; n < effort(20000); ++n) {
        const int shift = static_cast<int>(random.between(0, 28));
        const World from = random_world(random, shift), to = random_world(random, shift);
        const std::int64_t x = std::int64_t{from.x} - to.x, y = std::int64_t{from.y} - to.y;
        const std::int64_t z = std::int64_t{from.z} - to.z;
        ViewAxes axes{};
        ASSERT_EQ(axes_from_points(from, to, axes), x != 0 || y != 0 || z != 0);
        if (x == 0 && z == 0) continue;
        const Axis b = unit30({x, y, z}), r = unit30({z, 0, -x});
        ASSERT_EQ(axes.back, b) << "case " << n;
        ASSERT_EQ(axes.right, r) << "case " << n;
        ASSERT_EQ(axes.up, (Axis{mul30(b[1], r[2]), mul30(b[2], r[0]) - mul30(b[0], r[2]),
                                 -mul30(b[1], r[0])}));
    }
}

View random_fitted_view(Random& random, bool perspective) {
    View v;
    v.projection = perspective ? Projection::perspective : Projection::orthographic;
    v.axes = axes_from_angles(static_cast<std::int32_t>(random.between(-180 << 16, 180 << 16)),
                              static_cast<std::int32_t>(random.between(-90 << 16, 90 << 16)));
    v.target = random_world(random, 12);
    v.extent = static_cast<std::int32_t>(random.between(1, 1 << 22));
    v.distance = static_cast<std::int32_t>(random.between(1, 1 << 22));
    return v;
}

// Depths times 2^46: back . (o - P), with o = t + distance back in perspective.
DepthRange range_of(const View& v, std::span<const Patch> patches) {
    const auto& back = v.axes.back;
    const Int128 one = power(v.projection == Projection::perspective ? 30 : 0);
    const ExactVector t{v.target.x, v.target.y, v.target.z};
    Int128 low = power(120), high = -power(120);
    for (const Patch& p : patches) {
        for (const World& w : p.control) {
            const ExactVector at{w.x, w.y, w.z};
            Int128 d = 0;
            for (std::size_t k = 0; k < 3; ++k) {
                Int128 from = (t[k] - at[k]) * one;
                if (v.projection == Projection::perspective) from += Int128{v.distance} * back[k];
                d += back[k] * from;
            }
            low = std::min(low, d);
            high = std::max(high, d);
        }
    }
    return {static_cast<std::int64_t>(floor_of(low, power(30) * one)),
            static_cast<std::int64_t>(ceiling_of(high, power(30) * one))};
}

TEST(View, DepthRangeIsTheTextsRoundedOutward) {
    Random random;
    for (int n = 0; n < effort(3000); ++n) {
        const View v = random_fitted_view(random, n % 2 == 0);
        std::vector<Patch> patches(random.bits() % 3 + 1);
        const int shift = static_cast<int>(random.between(1, 20));
        for (Patch& p : patches)
            for (World& c : p.control) c = random_world(random, shift);
        const DepthRange expected = range_of(v, patches), range = depth_range(v, patches);
        ASSERT_EQ(range.min, expected.min) << "case " << n;
        ASSERT_EQ(range.max, expected.max) << "case " << n;
    }
    const DepthRange none = depth_range(random_fitted_view(random, true), {});
    EXPECT_TRUE(none.min == 0 && none.max == 0);
}

TEST(View, NearAndFarAreTheTexts) {
    Random random;
    for (int n = 0; n < effort(20000); ++n) {
        View v = random_fitted_view(random, n % 2 == 0);
        const std::int64_t size = std::int64_t{1} << random.between(1, 34);
        DepthRange d{random.between(-size, size), random.between(-size, size)};
        if (d.min > d.max) std::swap(d.min, d.max);
        if (n % 7 == 0) d.max = v.extent - static_cast<std::int64_t>(random.bits() % 3);
        d.min = std::min(d.min, d.max);
        fit_depth(v, d);
        if (v.projection == Projection::orthographic) {
            const std::int64_t reach = std::max({std::int64_t{v.extent}, -d.min, d.max + 1});
            ASSERT_TRUE(v.near_depth == -reach && v.far_depth == reach) << "case " << n;
            continue;
        }
        const std::int64_t far = std::max<std::int64_t>(d.max + d.max / 64 + 1, 1024);
        std::int64_t near = std::max(d.min - d.min / 64 - 1, far / 1024);
        if (near >= far) near = far / 1024;
        ASSERT_EQ(v.far_depth, far) << "case " << n;
        ASSERT_EQ(v.near_depth, near) << "case " << n;
    }
}

TEST(Shading, TheEyeIsTheTexts) {
    Random random;
    for (int n = 0; n < effort(20000); ++n) {
        const View v = random_fitted_view(random, n % 2 == 0);
        const hw::WordFormat object{16, static_cast<int>(random.between(0, 14))};
        const Toward t = toward_eye(v, object);
        ASSERT_EQ(t.to_point, v.projection == Projection::perspective);
        const std::array<std::int64_t, 3> target{v.target.x, v.target.y, v.target.z};
        for (std::size_t k = 0; k < 3; ++k) {
            ASSERT_TRUE(t.direction[k] == half_up_of(v.axes.back[k], power(16)));
            if (!t.to_point) continue;
            const Int128 e =
                target[k] + half_up_of(Int128{v.distance} * v.axes.back[k], power(30));
            ASSERT_TRUE(t.point[k] == half_up_scaled(e, 16 - object.fraction - 6));
        }
    }
}

}  // namespace
}  // namespace umbra78::raster
