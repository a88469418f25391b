// The normal offset: the text's arithmetic in 128 bits, the geometry that it stands for, and what
// it does to acne and to thin walls.
#include "shadow/normal_offset.hpp"

#include "shadow/post_process.hpp"
#include "tests/fixed/boundary.hpp"
#include "tests/shadow/frame/figure_frame.hpp"
#include "tests/shadow/random_frames.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace umbra78::shadow {
namespace {

using fixed::test::Int128;
using fixed::test::Random;
using Vector = std::array<double, 3>;

hw::Point normal_point(std::int64_t x, std::int64_t y, std::int64_t z) {
    return {x, y, z, hw::DivideStatus::ok};
}

// --- the text, slowly ---------------------------------------------------------------------------

Int128 halves_up(Int128 num, Int128 den) {
    return fixed::test::model_round(num, den, fixed::Rounding::half_up);
}
bool fits_bits(Int128 v, int bits) {
    return v >= -(Int128{1} << (bits - 1)) && v < Int128{1} << (bits - 1);
}
int length_in_bits(Int128 v) {
    int n = 0;
    for (; v > 0; v /= 2) ++n;
    return n;
}
Int128 slow_root(Int128 v) {
    Int128 r = 0;
    for (Int128 bit = Int128{1} << 32; bit > 0; bit /= 2)
        if ((r + bit) * (r + bit) <= v) r += bit;
    return r;
}

struct Offset {
    int turn, fraction_bits;
    std::int64_t c;
    LightScale light;
};

hw::Point slowly_moved(const std::array<hw::Point, 3>& three, const Offset& o) {
    const hw::Point& p = three[0];
    const Int128 one = 1;
    Int128 scale = o.light.quanta_q16, tilt[2] = {0, 0};
    if (o.light.focal_q8 > 0) {
        scale = std::clamp(halves_up((o.light.reach_q8 - Int128{256} * p.z) * 65536,
                                     o.light.focal_q8),
                           one, (one << 40) - 1);
        for (const auto& [k, v] : {std::pair{0, p.x}, std::pair{1, p.y}})
            tilt[k] = std::clamp(halves_up(v * (one << (24 - o.fraction_bits)), o.light.focal_q8),
                                 -(one << 25), (one << 25) - 1);
    }
    Int128 uv[2][3];
    for (std::size_t k = 0; k < 2; ++k) {
        const hw::Point& q = three[k + 1];
        const Int128 step[3] = {q.x - p.x, q.y - p.y, q.z - p.z};
        for (const Int128 s : step)
            if (!fits_bits(s, 31)) return p;
        uv[k][2] = halves_up(step[2] * (one << 28), scale);
        for (std::size_t a = 0; a < 2; ++a)
            uv[k][a] = step[a] * (one << (12 - o.fraction_bits)) +
                       halves_up(tilt[a] * uv[k][2], 65536);
        for (const Int128 s : uv[k])
            if (!fits_bits(s, 26)) return p;
    }
    Int128 n[3], most = 0;
    for (std::size_t a = 0; a < 3; ++a) {
        const std::size_t b = (a + 1) % 3, c = (a + 2) % 3;
        n[a] = uv[0][b] * uv[1][c] - uv[0][c] * uv[1][b];
        most = std::max(most, n[a] < 0 ? -n[a] : n[a]);
    }
    if (most == 0) return p;
    const int up = 24 - length_in_bits(most);
    Int128 square = 0;
    for (Int128& k : n) {
        k = up >= 0 ? k * (one << up) : halves_up(k, one << -up);
        square += k * k;
    }
    Int128 move[3];
    for (std::size_t a = 0; a < 3; ++a)
        move[a] = halves_up(-o.turn * 16 * o.c * n[a], slow_root(square));
    const auto aside = [&](std::size_t a) {
        return static_cast<std::int64_t>(halves_up(65536 * move[a] - tilt[a] * move[2],
                                                   one << (28 - o.fraction_bits)));
    };
    return normal_point(p.x + aside(0), p.y + aside(1),
                        p.z + static_cast<std::int64_t>(halves_up(scale * move[2], one << 28)));
}

TEST(NormalOffset, IsTheTextsArithmetic) {
    Random random;
    int moved = 0, kept = 0;
    for (int k = 0; k < 40000; ++k) {
        Offset o{random.between(0, 1) == 0 ? -1 : 1, static_cast<int>(random.between(0, 12)),
                 random.between(0, 16 << 8), {}};
        if (k % 2 == 0) {
            o.light.quanta_q16 = max_texel_quanta >> random.between(0, 39);
        } else {
            o.light.focal_q8 = max_reach >> random.between(0, 53);
            o.light.reach_q8 = random.between(-3, 3) * (max_reach >> random.between(2, 53));
        }
        const auto word = [&](int bits) {
            return random.between(-(std::int64_t{1} << bits), std::int64_t{1} << bits);
        };
        const auto near = [&](const hw::Point& p) {
            const int bits = static_cast<int>(random.between(0, k % 9 == 8 ? 31 : 16));
            return normal_point(p.x + word(bits), p.y + word(bits), p.z + word(bits));
        };
        const hw::Point at = normal_point(word(23), word(23), word(24));
        const std::array three{at, near(at), near(at)};
        const hw::Point got = moved_along_normal(three[0], three[1], three[2], o.turn, o.c, o.light,
                                                 o.fraction_bits);
        const hw::Point expected = slowly_moved(three, o);
        ASSERT_EQ(got.x, expected.x) << k;
        ASSERT_EQ(got.y, expected.y) << k;
        ASSERT_EQ(got.z, expected.z) << k;
        const bool stays = got.x == at.x && got.y == at.y && got.z == at.z;
        (stays ? kept : moved) += 1;
    }
    EXPECT_GT(moved, 10000);
    EXPECT_GT(kept, 1000);
}

TEST(NormalOffset, IsNoneWithoutASurface) {
    const hw::Point at = normal_point(0, 0, 0), beside = normal_point(128, 0, 100);
    const hw::Point below = normal_point(0, 128, 50);
    const LightScale light{128 << 16};
    const auto z = [&](const std::array<hw::Point, 3>& p, std::int64_t c) {
        return moved_along_normal(p[0], p[1], p[2], 1, c, light, 7).z;
    };
    EXPECT_LT(z({at, beside, below}, 256), -80);
    EXPECT_EQ(z({at, beside, below}, 0), 0);
    EXPECT_EQ(z({at, beside, beside}, 256), 0) << "n is 0";
    EXPECT_EQ(z({at, normal_point(std::int64_t{1} << 30, 0, 0), below}, 256), 0);
    EXPECT_EQ(z({at, normal_point(1 << 20, 0, 0), below}, 256), 0) << "8192 texels";
    EXPECT_NE(z({at, normal_point((1 << 20) - 1, 0, 0), below}, 256), 0);
    for (const auto status : {hw::DivideStatus::overflow, hw::DivideStatus::divisor_not_positive}) {
        std::array three{at, beside, below};
        for (hw::Point& p : three) {
            p.status = status;
            EXPECT_EQ(z(three, 256), 0);
            p.status = hw::DivideStatus::ok;
        }
    }
}

// --- the geometry --------------------------------------------------------------------------------

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// A lamp's screen, or a light's at infinity: places right, down and away in texels (of a lamp: at a
// distance of focal) to results with 12 fraction bits and a Z of many quanta.
struct Screen {
    bool lamp;
    double focal = 400, reach = 1 << 20, quanta = 900;
    double texel(const Vector& p) const { return lamp ? p[2] / focal : 1; }
    Vector result(const Vector& p) const {
        if (!lamp) return {4096 * p[0], 4096 * p[1], quanta * p[2]};
        return {4096 * p[0] * focal / p[2], 4096 * p[1] * focal / p[2],
                reach - reach * focal / p[2]};
    }
    hw::Point rounded(const Vector& p) const {
        const Vector r = result(p);
        return normal_point(std::llround(r[0]), std::llround(r[1]), std::llround(r[2]));
    }
    LightScale words() const {
        if (!lamp) return {std::llround(65536 * quanta)};
        return {0, std::llround(256 * reach), std::llround(256 * focal)};
    }
};

// The moved results are those of P + N c texel, whichever neighbours gave the surface; of a lamp up
// to the square of the offset.
TEST(NormalOffset, IsThePointMovedAlongItsNormal) {
    Random random;
    const auto real = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random.between(0, 1 << 20)) / (1 << 20);
    };
    for (int k = 0; k < 4000; ++k) {
        const Screen screen{k % 2 == 1};
        const Vector p{real(-150, 150), real(-150, 150), real(300, 600)};
        // Away from the observer, who sees the other side. The light may see either.
        Vector n{real(-1, 1), real(-1, 1), real(0.2, 1) * (k % 4 < 2 ? 1 : -1)};
        const double size = std::sqrt(dot(n, n));
        for (double& v : n) v /= size;
        // Right and down along the surface, so that u x v points as n does.
        const Vector u{n[2], 0, -n[0]}, v{-n[0] * n[1], n[2] * n[2] + n[0] * n[0], -n[1] * n[2]};
        const int right = random.between(0, 1) == 0 ? -1 : 1;
        const int down = random.between(0, 1) == 0 ? -1 : 1;
        const auto along = [&](const Vector& way, double by) {
            return Vector{p[0] + by * way[0], p[1] + by * way[1], p[2] + by * way[2]};
        };
        const double c = real(0, 2);
        const hw::Point moved = moved_along_normal(
            screen.rounded(p), screen.rounded(along(u, right * 3.0)),
            screen.rounded(along(v, down * 3.0)), right * down, std::llround(256 * c),
            screen.words(), 12);
        const Vector expected = screen.result(along(n, -c * screen.texel(p)));
        const double texel = 4096, off = screen.lamp ? 0.02 : 0.005;
        EXPECT_NEAR(static_cast<double>(moved.x), expected[0], off * texel) << k;
        EXPECT_NEAR(static_cast<double>(moved.y), expected[1], off * texel) << k;
        const double quanta = static_cast<double>(screen.words().texel_quanta(
                                  screen.rounded(p).z)) / 65536;
        EXPECT_NEAR(static_cast<double>(moved.z), expected[2], off * quanta + 1) << k;
    }
}

// --- in a frame ----------------------------------------------------------------------------------

// A floor alone, seen from above, in the light of a low sun: all that is dark shadows itself.
std::int64_t least_constant(int elevation, Receiver receiver, std::int32_t offset_q8) {
    constexpr std::int32_t one = 65536;
    const std::vector floor{
        raster::plane_patch({{-3 * one, 0, -3 * one}, {6 * one, 0, 0}, {0, 0, 6 * one}, 0})};
    static constexpr std::array<raster::Material, 1> material{};
    const auto view = [&](int azimuth, int up, std::int32_t extent) {
        raster::View v;
        v.axes = raster::axes_from_angles(azimuth * one, up * one);
        v.extent = extent;
        v.near_depth = -8 * one;
        v.far_depth = 8 * one;
        return v;
    };
    const Scene scene{floor, material, view(0, 90, 4 * one), {{view(-65, elevation, 8 * one)}}};
    Settings s;
    s.machine.xy_bits = 6;
    s.machine.z_bits = 16;
    s.machine.coefficient_bits = 24;
    s.receiver = receiver;
    s.normal_offset_q8 = offset_q8;
    for (std::int64_t bias = 0; bias < 1 << 13; bias += std::max<std::int64_t>(1, bias / 16)) {
        s.bias_q16 = bias << 16;
        const test::Frame<> f(scene, s);
        EXPECT_GT(f.counts.lights[0].post_process.visible, 1000u);
        if (f.counts.lights[0].post_process.shadowed == 0) return bias;
    }
    return -1;
}

TEST(NormalOffset, TakesThePlaceOfTheConstant) {
    for (const int elevation : {15, 30, 60}) {
        const std::int64_t constant = least_constant(elevation, Receiver::point, 0);
        const std::int64_t beside = least_constant(elevation, Receiver::normal, 182);  // 0.71
        EXPECT_EQ(least_constant(elevation, Receiver::normal, 0), constant) << elevation;
        EXPECT_LT(least_constant(elevation, Receiver::normal, 64), constant) << elevation;
        EXPECT_GE(beside, 0);
        EXPECT_LE(beside, 8) << elevation;
        EXPECT_GT(constant, 250) << elevation;
        std::printf("sun at %d degrees: %lld quanta alone, %lld beside 0.71 texel\n", elevation,
                    static_cast<long long>(constant), static_cast<long long>(beside));
    }
}

// A plane that faces observer and light, and a wall before it: 128 quanta are a texel.
struct ThinWall {
    ThinWall() : observer(4), light(4), mask(256), maps(test::maps_of(observer, light)) {
        s.machine.xy_bits = 4;
        s.machine.z_bits = 11;
        s.receiver = Receiver::normal;
        const std::int16_t one = 1 << 14;
        matrix.word = {{{one, 0, 0, 0}, {0, one, 0, 0}, {0, 0, one, 0}, {0, 0, 0, one}}};
        matrix.affine = true;
    }
    int dark(std::int32_t offset_q8, hw::Depth16 plane, hw::Depth16 wall) {
        std::ranges::fill(observer.depth, plane);
        std::ranges::fill(light.depth, wall);
        s.normal_offset_q8 = offset_q8;
        post_process(maps, matrix, s, needed_work(s), mask, {INT64_MAX, {128 << 16}});
        return static_cast<int>(std::ranges::count(mask, mask_shadow));
    }
    Settings s;
    test::OwnedStore<hw::Depth16> observer, light;
    std::vector<std::uint8_t> mask;
    DepthMaps<hw::Depth16> maps;
    hw::MatrixWords matrix{};
};

TEST(NormalOffset, LeaksThroughAWallThinnerThanItself) {
    ThinWall scene;
    EXPECT_EQ(scene.dark(0, 1000, 900), 256);
    EXPECT_EQ(scene.dark(192, 1000, 900), 256) << "0.75 texel are 96 quanta of the wall's 100";
    EXPECT_EQ(scene.dark(200, 1000, 900), 0) << "100 quanta";
}

// A light behind the plane sees its other side: the point moves deeper into its own shadow.
TEST(NormalOffset, IsOnTheObserversSide) {
    ThinWall scene;
    for (const std::size_t row : {0u, 2u}) scene.matrix.word[row][row] = -(1 << 14);
    const hw::Depth16 behind = 2048 - 1000;
    EXPECT_EQ(scene.dark(0, 1000, behind), 0);
    EXPECT_EQ(scene.dark(256, 1000, behind), 256);
    EXPECT_EQ(scene.dark(256, 1000, behind + 127), 256);
    EXPECT_EQ(scene.dark(256, 1000, behind + 128), 0);
}

}  // namespace
}  // namespace umbra78::shadow
