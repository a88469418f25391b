// What casts: sides, slopes against exact rationals, and maps of one side beside maps of both.
#include "raster/casters.hpp"

#include "tests/raster/exact_blocks.hpp"
#include "tests/support/drawing.hpp"
#include "tests/support/effort.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace umbra78::raster {
namespace {

using fixed::test::Random;
using test::ceiling_of;
using test::Int128;
using test::magnitude;

TEST(Casters, ASideIsTheSignOfTheArea) {
    const std::array<std::int64_t, 3> areas{-7, 0, 7};
    const std::array<std::array<bool, 3>, 3> drawn{
        {{true, true, true}, {true, false, false}, {false, false, true}}};
    for (std::size_t facing = 0; facing < 3; ++facing)
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_EQ(is_drawn(static_cast<Facing>(facing), areas[k]), drawn[facing][k])
                << facing << " " << areas[k];
}

// The plane's normal by its own formula: Z changes by -nx / nz for a unit of X.
TEST(Casters, ASlopeIsThePlanesRoundedUp) {
    Random random;
    int large = 0, edge_on = 0;
    for (int n = 0; n < umbra78::test::effort(200000); ++n) {
        const std::int64_t reach = std::int64_t{1} << random.between(4, 29);
        const std::int64_t rise = std::int64_t{1} << random.between(0, 29);
        std::array<Corner, 3> t{};
        for (Corner& c : t)
            c = {static_cast<std::int32_t>(random.between(-reach, reach)),
                 static_cast<std::int32_t>(random.between(-reach, reach)),
                 static_cast<std::int32_t>(random.between(-rise, rise))};
        if (n % 50 == 0) t[2] = {t[0].x, t[0].y, t[2].z};
        const auto& [a, b, c] = t;
        const Int128 nx = Int128{b.y - a.y} * (c.z - a.z) - Int128{b.z - a.z} * (c.y - a.y);
        const Int128 ny = Int128{b.z - a.z} * (c.x - a.x) - Int128{b.x - a.x} * (c.z - a.z);
        const Int128 nz = Int128{b.x - a.x} * (c.y - a.y) - Int128{b.y - a.y} * (c.x - a.x);
        Int128 expected = 0;
        if (nz != 0) {
            expected = ceiling_of(8192 * std::max(magnitude(nx), magnitude(ny)), magnitude(nz));
            large += expected > INT32_MAX ? 1 : 0;
            expected = std::min<Int128>(expected, INT32_MAX);
        }
        edge_on += nz == 0 ? 1 : 0;
        ASSERT_EQ(depth_slope(a, b, c), static_cast<std::int64_t>(expected)) << "case " << n;
        ASSERT_EQ(depth_slope(b, c, a), depth_slope(a, b, c)) << "case " << n;
        ASSERT_EQ(depth_slope(a, c, b), depth_slope(a, b, c)) << "case " << n;
    }
    EXPECT_GT(large, 0);
    EXPECT_GT(edge_on, umbra78::test::effort(200000) / 60);
}

TEST(Casters, AnOffsetIsRoundedUpAndLimited) {
    Casters half{.slope_q8 = 128};
    for (const auto& [slope, offset] :
         {std::pair{0, 0}, {1, 1}, {2, 1}, {3, 2}, {INT32_MAX, 1 << 30}})
        EXPECT_EQ(half.offset(slope), offset) << slope;
    half.limit = 1;
    EXPECT_EQ(half.offset(2), 1);
    EXPECT_EQ(half.offset(3), 1);
    half.limit = 0;
    EXPECT_EQ(half.offset(3), 0);
    EXPECT_EQ((Casters{.slope_q8 = 64 << 8}.offset(INT32_MAX)), std::int64_t{INT32_MAX} << 6);
    EXPECT_TRUE(Casters{}.all_alike());
    EXPECT_FALSE((Casters{.slope_q8 = 1}.all_alike()));
    EXPECT_FALSE((Casters{.facing = Facing::back}.all_alike()));
}

umbra78::test::Patches some_patches() {
    umbra78::test::Patches patches;
    umbra78::test::add_sphere(patches, umbra78::test::sphere(-0.5, 0.4, 0, 1.1));
    umbra78::test::add_sphere(patches, umbra78::test::sphere(0.9, -0.7, 0.4, 0.8));
    patches.push_back(plane_patch(
        umbra78::test::plane({-2, -1.5, -1}, {4, 0, 0}, {0, 1, -2})));
    return patches;
}

// Each sample shows one side, so the nearer of both sides' maps is the map of both; a sphere's
// sides are its near and its far half.
TEST(Casters, BothSidesTogetherAreTheWhole) {
    hw::MachineSpec spec;
    spec.xy_bits = 7;
    const auto patches = some_patches();
    for (const PatchForm form : {PatchForm::catmull, PatchForm::diced})
        for (const Sampling sampling : {Sampling::centre, Sampling::leaf})
            for (const bool eye : {false, true}) {
                const View view = eye ? umbra78::test::perspective(20, 30, 2, 6, 2, 12)
                                      : umbra78::test::orthographic(20, 30, 2);
                umbra78::test::Drawing<> both(spec), front(spec), back(spec);
                front.casters.facing = Facing::front;
                back.casters.facing = Facing::back;
                for (umbra78::test::Drawing<>* d : {&both, &front, &back}) {
                    d->form = form;
                    d->dice_tolerance = 100;
                    d->facing = Facing::front;  // a map's own sides come first
                }
                both.facing = Facing::both;
                const DrawCounts all = both.draw(patches, view, sampling, nullptr, {}, false);
                const DrawCounts fronts = front.draw(patches, view, sampling, nullptr, {}, false);
                const DrawCounts backs = back.draw(patches, view, sampling, nullptr, {}, false);
                EXPECT_EQ(all.samples, fronts.samples + backs.samples);
                int farther = 0;
                for (std::size_t k = 0; k < both.depth().size(); ++k) {
                    ASSERT_EQ(both.depth()[k], std::min(front.depth()[k], back.depth()[k])) << k;
                    farther += back.depth()[k] != 65535 && back.depth()[k] > front.depth()[k];
                }
                EXPECT_GT(farther, 2000);
            }
}

// A plane of known slope: all codes move by the same quanta, up to the limit and the far plane.
TEST(Casters, APlaneMovesAsAWhole) {
    const umbra78::test::Patches patches{plane_patch(
        umbra78::test::plane({-1, -1, -0.5}, {2, 0, 0.5}, {0, 2, 1}))};
    const View view = umbra78::test::orthographic(0, 0, 2);
    umbra78::test::Drawing<> plain, moved, limited, far;
    plain.draw(patches, view, Sampling::centre);
    moved.casters.slope_q8 = 3 << 8;  // dz/dy is 1/2: 64 quanta a texel
    moved.draw(patches, view, Sampling::centre);
    limited.casters = {Facing::both, 3 << 8, 100 << 6};
    limited.draw(patches, view, Sampling::centre);
    far.casters.slope_q8 = 64 << 8;
    far.casters.slope_q8 *= 20;
    far.draw(patches, view, Sampling::centre);
    int seen = 0;
    for (std::size_t k = 0; k < plain.depth().size(); ++k) {
        if (plain.depth()[k] == 65535) continue;
        ++seen;
        ASSERT_NEAR(moved.depth()[k], plain.depth()[k] + 192, 2) << k;
        ASSERT_EQ(limited.depth()[k], plain.depth()[k] + 100) << k;
        ASSERT_EQ(far.depth()[k], 65534) << k;
    }
    EXPECT_GT(seen, 60000);
}

}  // namespace
}  // namespace umbra78::raster
