// The post-process's cost depends on what is seen, not on what is drawn: ten times as many patches
// change neither its points nor its cycles, while drawing them grows.
#include "shadow/frame/ledger.hpp"
#include "shadow/frame/profiles.hpp"
#include "tests/claims/ground.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

namespace umbra78::claims {
namespace {

using raster::Patch;
using raster::World;
using shadow::figure_settings;
using shadow::PostProcessLedger;
using shadow::Settings;

using Patches = std::vector<Patch>;

struct Cost {
    shadow::FrameCounts counts;
    PostProcessLedger cycles;
    std::vector<std::uint8_t> mask;
};

std::uint64_t work(const Cost& cost, std::string_view stage) {
    for (const auto& row : cost.cycles.rows)
        if (row.stage == stage) return row.work;
    return 0;
}

Cost draw(const std::string& what, const Patches& patches) {
    shadow::Scene scene = figures().scene();
    scene.patches = patches;
    const Settings s = figure_settings(4);
    const shadow::test::Frame<> frame(scene, s);
    EXPECT_EQ(frame.status, shadow::FrameStatus::ok);
    const Cost cost{frame.counts,
                    frame_ledger({scene, s, frame.matrices}, frame.buffers, frame.counts)
                        .post_process,
                    {frame.buffers.lights[0].mask.begin(), frame.buffers.lights[0].mask.end()}};
    const auto number = [](std::uint64_t n) { return static_cast<unsigned long long>(n); };
    std::printf("%-28s %5llu patches, %7llu blocks and %8llu samples drawn in both views; "
                "post-process: %llu pixels, %llu cycles (multipliers %llu)\n",
                what.c_str(), number(cost.counts.observer.patches),
                number(cost.counts.observer.blocks + cost.counts.lights[0].map.blocks),
                number(cost.counts.observer.samples + cost.counts.lights[0].map.samples),
                number(cost.counts.lights[0].post_process.visible), number(cost.cycles.total),
                number(work(cost, "multiply")));
    return cost;
}

void expect_equal_cost(const Cost& a, const Cost& b) {
    EXPECT_EQ(a.counts.lights[0].post_process.visible, b.counts.lights[0].post_process.visible);
    EXPECT_EQ(a.cycles.total, b.cycles.total);
    for (int k = 0; k < a.cycles.count; ++k)
        EXPECT_EQ(a.cycles.rows[std::size_t(k)].work, b.cycles.rows[std::size_t(k)].work) << k;
}

Patches once() { return {figures().patches.begin(), figures().patches.end()}; }

// Every patch ten times in the same place: all drawn, none seen but the first.
TEST(Cost, TenCoincidentPatchesForOne) {
    Patches ten;
    for (const Patch& p : once()) ten.insert(ten.end(), 10, p);
    const Cost a = draw("figures", once()), b = draw("each patch ten times", ten);
    expect_equal_cost(a, b);
    EXPECT_EQ(a.mask, b.mask);
    EXPECT_GE(b.counts.observer.patches, 10 * a.counts.observer.patches);
    EXPECT_GT(b.counts.observer.samples + b.counts.lights[0].map.samples,
              5 * (a.counts.observer.samples + a.counts.lights[0].map.samples));
}

// Nine smaller spheres within each: drawn or left out, but never seen.
TEST(Cost, TenSpheresOneInAnother) {
    Patches ten;
    for (int shell = 9; shell >= 0; --shell)  // the outermost last, so that order is no help
        for (raster::Sphere sphere : shadow::figure_spheres) {
            sphere.radius -= shell * 4096;
            std::array<Patch, raster::patches_per_sphere> of_sphere;
            raster::sphere_patches(sphere, of_sphere);
            ten.insert(ten.end(), of_sphere.begin(), of_sphere.end());
        }
    const Cost a = draw("figures", once()), b = draw("nine spheres in each", ten);
    expect_equal_cost(a, b);
    EXPECT_EQ(a.mask, b.mask);
    EXPECT_EQ(b.counts.observer.patches, 10 * a.counts.observer.patches);
    EXPECT_GT(b.counts.observer.blocks + b.counts.lights[0].map.blocks,
              a.counts.observer.blocks + a.counts.lights[0].map.blocks);
}

// --- the same surface in sixteen times as many patches ------------------------------------------

using Points = std::array<std::array<std::int64_t, 3>, 4>;  // of a curve, Q.28

// De Casteljau at one half, twice: the quarter k of a curve. Twelve further bits keep it exact in
// both directions.
Points quarter(Points p, int k) {
    for (const int half : {k / 2, k % 2}) {
        for (std::size_t c = 0; c < 3; ++c) {
            const std::int64_t a = p[0][c], b = p[1][c], d = p[2][c], e = p[3][c];
            const std::int64_t ab = (a + b) / 2, bd = (b + d) / 2, de = (d + e) / 2;
            const std::int64_t left = (ab + bd) / 2, right = (bd + de) / 2;
            const std::int64_t middle = (left + right) / 2;
            const std::array<std::int64_t, 4> kept =
                half == 0 ? std::array{a, ab, left, middle} : std::array{middle, right, de, e};
            for (std::size_t i = 0; i < 4; ++i) p[i][c] = kept[i];
        }
    }
    return p;
}

Patch sixteenth(const Patch& patch, int ku, int kv) {
    std::array<std::array<std::int64_t, 3>, 16> p{};
    for (std::size_t n = 0; n < 16; ++n) {
        const World& w = patch.control[n];
        p[n] = {std::int64_t{w.x} << 12, std::int64_t{w.y} << 12, std::int64_t{w.z} << 12};
    }
    const auto along = [&](std::size_t first, std::size_t step, int k) {
        const Points q = quarter(
            {p[first], p[first + step], p[first + 2 * step], p[first + 3 * step]}, k);
        for (std::size_t i = 0; i < 4; ++i) p[first + i * step] = q[i];
    };
    for (std::size_t j = 0; j < 4; ++j) along(4 * j, 1, ku);
    for (std::size_t i = 0; i < 4; ++i) along(i, 4, kv);
    Patch out = patch;
    const auto word = [](std::int64_t q28) {
        return static_cast<std::int32_t>(fixed::round_shift(q28, 12, fixed::Rounding::half_even));
    };
    for (std::size_t n = 0; n < 16; ++n)
        out.control[n] = {word(p[n][0]), word(p[n][1]), word(p[n][2])};
    return out;
}

// The parts' control points are rounded to words again, so a Z here and there moves by a quantum,
// and a pixel or two at a silhouette are seen that were not: the cost follows those, and those
// alone.
TEST(Cost, SixteenPartsForEachPatch) {
    Patches parts;
    for (const Patch& p : once())
        for (int k = 0; k < 16; ++k) parts.push_back(sixteenth(p, k % 4, k / 4));
    const Cost a = draw("figures", once()), b = draw("each patch in 16 parts", parts);
    EXPECT_EQ(b.counts.observer.patches, 16 * a.counts.observer.patches);
    const std::uint64_t before = a.counts.lights[0].post_process.visible;
    const std::uint64_t after = b.counts.lights[0].post_process.visible;
    EXPECT_LE(after > before ? after - before : before - after, 4u);
    EXPECT_EQ(work(a, "multiply") + 3 * after, work(b, "multiply") + 3 * before);
    EXPECT_EQ(work(a, "fetch") + 4 * after, work(b, "fetch") + 4 * before);
    EXPECT_EQ(work(a, "read"), work(b, "read"));
    std::size_t differing = 0;
    for (std::size_t k = 0; k < a.mask.size(); ++k) differing += a.mask[k] != b.mask[k];
    std::printf("pixels of the mask that differ: %zu\n", differing);
    EXPECT_LT(differing, before / 1000);
}

// Fewer pixels seen cost less: the cost is a count, not a constant.
TEST(Cost, OfOneSphereIsLess) {
    Patches one = once();
    one.resize(raster::patches_per_sphere);
    const Cost a = draw("figures", once()), b = draw("one sphere", one);
    EXPECT_LT(3 * work(b, "multiply"), work(a, "multiply"));
    EXPECT_LT(3 * b.counts.lights[0].post_process.visible,
              a.counts.lights[0].post_process.visible);
}

// The paper, p. 273: a shadow costs about twice the plain rendering, less the shading of the
// light's view, plus a fixed transformation. On every profile of the fixed-point machine the two
// views take more than one and less than two of the observer's, and the transformation is small.
TEST(Cost, RoughlyTwicePlusAFixedTransformation) {
    struct Expected {
        const char* profile;
        int both_percent, transformation_permille;
    };
    for (const auto& [name, both_percent, transformation_permille] :
         {Expected{"affine16x1", 181, 15}, {"affine16", 161, 23}, {"affine16x16", 125, 11}}) {
        Settings s = figure_settings(4);
        shadow::apply(*shadow::find_profile(name), s);
        const shadow::test::Frame<> frame(figures().scene(), s);
        ASSERT_EQ(frame.status, shadow::FrameStatus::ok);
        const shadow::FrameLedger l = frame_ledger({figures().scene(), s, frame.matrices},
                                                   frame.buffers, frame.counts);
        const auto of = [&](std::uint64_t cycles) {
            return static_cast<double>(cycles) /
                   static_cast<double>(shadow::FrameLedger::cycles(l.observer, true));
        };
        const double both = 1 + of(shadow::FrameLedger::cycles(l.light, true));
        const double transformation = of(l.transformation(true));
        const double depth = static_cast<double>(l.observer_counts.samples) /
                             static_cast<double>(l.visible);
        std::printf("figure 4, %-12s both views %.2f of the observer's, transformation %.3f, "
                    "%.2f samples a visible pixel\n", name, both, transformation, depth);
        EXPECT_EQ(std::lround(100 * both), both_percent) << "under 2: the light is not shaded";
        EXPECT_EQ(std::lround(1000 * transformation), transformation_permille);
        EXPECT_EQ(std::lround(100 * depth), 267);
    }
}

}  // namespace
}  // namespace umbra78::claims
