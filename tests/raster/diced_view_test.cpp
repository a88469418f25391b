// Diced patches in a view: what is called outside gives no sample, and a footprint holds every
// sample. Object words are so coarse here that a vertex's rounding is up to several pixels, and
// patches lie about the frame's edges.
#include "raster/diced_view.hpp"

#include "raster/draw.hpp"
#include "tests/fixed/boundary.hpp"
#include "tests/support/effort.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>

namespace umbra78::raster {
namespace {

using fixed::test::Random;

// Keeps the bounds of what it is given.
struct BoundsSink {
    static constexpr bool shades = false;
    std::int32_t x0 = INT32_MAX, y0 = INT32_MAX, x1 = INT32_MIN, y1 = INT32_MIN;
    std::uint32_t nearest = UINT32_MAX, farthest = 0;

    bool hidden(const Footprint&) const { return false; }
    void sample(const Sample& s, std::uint32_t code, const auto*) {
        x0 = std::min<std::int32_t>(x0, s.px);
        x1 = std::max<std::int32_t>(x1, s.px);
        y0 = std::min<std::int32_t>(y0, s.py);
        y1 = std::max<std::int32_t>(y1, s.py);
        nearest = std::min(nearest, code);
        farthest = std::max(farthest, code);
    }
    bool within(const Footprint& f) const {
        return x0 >= f.x0 && y0 >= f.y0 && x1 <= f.x1 && y1 <= f.y1 && nearest >= f.nearest &&
               farthest <= f.farthest;
    }
};

struct Case {
    DrawSetup setup;
    Patch patch;
    bool loaded = false;

    DrawCounts draw(Drawn drawn, DrawMemory& memory, BoundsSink& sink) const {
        DrawSetup s = setup;
        s.drawn = drawn;
        return raster::draw(std::span(&patch, 1), {}, s, memory, sink);
    }
};

// A view of some 1 to 16 units, object words of 2^-2 to 2^-8 unit, and a patch that is about as
// large as the frame, a quarter of it or a few words, somewhere about the frame or its edge.
Case random_case(Random& random) {
    Case c;
    DrawSetup& s = c.setup;
    s.spec.xy_bits = static_cast<int>(random.between(4, 5));
    s.spec.z_bits = static_cast<int>(random.between(0, 1)) * 8 + 8;
    s.spec.coefficient_bits = 24;
    s.form = PatchForm::diced;
    s.dice_levels = static_cast<int>(random.between(0, 3));
    s.object = {16, static_cast<int>(random.between(2, 8))};
    View view;
    view.axes = axes_from_angles(static_cast<std::int32_t>(random.between(-180, 180)) << 16,
                                 static_cast<std::int32_t>(random.between(-80, 80)) << 16);
    view.extent = static_cast<std::int32_t>(1 << random.between(15, 19));
    const bool eye = random.between(0, 2) == 0;
    view.near_depth = eye ? view.extent / 2 : -2 * std::int64_t{view.extent};
    view.far_depth = eye ? 4 * std::int64_t{view.extent} : 2 * std::int64_t{view.extent};
    if (eye) {
        view.projection = Projection::perspective;
        view.distance = 2 * view.extent;
    }
    const auto within = [&](std::int64_t reach) {
        return static_cast<std::int32_t>(random.between(-reach, reach));
    };
    const std::int32_t far = 3 * (view.extent / 2);
    const World middle{within(far), within(far), within(far)};
    const std::int32_t size = random.between(0, 1) != 0 ? view.extent / 4
                              : random.between(0, 1) != 0 ? view.extent
                                                          : 4 << (16 - s.object.fraction);
    for (World& w : c.patch.control)
        w = {middle.x + within(size), middle.y + within(size), middle.z + within(size)};
    c.loaded = load_view(view, s.spec, s.object, s.matrix) == hw::LoadStatus::ok;
    return c;
}

// Whether bounds of the control points' own words call a patch outside, in an affine view.
bool outside_by_its_control_points(const Case& c) {
    if (!c.setup.matrix.affine) return false;
    const hw::TransformUnit unit(c.setup.spec, c.setup.matrix, c.setup.object, hw::UnitWork{});
    const std::int64_t edge = c.setup.spec.half_px() * pixel_units;
    std::array<std::int64_t, 2> min{INT64_MAX, INT64_MAX}, max{INT64_MIN, INT64_MIN};
    for (const hw::Words& words : to_object_words(c.patch, c.setup.object)) {
        const ScreenPlace p = affine_place(unit, words);
        for (std::size_t k = 0; k < 2; ++k) {
            min[k] = std::min(min[k], p[k]);
            max[k] = std::max(max[k], p[k]);
        }
    }
    return min[0] > edge || max[0] < -edge || min[1] > edge || max[1] < -edge;
}

TEST(DicedView, WhatIsOutsideGivesNoSample) {
    Random random;
    const auto memory = std::make_unique<DrawMemory>();
    int outside = 0, drawn = 0, undecided = 0, in_perspective = 0;
    const int rounds = umbra78::test::sanitized ? 2000 : 40000;
    for (int k = 0; k < rounds && !HasFailure(); ++k) {
        const Case c = random_case(random);
        if (!c.loaded) continue;
        const DicedView view(c.setup.spec, c.setup.matrix, c.setup.object);
        BoundsSink sink, of_inside, of_outside;
        const DrawCounts all = c.draw(Drawn::all, *memory, sink);
        Footprint footprint{};
        const Visibility v = view.footprint(c.patch, footprint);
        ASSERT_EQ(v == Visibility::outside, view.outside(c.patch));
        const DrawCounts inside = c.draw(Drawn::inside, *memory, of_inside);
        const DrawCounts left_out = c.draw(Drawn::outside, *memory, of_outside);
        EXPECT_EQ(inside.patches, v == Visibility::outside ? 0u : 1u);
        EXPECT_EQ(left_out.patches, 1 - inside.patches);
        EXPECT_EQ(inside.samples, all.samples);
        if (v == Visibility::outside) {
            EXPECT_EQ(all.samples, 0u) << "case " << k;
            ++outside;
            in_perspective += !c.setup.matrix.affine;
        } else if (all.samples > 0) {
            EXPECT_TRUE(sink.within(footprint)) << "case " << k;
            ++drawn;
        } else {
            ++undecided;
        }
    }
    std::printf("outside %d (%d in perspective), drawn %d, undecided %d\n", outside,
                in_perspective, drawn, undecided);
    EXPECT_GT(outside, rounds / 10);
    EXPECT_GT(in_perspective, rounds / 100);
    EXPECT_GT(drawn, rounds / 10);
}

// The worst case: in a view at 45 degrees X is x - z, and each control point's x is half an object
// word above a word, so that it is rounded up, its z a world word less than that, so that it is
// rounded down. All come to lie at 9 words, the frame's edge is at 8.9; most vertices at 8.
TEST(DicedView, TheControlPointsOwnWordsAreNoBound) {
    Case c;
    c.setup.spec.xy_bits = 5;
    c.setup.spec.coefficient_bits = 24;
    c.setup.form = PatchForm::diced;
    c.setup.dice_levels = 2;
    c.setup.object = {16, 4};
    constexpr std::int32_t word = 1 << 12, edge_words = 8;
    View view;
    view.axes = axes_from_angles(45 << 16, 0);
    view.extent = 25777;  // 8.9 words over the root of 2
    view.near_depth = -(16 << 16);
    view.far_depth = 16 << 16;
    ASSERT_EQ(load_view(view, c.setup.spec, c.setup.object, c.setup.matrix), hw::LoadStatus::ok);
    for (std::int32_t k = 0; k < 16; ++k) {
        const std::int32_t i = k % 4, j = k / 4, bend = i % 3 == 0 ? 0 : 300;
        c.patch.control[static_cast<std::size_t>(k)] = {
            i * word + word / 2, (2 * j - 3) * word + bend,
            (i - edge_words) * word + word / 2 - 1};
    }
    const auto memory = std::make_unique<DrawMemory>();
    BoundsSink sink;
    EXPECT_TRUE(outside_by_its_control_points(c));
    EXPECT_GT(c.draw(Drawn::all, *memory, sink).samples, 5u);
    EXPECT_FALSE(DicedView(c.setup.spec, c.setup.matrix, c.setup.object).outside(c.patch));
}

// A square that faces the observer is moved over an edge of the frame in steps of a world word. As
// soon as it is past the edge by the margin it is called outside: of 2 object words and a 64th of a
// pixel.
TEST(DicedView, DecidesWithinItsMargin) {
    Case c;
    c.setup.spec.xy_bits = 5;
    c.setup.form = PatchForm::diced;
    c.setup.object = {16, 12};  // an object word is 16 world words
    View view;
    view.axes = axes_from_angles(0, 0);
    view.extent = 1 << 16;
    view.near_depth = -(1 << 16);
    view.far_depth = 1 << 16;
    ASSERT_EQ(load_view(view, c.setup.spec, c.setup.object, c.setup.matrix), hw::LoadStatus::ok);
    const DicedView seen(c.setup.spec, c.setup.matrix, c.setup.object);
    const auto at = [](std::int32_t x) {
        return plane_patch({{x, -(1 << 15), 0}, {1 << 16, 0, 0}, {0, 1 << 16, 0}, 0});
    };
    EXPECT_FALSE(seen.outside(at((1 << 16) + 32)));
    const std::int32_t pixel_64th = (1 << 17 >> 5) / 64;
    EXPECT_TRUE(seen.outside(at((1 << 16) + 16 * 2 + pixel_64th + 16)));
    EXPECT_FALSE(seen.outside(at(-(2 << 16) - 32)));
    EXPECT_TRUE(seen.outside(at(-(2 << 16) - 16 * 2 - pixel_64th - 16)));
}

}  // namespace
}  // namespace umbra78::raster
