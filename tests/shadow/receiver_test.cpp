// The receiver's plane: exact where the plane is, level where there is none, and what it does to a
// comparison.
#include "shadow/receiver.hpp"

#include "shadow/compare.hpp"
#include "tests/fixed/boundary.hpp"
#include "tests/shadow/random_frames.hpp"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace umbra78::shadow {
namespace {

using fixed::test::Int128;
using fixed::test::Random;

hw::Point point(std::int64_t x, std::int64_t y, std::int64_t z) {
    return {x, y, z, hw::DivideStatus::ok};
}

// The nearer neighbour in depth; the first of two that are as near, and none beyond the frame or
// where nothing was drawn.
TEST(ReceiverPlane, IsOfTheNearerNeighbours) {
    test::OwnedStore<hw::Depth16> owned(2);
    const hw::FrameStore<const hw::Depth16> store{2, owned.depth, {}, {}};
    constexpr std::uint32_t none = 65535;
    const auto found = [&](int dx, int dy) {
        int x = -1, y = -1;
        const bool any = nearer_neighbour(store, none, 1, 1, dx, dy, x, y);
        return std::array{any ? 1 : 0, x, y};
    };
    owned.depth[store.address(1, 1)] = 100;
    const auto put = [&](int left, int right, int above, int below) {
        owned.depth[store.address(0, 1)] = static_cast<hw::Depth16>(left);
        owned.depth[store.address(2, 1)] = static_cast<hw::Depth16>(right);
        owned.depth[store.address(1, 0)] = static_cast<hw::Depth16>(above);
        owned.depth[store.address(1, 2)] = static_cast<hw::Depth16>(below);
    };
    put(90, 111, 110, 95);
    EXPECT_EQ(found(1, 0), (std::array{1, 0, 1}));
    EXPECT_EQ(found(0, 1), (std::array{1, 1, 2}));
    put(90, 110, 110, 90);
    EXPECT_EQ(found(1, 0), (std::array{1, 0, 1})) << "as near: the first";
    EXPECT_EQ(found(0, 1), (std::array{1, 1, 0}));
    put(none, 500, none, none);
    EXPECT_EQ(found(1, 0), (std::array{1, 2, 1}));
    EXPECT_EQ(found(0, 1), (std::array{0, -1, -1}));
}

// Z = a X + b Y + c in whole quanta a step: any two neighbours give the same plane, and the change
// to any place is exact but for the last half.
TEST(ReceiverPlane, OfAPlaneIsThePlane) {
    Random random;
    int planes = 0;
    for (int n = 0; n < 20000; ++n) {
        const std::int64_t a = random.between(-300, 300), b = random.between(-300, 300);
        const auto on = [&](std::int64_t x, std::int64_t y) { return point(x, y, a * x + b * y); };
        const auto near = [&](const hw::Point& p) {
            return on(p.x + random.between(-400, 400), p.y + random.between(-400, 400));
        };
        const hw::Point at = on(random.between(-30000, 30000), random.between(-30000, 30000));
        const hw::Point beside = near(at), below = near(at);
        const ReceiverPlane plane = receiver_plane(at, beside, below, INT64_MAX);
        if ((beside.x - at.x) * (below.y - at.y) == (below.x - at.x) * (beside.y - at.y)) {
            EXPECT_EQ(plane.slope_x, 0);
            EXPECT_EQ(plane.slope_y, 0);
            continue;
        }
        ++planes;
        ASSERT_EQ(plane.slope_x, a << slope_fraction);
        ASSERT_EQ(plane.slope_y, b << slope_fraction);
        const std::int64_t x2 = 2 * at.x + random.between(-300, 300);
        const std::int64_t y2 = 2 * at.y + random.between(-300, 300);
        const std::int64_t twice = a * (x2 - 2 * at.x) + b * (y2 - 2 * at.y);
        ASSERT_EQ(plane.change(x2, y2), fixed::round_divide(twice, 2, fixed::Rounding::half_up));
        const std::int64_t limit = random.between(0, 500);
        ASSERT_EQ(receiver_plane(at, beside, below, limit).change(x2, y2),
                  std::clamp(plane.change(x2, y2), -limit, limit));
    }
    EXPECT_GT(planes, 19000);
}

// Any steps of up to 31 bits, in 128 bits.
TEST(ReceiverPlane, IsTheExactQuotient) {
    Random random;
    int saturated = 0, level = 0;
    for (int n = 0; n < 100000; ++n) {
        const int bits = static_cast<int>(random.between(2, 31));
        const auto step = [&] {
            const std::int64_t most = (std::int64_t{1} << (bits - 1)) - 1;
            return random.between(-most - 1, most);
        };
        std::array<std::int64_t, 3> u{step(), step(), step()}, v{step(), step(), step()};
        if (n % 10 == 0 && bits > 2) {  // D = 1: nearly edge-on
            u[1] = u[0] / 2 - 1;
            u[0] = u[1] + 1;
            v = {u[0] + 1, u[0], v[2]};
        }
        const Int128 d = Int128{u[0]} * v[1] - Int128{v[0]} * u[1];
        const ReceiverPlane plane = receiver_plane(point(0, 0, 0), point(u[0], u[1], u[2]),
                                                   point(v[0], v[1], v[2]), INT64_MAX);
        const auto expected = [&](Int128 rise) {
            if (d == 0) return std::int64_t{0};
            const Int128 sign = d < 0 ? -1 : 1, most = (Int128{1} << 39) - 1;
            const Int128 q = fixed::test::model_round(4096 * sign * rise, sign * d,
                                                      fixed::Rounding::half_up);
            saturated += q > most || q < -most - 1 ? 1 : 0;
            return static_cast<std::int64_t>(std::min(std::max(q, -most - 1), most));
        };
        level += d == 0 ? 1 : 0;
        ASSERT_EQ(plane.slope_x, expected(Int128{u[2]} * v[1] - Int128{v[2]} * u[1])) << n;
        ASSERT_EQ(plane.slope_y, expected(Int128{v[2]} * u[0] - Int128{u[2]} * v[0])) << n;
    }
    EXPECT_GT(saturated, 0);
    EXPECT_GT(level, 100);
}

TEST(ReceiverPlane, IsLevelWithoutAPlane) {
    const hw::Point at = point(0, 0, 0), beside = point(128, 0, 100), below = point(0, 128, 50);
    EXPECT_EQ(receiver_plane(at, beside, below, 9999).change(256, 0), 100);
    for (const auto status : {hw::DivideStatus::overflow, hw::DivideStatus::divisor_not_positive}) {
        std::array<hw::Point, 3> three{at, beside, below};
        for (hw::Point& p : three) {
            p.status = status;
            EXPECT_EQ(receiver_plane(three[0], three[1], three[2], 9999).change(256, 256), 0);
            p.status = hw::DivideStatus::ok;
        }
    }
    for (const std::int64_t far : {(std::int64_t{1} << 30) - 1, std::int64_t{1} << 30,
                                   -(std::int64_t{1} << 30), -(std::int64_t{1} << 30) - 1}) {
        const bool fits = far < std::int64_t{1} << 30 && far >= -(std::int64_t{1} << 30);
        EXPECT_EQ(receiver_plane(at, point(far, 0, far), below, 9999).slope_x != 0, fits) << far;
    }
}

// A map whose texel (8, 8) holds one code: the plane's depth at its centre decides, wherever in the
// texel the pixel lies; with bilinear lookup the depth at the dithered place does.
TEST(ReceiverPlane, IsAskedWhereTheMapIsSampled) {
    ShadowTest test;
    test.machine.xy_bits = 4;
    test.machine.z_bits = 16;
    const std::int64_t base = 1000 - test.machine.depth_offset();
    std::vector<hw::Depth16> map(256, 1000);
    const hw::FrameStore<const hw::Depth16> store{4, map, {}, {}};
    for (int x = 0; x < 128; ++x) {  // Z rises by 3 quanta a step of X; 1000 at the texel's centre
        const hw::Point p = point(x, 64, base + 3 * (x - 64));
        ReceiverPlane plane{p, 3 << slope_fraction, 0};
        for (const Lookup lookup : {Lookup::nearest, Lookup::bilinear}) {
            test.lookup = lookup;
            const LightMap<hw::Depth16> light = light_map<hw::Depth16>(store, test);
            EXPECT_EQ(in_shadow(light, p, {0, 0}), x > 64);
            if (lookup == Lookup::nearest) {
                EXPECT_FALSE(in_shadow(light, p, {0, 0}, {}, &plane)) << x;
                hw::Point deeper = p;
                ++deeper.z;
                EXPECT_TRUE(in_shadow(light, deeper, {0, 0}, {}, &plane)) << x;
            } else {
                EXPECT_EQ(in_shadow(light, p, {0, 0}, {}, &plane), x > 64);
                EXPECT_EQ(in_shadow(light, p, {64 - x, 0}, {}, &plane), false);
                EXPECT_EQ(in_shadow(light, p, {65 - x, 0}, {}, &plane), true);
            }
        }
    }
}

// Beside the background bilinear lookup falls back to the texel that the point lies in.
TEST(ReceiverPlane, FallsBackToTheTexelsCentre) {
    ShadowTest test;
    test.machine.xy_bits = 4;
    test.lookup = Lookup::bilinear;
    test.background = Background::fall_back;
    std::vector<hw::Depth16> map(256, 65535);
    map[16 * 8 + 8] = 1000;
    const hw::FrameStore<const hw::Depth16> store{4, map, {}, {}};
    const LightMap<hw::Depth16> light = light_map<hw::Depth16>(store, test);
    const std::int64_t base = 1000 - test.machine.depth_offset();
    for (int x = 0; x < 128; ++x)
        for (int y = 0; y < 128; y += 9) {
            const hw::Point p = point(x, y, base + 3 * (x - 64) - 2 * (y - 64));
            ReceiverPlane plane{p, 3 << slope_fraction, -2 * (1 << slope_fraction)};
            EXPECT_FALSE(in_shadow(light, p, {0, 0}, {}, &plane)) << x << " " << y;
            hw::Point deeper = p;
            ++deeper.z;
            EXPECT_TRUE(in_shadow(light, deeper, {0, 0}, {}, &plane)) << x << " " << y;
        }
}

}  // namespace
}  // namespace umbra78::shadow
