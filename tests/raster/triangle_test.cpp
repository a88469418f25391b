// Triangles against their definition: which centres are covered, and Z by exact rationals; meshes
// that cover each centre once.
#include "fixed/wide_int.hpp"
#include "raster/triangle.hpp"
#include "tests/support/effort.hpp"
#include "tests/support/inputs.hpp"

#include <gtest/gtest.h>

#include <map>
#include <utility>
#include <vector>

namespace umbra78::raster {
namespace {

using Wide = fixed::WideInt<4>;
using Key = std::pair<int, int>;  // line, pixel
using umbra78::test::effort;
using umbra78::test::Inputs;

// The definition (hw/MACHINE.md, section 21): every centre of the frame, each by itself.
std::map<Key, std::int64_t> by_definition(Corner a, Corner b, Corner c,
                                          const hw::MachineSpec& spec) {
    std::map<Key, std::int64_t> out;
    std::int64_t area = detail::turn(a, b, c.x, c.y);
    if (area == 0) return out;
    if (area < 0) {
        std::swap(b, c);
        area = -area;
    }
    for (int py = 0; py < spec.size_px(); ++py) {
        for (int px = 0; px < spec.size_px(); ++px) {
            const std::int32_t x = pixel_centre(px, spec.half_px());
            const std::int32_t y = pixel_centre(py, spec.half_px());
            bool in = true;
            for (const auto& [p, q] : {std::pair{a, b}, {b, c}, {c, a}}) {
                const std::int64_t e = detail::turn(p, q, x, y);
                const bool owned = q.y < p.y || (q.y == p.y && q.x > p.x);
                in = in && (e > 0 || (e == 0 && owned));
            }
            if (!in) continue;
            const Wide rise =
                Wide(detail::turn(c, a, x, y)) * Wide(std::int64_t{b.z} - a.z) +
                Wide(detail::turn(a, b, x, y)) * Wide(std::int64_t{c.z} - a.z);
            // floor((2 rise + area) / (2 area)), for either sign
            const Wide top = rise + rise + Wide(area), bottom = Wide(2) * Wide(area);
            Wide q = top / bottom;
            if (q * bottom > top) q -= Wide(1);
            out[{py, px}] = a.z + q.to_int64();
        }
    }
    return out;
}

std::map<Key, std::int64_t> sampled(const Corner& a, const Corner& b, const Corner& c,
                                    const hw::MachineSpec& spec) {
    std::map<Key, std::int64_t> out;
    sample_triangle(a, b, c, spec, [&](const Sample& s) {
        EXPECT_TRUE((out.emplace(Key{s.py, s.px}, s.z).second)) << "sampled twice";
        EXPECT_EQ(s.x, pixel_centre(s.px, spec.half_px()));
        EXPECT_EQ(s.y, pixel_centre(s.py, spec.half_px()));
    });
    return out;
}

// Corners of sizes from a pixel to far out of the frame, many on centres and half pixels.
Corner random_corner(Inputs& random, int kind) {
    const auto within = [&](std::int64_t reach) {
        return static_cast<std::int32_t>(random.between(-reach, reach));
    };
    const std::int32_t z = kind % 2 == 0 ? within(1 << 22) : within(INT32_MAX / 2);
    const std::int32_t half = 1 << (raster_fraction - 1);
    switch (kind / 2) {
        case 0: return {within(16 << 13), within(16 << 13), z};
        case 1: return {within(20) * half, within(20) * half, z};
        case 2: return {within(max_screen), within(max_screen), z};
        case 3: return {within(24 << 13), within(3) * half, z};
        default: return {(within(12) * 2 + 1) * half + within(1), within(12) * half, z};
    }
}

TEST(Triangle, IsItsDefinitionBitForBit) {
    Inputs random(41);
    const hw::MachineSpec spec{.xy_bits = 5};
    std::uint64_t samples = 0, empty = 0;
    for (int n = 0; n < effort(6000); ++n) {
        const int kind = n % 10;
        const Corner a = random_corner(random, kind), b = random_corner(random, kind);
        const Corner c = n % 7 == 0 ? Corner{a.x, b.y, a.z} : random_corner(random, kind);
        const auto expected = by_definition(a, b, c, spec);
        EXPECT_EQ(sampled(a, b, c, spec), expected) << n;
        EXPECT_EQ(sampled(b, c, a, spec), expected) << n << ", turned";
        EXPECT_EQ(sampled(a, c, b, spec), expected) << n << ", the other way round";
        samples += expected.size();
        empty += expected.empty() ? 1 : 0;
    }
    EXPECT_GT(samples, 10u * effort(6000));
    EXPECT_GT(empty, 0u);
}

// Triangles small enough to be tested centre by centre, and larger ones, meet on centres.
TEST(Triangle, AFanCoversEachCentreOnce) {
    Inputs random(42);
    const hw::MachineSpec spec{.xy_bits = 5};
    const std::int32_t half = 1 << (raster_fraction - 1);
    const std::vector<Corner> rim{{-32 * half, -32 * half, 0}, {0, -32 * half, 0},
                                  {32 * half, -32 * half, 0},  {32 * half, 0, 0},
                                  {32 * half, 32 * half, 0},   {0, 32 * half, 0},
                                  {-32 * half, 32 * half, 0},  {-32 * half, 0, 0}};
    for (int n = 0; n < effort(400); ++n) {
        const bool on_a_centre = n % 2 == 0;
        const auto place = [&] {
            const auto v = static_cast<std::int32_t>(random.between(-15, 15));
            return on_a_centre ? (2 * v + 1) * half
                               : static_cast<std::int32_t>(random.between(-15 * 8192, 15 * 8192));
        };
        const Corner middle{place(), place(), 0};
        std::map<Key, int> covered;
        for (std::size_t k = 0; k < rim.size(); ++k)
            sample_triangle(middle, rim[k], rim[(k + 1) % rim.size()], spec,
                            [&](const Sample& s) { ++covered[{s.py, s.px}]; });
        EXPECT_EQ(covered.size(), 32u * 32u) << n;
        for (const auto& [at, times] : covered) EXPECT_EQ(times, 1) << n;
    }
}

TEST(Triangle, OwnsItsTopAndLeftEdges) {
    const hw::MachineSpec spec{.xy_bits = 4};
    const std::int32_t centre = 1 << (raster_fraction - 1), pixel = 1 << raster_fraction;
    // From centre (8, 8) to centre (11, 11): the square's upper left half, and its lower right.
    const Corner a{centre, centre, 0}, b{centre + 3 * pixel, centre, 0};
    const Corner c{centre, centre + 3 * pixel, 0}, d{centre + 3 * pixel, centre + 3 * pixel, 0};
    EXPECT_EQ(sampled(a, b, c, spec).size(), 6u);  // 3 + 2 + 1; the diagonal is the other's
    EXPECT_EQ(sampled(b, d, c, spec).size(), 3u);  // the diagonal is its left edge
    EXPECT_TRUE(sampled(a, b, c, spec).contains({8, 8}));
    EXPECT_FALSE(sampled(a, b, c, spec).contains({8, 11}));
}

TEST(Triangle, WithoutAreaHasNoSamples) {
    const hw::MachineSpec spec{.xy_bits = 4};
    const Corner a{-8192, 0, 5}, b{8192, 0, 5}, c{0, 0, 5};
    EXPECT_TRUE(sampled(a, b, c, spec).empty());
    EXPECT_TRUE(sampled(a, a, b, spec).empty());
    EXPECT_TRUE(sampled(a, a, a, spec).empty());
}

}  // namespace
}  // namespace umbra78::raster
