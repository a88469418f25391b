// Sampling: the triangle's depth against exact rationals, the slack, which pixels are visited, and
// Z codes at the ends of their range.
#include "raster/sampling.hpp"

#include "tests/raster/exact_drawing.hpp"
#include "tests/support/effort.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <tuple>

namespace umbra78::raster {
namespace {

using namespace test;
using fixed::Rounding;

// A leaf's triangle: at most a pixel wide, anywhere in a frame of 4096 pixels, any depths.
std::array<Corner, 3> random_triangle(Random& random) {
    const auto word = [&](std::int64_t reach) {
        return static_cast<std::int32_t>(random.between(-reach, reach));
    };
    const std::int32_t x = word(2048 << 13), y = word(2048 << 13), z = word(1 << 28);
    const std::int64_t size = std::int64_t{1} << random.between(3, 12);  // half its width
    const std::int64_t rise = std::int64_t{1} << random.between(0, 22);
    std::array<Corner, 3> t{};
    for (Corner& c : t) c = {x + word(size), y + word(size), z + word(rise)};
    return t;
}

Int128 edge(const Corner& p, const Corner& q, std::int64_t x, std::int64_t y) {
    return Int128{q.x - p.x} * (y - p.y) - Int128{x - p.x} * (q.y - p.y);
}

// The plane of the triangle at (x, y), rounded half up, by its normal.
std::int64_t plane_depth(const std::array<Corner, 3>& t, std::int64_t x, std::int64_t y) {
    const auto& [a, b, c] = t;
    const Int128 nx = Int128{b.y - a.y} * (c.z - a.z) - Int128{b.z - a.z} * (c.y - a.y);
    const Int128 ny = Int128{b.z - a.z} * (c.x - a.x) - Int128{b.x - a.x} * (c.z - a.z);
    Int128 nz = edge(a, b, c.x, c.y);
    Int128 rise = -(nx * (x - a.x) + ny * (y - a.y));
    if (nz < 0) {
        nz = -nz;
        rise = -rise;
    }
    const Int128 z = fixed::test::model_round(rise, nz, Rounding::half_up) + a.z;
    return static_cast<std::int64_t>(z);
}

TEST(TriangleDepth, IsTheExactPlaneWithinAndClampedInTheSlack) {
    Random random;
    int within = 0, in_slack = 0, outside = 0;
    const int cases = umbra78::test::effort(200000);
    for (int n = 0; n < cases; ++n) {
        const auto t = random_triangle(random);
        const auto& [a, b, c] = t;
        const auto [x0, x1] = std::minmax({a.x, b.x, c.x});
        const auto [y0, y1] = std::minmax({a.y, b.y, c.y});
        const auto [z0, z1] = std::minmax({a.z, b.z, c.z});
        const auto x = static_cast<std::int32_t>(random.between(x0 - 200, x1 + 200));
        const auto y = static_cast<std::int32_t>(random.between(y0 - 200, y1 + 200));
        std::int64_t z = 0;
        const bool drawn = triangle_depth(a, b, c, x, y, z);
        const Int128 area = edge(a, b, c.x, c.y), sign = area < 0 ? -1 : 1;
        const Int128 wc = sign * edge(a, b, x, y), wa = sign * edge(b, c, x, y);
        const Int128 wb = sign * edge(c, a, x, y);
        if (area == 0) {
            ASSERT_FALSE(drawn) << "edge-on";
            continue;
        }
        if (wa >= 0 && wb >= 0 && wc >= 0) {
            ++within;
            ASSERT_TRUE(drawn);
            ASSERT_EQ(z, std::clamp<std::int64_t>(plane_depth(t, x, y), z0, z1)) << "case " << n;
        } else if (drawn) {
            ++in_slack;
            // No farther from each edge's line than the slack's diagonal, and in the grown box.
            const auto past = [&](Int128 w, const Corner& p, const Corner& q) {
                return -static_cast<double>(w) / std::hypot(q.x - p.x, q.y - p.y);
            };
            const double far = std::max({past(wc, a, b), past(wa, b, c), past(wb, c, a)});
            ASSERT_LE(far, 128 * std::sqrt(2.0) + 1e-6);
            ASSERT_TRUE(x >= x0 - 128 && x <= x1 + 128 && y >= y0 - 128 && y <= y1 + 128);
            ASSERT_EQ(z, std::clamp<std::int64_t>(plane_depth(t, x, y), z0, z1)) << "case " << n;
        } else {
            ++outside;
        }
        // Neither the order of the corners nor the side it is seen from matters.
        std::int64_t turned = 0, behind = 0;
        ASSERT_EQ(triangle_depth(b, c, a, x, y, turned), drawn);
        ASSERT_EQ(triangle_depth(a, c, b, x, y, behind), drawn);
        if (!drawn) continue;
        ASSERT_EQ(turned, z);
        ASSERT_EQ(behind, z);
    }
    EXPECT_GT(within, cases / 20);
    EXPECT_GT(in_slack, cases / 40);
    EXPECT_GT(outside, cases / 20);
}

// The first pixel whose centre is at a place or right of it, the last at it or left of it.
TEST(Pixels, AreThoseWhoseCentresAreNotBeforeOrNotAfterAPlace) {
    for (const std::int32_t half : {8, 2048}) {
        EXPECT_EQ(pixel_centre(half, half), 4096) << "the pixel right of the frame's centre";
        for (std::int32_t at = -3 * 8192; at <= 3 * 8192; ++at) {
            const std::int32_t first = first_pixel(at, half), last = last_pixel(at, half);
            ASSERT_TRUE(pixel_centre(first, half) >= at && pixel_centre(first - 1, half) < at);
            ASSERT_TRUE(pixel_centre(last, half) <= at && pixel_centre(last + 1, half) > at);
        }
    }
}

// Triangles of any size that corners of 31 bits can make, which no 32-bit edge function holds; the
// widest that one does; and one unit wider. In place and in depth they reach the ends of the words.
TEST(TriangleDepth, IsExactForTrianglesOfAnySize) {
    Random random;
    int covered = 0, clamped = 0;
    for (int n = 0; n < umbra78::test::effort(200000); ++n) {
        const std::int64_t reach = std::int64_t{1} << random.between(12, 29);
        std::array<Corner, 3> t{};
        const auto word = [&](std::int64_t size) {
            return static_cast<std::int32_t>(random.between(-size, size));
        };
        const std::int64_t rise = std::int64_t{1} << random.between(0, 30);
        for (Corner& c : t) c = {word(reach), word(reach), word(rise - 1)};
        if (n % 4 == 0) {  // as wide as the limit, at its ends, and one more
            const std::int32_t wide = max_triangle + static_cast<std::int32_t>(n / 4 % 3) - 1;
            t[0] = {-5, -7, t[0].z};
            t[1] = {-5 + wide, random.bits() % 2 == 0 ? -7 : -7 + wide, t[1].z};
            t[2] = {-5 + static_cast<std::int32_t>(random.bits() % 3), -7 + wide, t[2].z};
        }
        const auto& [a, b, c] = t;
        const auto [x0, x1] = std::minmax({a.x, b.x, c.x});
        const auto [y0, y1] = std::minmax({a.y, b.y, c.y});
        auto x = static_cast<std::int32_t>(random.between(x0 - 130, x1 + 130));
        auto y = static_cast<std::int32_t>(random.between(y0 - 130, y1 + 130));
        if (n % 3 == 0) {  // next to a corner, or to an edge's middle
            x = (n % 2 == 0 ? a.x : a.x / 2 + b.x / 2) + word(130);
            y = (n % 2 == 0 ? a.y : a.y / 2 + b.y / 2) + word(130);
        }
        const auto point = [](const Corner& p) { return ExactPoint{p.x, p.y, p.z}; };
        const auto expected = exact_depth(point(a), point(b), point(c), {x, y, 0});
        std::int64_t z = 0;
        ASSERT_EQ(triangle_depth(a, b, c, x, y, z), expected.has_value()) << "case " << n;
        if (!expected) continue;
        ASSERT_TRUE(z == *expected) << "case " << n;
        ++covered;
        clamped += z == std::min({a.z, b.z, c.z}) || z == std::max({a.z, b.z, c.z}) ? 1 : 0;
    }
    EXPECT_GT(covered, 10000);
    EXPECT_GT(clamped, 100);
}

// z = x / 2 on a triangle of eight pixels and on one of a pixel: every second place is a tie.
TEST(TriangleDepth, RoundsTiesUpAtAnySize) {
    for (const std::int32_t size : {1 << 16, 1 << 13}) {
        for (const std::int32_t sign : {1, -1}) {
            const Corner a{0, 0, 0}, b{size, 0, sign * size / 2}, c{0, size, 0};
            for (std::int32_t x = 0; x < 200; ++x) {
                std::int64_t z = 0;
                ASSERT_TRUE(triangle_depth(a, b, c, x, 0, z));
                ASSERT_EQ(z, sign > 0 ? (x + 1) / 2 : -(x / 2)) << x << " of " << size;
            }
        }
    }
}

// The block rule's promise in an orthographic view: no leaf is wider than a pixel, whatever the
// corrections, even where slopes and bends are at their limits.
TEST(BlockRule, DrawsNoLeafWiderThanItsLimit) {
    Random random;
    std::int64_t widest = 0;
    int drawn = 0;
    for (int n = 0; n < umbra78::test::effort(20000); ++n) {
        std::array<Component, 3> block{};
        const std::int64_t slope = random.between(0, max_slope), bend = random.between(0, 6000);
        for (Component& c : block) {
            const std::int64_t u = random.between(-slope, slope), v = slope - std::abs(u);
            c.f = {0, u, v, u + v};
            for (auto* g : {&c.gu, &c.gv, &c.guv})
                for (std::int64_t& word : *g) word = random.between(-bend, bend);
        }
        // As large as the rule still draws.
        const hw::MachineSpec spec;
        const auto action = [&] {
            return block_action({bounds(block[0]), bounds(block[1]), bounds(block[2])}, spec);
        };
        while (action() != BlockAction::draw)
            for (Component& c : block)
                for (auto* field : {&c.f, &c.gu, &c.gv, &c.guv})
                    for (std::int64_t& word : *field) word = word * 63 / 64;
        Corners g;
        expand<std::int32_t, 3>(block, g);
        for (std::size_t c = 0; c < 2; ++c)
            for (std::size_t v = 0; v < leaves; ++v)
                for (std::size_t u = 0; u < leaves; ++u) {
                    const auto [low, high] = std::minmax({g[c][v][u], g[c][v][u + 1],
                                                          g[c][v + 1][u], g[c][v + 1][u + 1]});
                    widest = std::max<std::int64_t>(widest, high - low);
                }
        ++drawn;
    }
    EXPECT_LE(widest, max_affine_leaf);
    EXPECT_GT(widest, max_slope / leaves - 128) << "the limit is reached";
    std::cout << "[ measured ] widest leaf of " << drawn << " blocks: " << widest << " units\n";
}

// A corner of a leaf differs from the block's exact surface by max_corner_error units at most.
TEST(LeafGrid, CornersAreWithinTheirErrorOfTheSurface) {
    Random random;
    double worst = 0;
    for (int n = 0; n < umbra78::test::effort(1000); ++n) {
        Control p = random_control(random, std::int64_t{1} << random.between(2, 20));
        for (std::int64_t& c : p) c *= 16;  // the corrections are exact
        const std::array<Component, 1> block{component_from_bezier(p)};
        std::array<CornerGrid<std::int64_t>, 1> g;
        expand<std::int64_t, 1>(block, g);
        for (std::size_t v = 0; v < corners; ++v)
            for (std::size_t u = 0; u < corners; ++u) {
                const Int128 off = g[0][v][u] * sixth_power(16) -
                                   exact_value(p, static_cast<int>(u), static_cast<int>(v), 16);
                ASSERT_TRUE((off < 0 ? -off : off) <= max_corner_error * sixth_power(16));
                worst = std::max(worst, std::abs(static_cast<double>(off)));
            }
    }
    std::cout << "[ measured ] worst error of a leaf's corner "
              << worst / static_cast<double>(sixth_power(16)) << " units\n";
}

Corners random_block(Random& random) {
    std::array<Component, 3> block{};
    for (std::size_t k = 0; k < 3; ++k) {
        Component& c = block[k];
        const std::int64_t at = random.between(-9, 9) * pixel_units;
        for (std::size_t corner = 0; corner < 4; ++corner) {
            c.f[corner] = at + random.between(-4 * pixel_units, 4 * pixel_units);
            c.gu[corner] = random.between(-4000, 4000);
            c.gv[corner] = random.between(-4000, 4000);
        }
    }
    Corners g;
    expand<std::int32_t, 3>(block, g);
    return g;
}

using Visited = std::multiset<std::tuple<int, int, int, int, std::int64_t>>;

// The windows leave out only what no triangle covers: every pixel tried on every triangle.
TEST(SampleCentres, VisitsEveryPixelThatATriangleCovers) {
    Random random;
    hw::MachineSpec spec;
    spec.xy_bits = 4;
    std::size_t total = 0;
    for (int n = 0; n < umbra78::test::effort(100); ++n) {
        const Corners g = random_block(random);
        Visited windowed, everywhere;
        sample_centres(g, spec, [&](const Sample& s) {
            windowed.insert({s.px, s.py, s.leaf_i, s.leaf_j, s.z});
        });
        for (int j = 0; j < leaves; ++j) {
            for (int i = 0; i < leaves; ++i) {
                const Corner c00 = corner_at(g, i, j), c10 = corner_at(g, i + 1, j);
                const Corner c01 = corner_at(g, i, j + 1), c11 = corner_at(g, i + 1, j + 1);
                for (int pixel = 0; pixel < 256; ++pixel) {
                    const int px = pixel % 16, py = pixel / 16;
                    const int x = (2 * px - 15) * 4096, y = (2 * py - 15) * 4096;
                    std::int64_t z = 0;
                    const auto try_triangle = [&](const Corner& b, const Corner& c) {
                        if (triangle_depth(c00, b, c, x, y, z))
                            everywhere.insert({px, py, i, j, z});
                    };
                    try_triangle(c10, c11);
                    try_triangle(c11, c01);
                }
            }
        }
        ASSERT_EQ(windowed, everywhere) << "block " << n;
        total += windowed.size();
    }
    EXPECT_GT(total, 100u);
}

TEST(SampleLeaves, PutsEachLeafsMeanIntoThePixelThatHoldsIt) {
    Random random;
    hw::MachineSpec spec;
    spec.xy_bits = 4;
    for (int n = 0; n < umbra78::test::effort(100); ++n) {
        const Corners g = random_block(random);
        int seen = 0, expected = 0;
        sample_leaves(g, spec, [&](const Sample& s) {
            ++seen;
            std::array<double, 3> mean{};
            for (std::size_t c = 0; c < 3; ++c) {
                const auto u = static_cast<std::size_t>(s.leaf_i);
                const auto v = static_cast<std::size_t>(s.leaf_j);
                mean[c] = (double(g[c][v][u]) + g[c][v][u + 1] + g[c][v + 1][u] +
                           g[c][v + 1][u + 1]) / 4;
            }
            EXPECT_EQ(s.x, std::floor(mean[0] + 0.5));
            EXPECT_EQ(s.y, std::floor(mean[1] + 0.5));
            EXPECT_EQ(static_cast<double>(s.z), std::floor(mean[2] + 0.5));
            EXPECT_EQ(s.px, std::floor(s.x / 8192.0) + 8);
            EXPECT_EQ(s.py, std::floor(s.y / 8192.0) + 8);
        });
        for (std::size_t v = 0; v < leaves; ++v) {
            for (std::size_t u = 0; u < leaves; ++u) {
                const auto inside = [&](std::size_t c) {
                    const std::int64_t sum = std::int64_t{g[c][v][u]} + g[c][v][u + 1] +
                                             g[c][v + 1][u] + g[c][v + 1][u + 1] + 2;
                    return sum >= -4 * 8 * pixel_units && sum < 4 * 8 * pixel_units;
                };
                expected += inside(0) && inside(1) ? 1 : 0;
            }
        }
        ASSERT_EQ(seen, expected);
    }
}

TEST(DepthCode, IsClampedBelowTheBackgroundAndRefusedOutside) {
    const hw::MachineSpec spec;  // 6 guard bits, code = round(z / 64) + 32768
    std::uint32_t code = 0;
    const auto z_of = [](std::int64_t c) { return (c - 32768) * 64; };
    EXPECT_TRUE(depth_code(z_of(0), spec, code));
    EXPECT_EQ(code, 0u);
    EXPECT_TRUE(depth_code(z_of(0) - 32, spec, code)) << "half a quantum rounds up";
    EXPECT_EQ(code, 0u);
    EXPECT_FALSE(depth_code(z_of(0) - 33, spec, code)) << "before the near plane";
    EXPECT_TRUE(depth_code(z_of(65534), spec, code));
    EXPECT_EQ(code, 65534u);
    EXPECT_TRUE(depth_code(z_of(65535), spec, code));
    EXPECT_EQ(code, 65534u) << "the background's code is not drawn";
    EXPECT_TRUE(depth_code(z_of(65535) + 31, spec, code));
    EXPECT_FALSE(depth_code(z_of(65535) + 32, spec, code)) << "behind the far plane";
}

}  // namespace
}  // namespace umbra78::raster
