// Clipping by outlines equals brute force in every pixel, its loops are what they are said to be,
// and what does not fit is said.
#include "tests/shadow/rivals/object_space_scenes.hpp"
#include "tests/shadow/rivals/object_space_table.hpp"
#include "tests/support/effort.hpp"

#include <gtest/gtest.h>

namespace umbra78::shadow::rivals::test {
namespace {

TEST(Atherton, EqualsBruteForce) {
    ClipCounts all;
    std::uint64_t wrong = 0, partly = 0, longest = 0;
    for (std::uint32_t seed = 0; seed < random_scenes; ++seed) {
        const Scene scene(random_polygons(seed));
        const auto expected = scene.brute_mask();
        for (const bool only_seen : {true, false}) {
            Outlines o(scene.setting(), scene.shown());
            ASSERT_EQ(o.clip(only_seen), PieceStatus::ok) << "seed " << seed;
            ASSERT_EQ(o.mask(), expected) << "seed " << seed << ", seen " << only_seen;
            const AthertonCounts& c = o.counts();
            all.walks += c.clips.walks, all.holes += c.clips.holes;
            all.inside += c.clips.inside, all.moved.ties += c.clips.moved.ties;
            wrong += c.wrong, partly += c.casters.partly;
            EXPECT_LE(c.casters.partly, c.casters.casters);
            EXPECT_LE(c.casters.casters, c.casters.planes);
            longest = std::max(longest, c.longest);
        }
    }
    EXPECT_GT(all.walks, enough(10'000));
    EXPECT_GT(all.holes, enough(100));
    EXPECT_GT(all.inside, enough(1'000));
    EXPECT_GT(all.moved.ties, enough(10'000));
    EXPECT_GT(wrong, enough(1'000));
    EXPECT_GT(partly, enough(1'000));
    EXPECT_GT(longest, 6u);
}

// The widest words: a bound that is too small would trap.
TEST(Atherton, WideWordsFit) {
    std::uint64_t wide = 0;
    for (std::uint32_t seed = 0; seed < random_scenes / 10; ++seed) {
        const Scene scene(wide_polygons(seed));
        Outlines o(scene.setting(), scene.shown());
        ASSERT_EQ(o.clip(), PieceStatus::ok) << "seed " << seed;
        ASSERT_EQ(o.mask(), scene.brute_mask()) << "seed " << seed;
        wide += o.counts().clips.moved.signs.meetings;
    }
    EXPECT_GT(wide, enough(10'000));
}

TEST(Atherton, CountsTheAreasOfNamedScenes) {
    for (const Answered& a : answered_scenes()) {
        const Scene scene(a.polygons);
        Outlines o(scene.setting(), scene.shown());
        ASSERT_EQ(o.clip(), PieceStatus::ok) << a.polygons.name;
        const auto mask = o.mask();
        EXPECT_EQ(static_cast<std::size_t>(std::count(mask.begin(), mask.end(), dark)),
                  a.dark_pixels) << a.polygons.name;
        EXPECT_EQ(mask, scene.brute_mask()) << a.polygons.name;
    }
}

TEST(Atherton, CountsOfTheFiguresScene) {
    for (const int levels : {1, 2, 3}) {
        if (umbra78::test::sanitized && levels > 2) break;
        const FiguresScene scene(levels);
        check_outlines(scene, 1 << levels, true);
        check_outlines(scene, 1 << levels, false);
    }
}

// --- loops ----------------------------------------------------------------------------------

// Loops and sides that are left of the facet of the floor that has them both.
LoopSize of_facet(const LoopList& store, std::uint32_t facet) {
    LoopSize size;
    for (const Loop& loop : store.loops())
        if (loop.facet == facet) ++size.loops, size.sides += loop.count;
    return size;
}

// A plate of two facets leaves one hole, which the second facet makes larger; a plate that comes
// later and is greater takes the hole away again.
TEST(Atherton, NeighboursLeaveOneHole) {
    Polygons p = floor_under_light("plate");
    p.quad(casting(10, -20), casting(20, -20), casting(20, -10), casting(10, -10));
    const Scene plate(p);
    Outlines one(plate.setting(), plate.shown());
    ASSERT_EQ(one.clip(), PieceStatus::ok);
    EXPECT_EQ(one.counts().clips.holes, 1u);
    EXPECT_EQ(one.counts().clips.changed, 2u);
    EXPECT_EQ(of_facet(one.store(), 0).loops, 2u);
    EXPECT_GE(of_facet(one.store(), 0).sides, 3u + 4u);
    EXPECT_LE(of_facet(one.store(), 0).sides, 3u + 6u);  // with what is left at the shared corners

    p.triangle(casting(-24, -30, -200), casting(30, -30, -200), casting(28, 20, -200));
    const Scene two(p);
    Outlines both(two.setting(), two.shown());
    ASSERT_EQ(both.clip(), PieceStatus::ok);
    EXPECT_EQ(both.mask(), two.brute_mask());
    EXPECT_EQ(both.counts().clips.holes, 3u);  // two in the floor, one in the triangle itself
    EXPECT_GE(both.counts().clips.inside, 1u);
    EXPECT_EQ(of_facet(both.store(), 0).loops, 2u);
    EXPECT_EQ(of_facet(both.store(), 0).sides, 6u);
}

// The four plates around a gap leave the gap, as a loop of its own within the hole.
TEST(Atherton, ALoopWithinAHole) {
    Polygons p = floor_under_light("frame");
    p.quad(casting(6, -26, 8), casting(24, -26, 8), casting(24, -22, 8), casting(6, -22, 8));
    p.quad(casting(6, -12, 16), casting(24, -12, 16), casting(24, -8, 16), casting(6, -8, 16));
    p.quad(casting(7, -25, 32), casting(10, -25, 32), casting(10, -9, 32), casting(7, -9, 32));
    p.quad(casting(20, -25, 64), casting(23, -25, 64), casting(23, -9, 64), casting(20, -9, 64));
    const Scene scene(p);
    Outlines o(scene.setting(), scene.shown());
    ASSERT_EQ(o.clip(), PieceStatus::ok);
    EXPECT_EQ(o.mask(), scene.brute_mask());
    EXPECT_EQ(of_facet(o.store(), 0).loops, 3u);
}

// --- capacities -----------------------------------------------------------------------------

TEST(Atherton, SaysWhatDoesNotFit) {
    const Scene scene(through_each_other().polygons);
    Outlines o(scene.setting(), scene.shown());
    ASSERT_EQ(o.clip(), PieceStatus::ok);
    const auto expected = o.mask();
    const LoopSize exact = o.store().count();
    const std::size_t meetings = o.lines().meetings_needed();
    ASSERT_GT(meetings, 0u);

    for (const LoopSize& less : {LoopSize{exact.loops - 1, exact.sides},
                                 LoopSize{exact.loops, exact.sides - 1}, LoopSize{}}) {
        o.give({meetings, {{64, 512}, 64}, less});
        EXPECT_EQ(o.clip(), PieceStatus::no_room);
        EXPECT_EQ(o.store().count().loops, exact.loops);
        EXPECT_EQ(o.store().count().sides, exact.sides);
    }
    o.give({meetings - 1, {{64, 512}, 64}, exact});
    EXPECT_EQ(o.clip(), PieceStatus::no_meetings);
    EXPECT_EQ(o.lines().meetings_needed(), meetings);

    // The work's room grows by what it says until it is enough.
    ClipSize work{};
    int tries = 0;
    for (;; ++tries) {
        o.give({meetings, work, exact});
        const PieceStatus status = o.clip();
        if (status == PieceStatus::ok) break;
        ASSERT_EQ(status, PieceStatus::no_work_room);
        const ClipSize needed = o.work().needed();
        ASSERT_TRUE(needed.loops.loops > work.loops.loops ||
                    needed.loops.sides > work.loops.sides || needed.crossings > work.crossings);
        work = needed;
        ASSERT_LT(tries, 100);
    }
    EXPECT_GT(tries, 1);
    EXPECT_EQ(o.mask(), expected);
}

}  // namespace
}  // namespace umbra78::shadow::rivals::test
