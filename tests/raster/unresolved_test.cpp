// What cannot be drawn is dropped and counted, and what can be is drawn all the same: blocks that
// are too large after all their halvings, patches that use up their splits, corners that have no
// quotient. Counts are exact.
#include "tests/raster/exact_frame.hpp"
#include "tests/support/drawing.hpp"

#include <gtest/gtest.h>

#include <memory>

namespace umbra78::raster {
namespace {

using namespace test;
using umbra78::test::Drawing;
using umbra78::test::Patches;
using umbra78::test::plane;

// A window of a few world words on a floor of 60 000 units: 24 halvings leave thousands of pixels.
TEST(Unresolved, BlocksOfTheLastLevelAreDroppedAndCounted) {
    MachineSpec spec;
    spec.xy_bits = 4;
    for (const std::int32_t extent : {1, 2, 16}) {
        for (const double lean : {0.0, 0.4}) {
            const Patches floor{
                plane_patch(plane({-16001, -16002, 0}, {32000, 0, lean}, {0, 32000, lean}))};
            View view = umbra78::test::orthographic(0, 0, 1);
            view.extent = extent;
            view.near_depth = -(std::int64_t{1} << 32);
            view.far_depth = std::int64_t{1} << 32;
            Drawing<hw::Depth32> stage(spec);
            const DrawCounts counts = stage.draw(floor, view, Sampling::centre);
            const hw::WordFormat object = object_format(floor);
            const std::vector<Material> materials(1);
            DrawSetup setup{spec, {}, object, Sampling::centre, materials, {}};
            ASSERT_EQ(load_view(view, spec, object, setup.matrix), hw::LoadStatus::ok);
            const ExactFrame expected(floor, setup);
            EXPECT_GT(counts.unresolved, 0u);
            EXPECT_EQ(counts.unresolved, expected.counts.unresolved) << "extent " << extent;
            EXPECT_EQ(counts.splits, expected.counts.splits);
            EXPECT_EQ(counts.tested_blocks, expected.counts.tested_blocks);
            EXPECT_EQ(counts.blocks, 0u);
            EXPECT_EQ(counts.samples, 0u);
        }
    }
}

// A patch that is a line through the eye, where the near plane is too near for the words of W: each
// half of it in its other direction is the same line. It uses up its splits, and its own only.
TEST(Unresolved, APatchHasItsSplitsAndTheNextItsOwn) {
    MachineSpec spec;
    spec.coefficient_bits = 24;
    spec.xy_bits = 4;
    View view = umbra78::test::perspective(0, 0, 2, 5, 1, 20);
    view.extent = 1;
    view.near_depth = 1;
    const Patches wall{plane_patch(plane({-7, -7, 4}, {14, 0, 0}, {0, 14, 0}))};  // a unit away
    Drawing<> alone(spec), both(spec);
    const DrawCounts one = alone.draw(wall, view, Sampling::centre);
    EXPECT_GT(one.samples, 0u);
    EXPECT_EQ(one.unresolved, 0u);
    const Patches patches{plane_patch(plane({0, 0, 6}, {0, 0, -2}, {0, 0, 0})), wall[0]};
    const DrawCounts counts = both.draw(patches, view, Sampling::centre);
    EXPECT_EQ(counts.splits, max_splits + one.splits);
    EXPECT_EQ(counts.tested_blocks, 2 * counts.splits + 2) << "a split gives two blocks";
    EXPECT_GT(counts.unresolved, 0u);
    EXPECT_EQ(counts.samples, one.samples);
    EXPECT_EQ(alone.depth(), both.depth());
}

// Corners without a quotient of 31 bits: W not positive, or X / W out of +-2^30.
TEST(Unresolved, CornersWithoutAQuotientDropTheirBlock) {
    const MachineSpec spec;  // 13 fraction bits of X and Y, 13 of Z
    const auto made = [&](std::size_t component, std::size_t v, std::size_t u, std::int64_t word) {
        const auto g = std::make_unique<std::array<CornerGrid<std::int64_t>, 4>>();
        for (auto& row : (*g)[3]) row.fill(1000);
        (*g)[component][v][u] = word;
        const auto out = std::make_unique<Corners>();
        return detail::divide_corners(*g, spec, *out);
    };
    const std::int64_t limit = (std::int64_t{1} << 30) * 1000;  // times 2^13: the quotient 2^30
    for (const std::size_t v : {std::size_t{0}, std::size_t{7}, std::size_t{16}}) {
        for (const std::size_t u : {std::size_t{0}, std::size_t{9}, std::size_t{16}}) {
            EXPECT_FALSE(made(3, v, u, 0));
            EXPECT_FALSE(made(3, v, u, -1));
            EXPECT_TRUE(made(3, v, u, 1));
            for (std::size_t c = 0; c < 3; ++c) {
                EXPECT_TRUE(made(c, v, u, limit / 8192 - 1));
                EXPECT_FALSE(made(c, v, u, limit / 8192));
                EXPECT_TRUE(made(c, v, u, -limit / 8192));
                EXPECT_FALSE(made(c, v, u, -limit / 8192 - 1));
            }
        }
    }
}

TEST(Divided, CornersAreQuotientsRoundedHalfUp) {
    Random random;
    MachineSpec spec;
    const auto g = std::make_unique<std::array<CornerGrid<std::int64_t>, 4>>();
    const auto out = std::make_unique<Corners>();
    for (int n = 0; n < 60; ++n) {
        spec.xy_bits = static_cast<int>(random.between(4, 12));
        spec.z_bits = static_cast<int>(random.between(4, 24));
        for (std::size_t v = 0; v < corners; ++v) {
            for (std::size_t u = 0; u < corners; ++u) {
                (*g)[3][v][u] = random.between(1, std::int64_t{1} << random.between(1, 43));
                for (std::size_t c = 0; c < 3; ++c)  // within 100 pixels, ties among them
                    (*g)[c][v][u] = random.bits() % 4 == 0 ? (*g)[3][v][u] / 2
                                                           : random.between(-100, 100) *
                                                                 ((*g)[3][v][u] / 3);
            }
        }
        ASSERT_TRUE(detail::divide_corners(*g, spec, *out));
        for (std::size_t c = 0; c < 3; ++c) {
            const int up = c == 2 ? depth_out(spec) : 13;
            for (std::size_t v = 0; v < corners; ++v)
                for (std::size_t u = 0; u < corners; ++u)
                    ASSERT_TRUE((*out)[c][v][u] ==
                                half_up_of((*g)[c][v][u] * power(std::max(up, 0)),
                                           (*g)[3][v][u] * power(std::max(-up, 0))))
                        << "component " << c;
        }
    }
}

}  // namespace
}  // namespace umbra78::raster
