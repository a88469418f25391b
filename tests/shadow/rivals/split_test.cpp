// Splitting equals brute force in every pixel, its pieces are a partition, and what does not fit is
// said.
#include "tests/shadow/rivals/object_space_scenes.hpp"
#include "tests/shadow/rivals/object_space_table.hpp"

#include <gtest/gtest.h>

namespace umbra78::shadow::rivals::test {
namespace {

constexpr std::uint32_t split_scenes = random_scenes;

TEST(Split, EqualsBruteForce) {
    std::uint64_t partly = 0, undone = 0, wide = 0, pieces = 0;
    for (std::uint32_t seed = 0; seed < split_scenes; ++seed) {
        const Scene scene(random_polygons(seed));
        const auto expected = scene.brute_mask();
        for (const bool only_seen : {true, false}) {
            ObjectSpace o(scene.setting(), scene.shown());
            ASSERT_EQ(o.split(only_seen), PieceStatus::ok) << "seed " << seed;
            ASSERT_EQ(o.mask(), expected) << "seed " << seed << ", seen " << only_seen;
            partly += o.split_counts().casters.partly;
            undone += o.split_counts().cuts.undone;
            wide += o.split_counts().cuts.signs.meetings;
            pieces += o.store().needed().pieces;
        }
    }
    EXPECT_GT(partly, enough(1'000));  // of planes that cross
    EXPECT_GT(undone, enough(1'000));
    EXPECT_GT(wide, enough(10'000));
    EXPECT_GT(pieces, enough(30'000));
}

// The widest words: a bound that is too small would trap.
TEST(Split, WideWordsFit) {
    std::uint64_t wide = 0;
    for (std::uint32_t seed = 0; seed < split_scenes / 10; ++seed) {
        const Scene scene(wide_polygons(seed));
        ObjectSpace o(scene.setting(), scene.shown());
        ASSERT_EQ(o.split(false), PieceStatus::ok) << "seed " << seed;
        ASSERT_EQ(o.mask(), scene.brute_mask()) << "seed " << seed;
        wide += o.split_counts().cuts.signs.meetings;
    }
    EXPECT_GT(wide, enough(10'000));
}

TEST(Split, PiecesAreAPartition) {
    for (std::uint32_t seed = 0; seed < split_scenes / 4; ++seed) {
        const Scene scene(random_polygons(seed));
        ObjectSpace o(scene.setting(), scene.shown());
        ASSERT_EQ(o.split(), PieceStatus::ok);
        expect_partition(o, scene.shown(), 1);
        ASSERT_FALSE(testing::Test::HasFailure()) << "seed " << seed;
    }
}

// A floor under n x n plates of two facets, no two of which overlap in the light's picture.
Polygons plates_over_floor(int n) {
    Polygons p = floor_under_light("plates_over_floor");
    const double step = 60.0 / n;
    for (int row = 0; row < n; ++row) {
        for (int column = 0; column < n; ++column) {
            const double x = column * step - 30, y = row * step - 30;
            p.quad(casting(x, y), casting(x + step / 2, y), casting(x + step / 2, y + step / 2),
                   casting(x, y + step / 2));
        }
    }
    return p;
}

// A shadow is asked of the pieces near it. If each were asked of all, four times as many plates
// would take sixteen times as many tests; and most pieces are passed by without asking their boxes.
TEST(Split, AWideFloorIsAskedWhereTheShadowFalls) {
    std::array<CutCounts, 2> counts{};
    for (std::size_t k = 0; k < 2; ++k) {
        const Scene scene(plates_over_floor(k == 0 ? 10 : 20));
        ObjectSpace o(scene.setting(), scene.shown(), {256, {4096, 32768, 64}, {8192, 65536}, {}});
        ASSERT_EQ(o.split(), PieceStatus::ok);
        EXPECT_EQ(o.mask(), scene.brute_mask());
        expect_partition(o, scene.shown(), 17);
        counts[k] = o.split_counts().cuts;
        EXPECT_LT(counts[k].boxes,
                  o.split_counts().casters.casters * lit_pieces(o.store()) / 4);
    }
    EXPECT_GT(counts[0].cuts, 400u);
    EXPECT_LT(counts[1].tests, 6 * counts[0].tests);
}

TEST(Split, CountsTheAreasOfNamedScenes) {
    for (const Answered& a : answered_scenes()) {
        const Scene scene(a.polygons);
        ObjectSpace o(scene.setting(), scene.shown());
        ASSERT_EQ(o.split(), PieceStatus::ok) << a.polygons.name;
        const auto mask = o.mask();
        EXPECT_EQ(static_cast<std::size_t>(std::count(mask.begin(), mask.end(), dark)),
                  a.dark_pixels) << a.polygons.name;
        for (std::size_t at = 0; at < mask.size(); ++at) {
            const double x = static_cast<double>(at % 64) - 31.5;
            const double y = static_cast<double>(at / 64) - 31.5;
            ASSERT_EQ(mask[at] == dark, a.is_dark(x, y)) << a.polygons.name << " at " << at;
        }
        EXPECT_EQ(mask, scene.brute_mask()) << a.polygons.name;
    }
}

TEST(Split, CountsOfTheFiguresScene) {
    for (int levels = 1; levels <= figures_levels; ++levels) {
        const FiguresScene scene(levels);
        check_split(scene, 1 << levels, true);
        check_split(scene, 1 << levels, false);
    }
}

// --- capacities -----------------------------------------------------------------------------

TEST(Split, SaysWhatDoesNotFit) {
    const Scene scene(through_each_other().polygons);
    ObjectSpace o(scene.setting(), scene.shown());
    ASSERT_EQ(o.split(false), PieceStatus::ok);
    const auto expected = o.mask();
    const PieceSize exact = o.store().needed();
    const std::size_t meetings = o.lines().meetings_needed();
    ASSERT_GT(meetings, 0u);

    // The store says exactly how much it takes.
    for (const PieceSize& less : {PieceSize{exact.pieces - 1, exact.lines},
                                  PieceSize{exact.pieces, exact.lines - 1}, PieceSize{}}) {
        o.give({meetings, {256, 2048, 32}, less});
        EXPECT_EQ(o.split(false), PieceStatus::no_room);
        EXPECT_EQ(o.store().needed().pieces, exact.pieces);
        EXPECT_EQ(o.store().needed().lines, exact.lines);
    }
    o.give({meetings - 1, {256, 2048, 32}, exact});
    EXPECT_EQ(o.split(false), PieceStatus::no_meetings);
    EXPECT_EQ(o.lines().meetings_needed(), meetings);

    // The work's room grows by what it says until it is enough.
    WorkSize work{};
    int tries = 0;
    for (;; ++tries) {
        o.give({meetings, work, exact});
        const PieceStatus status = o.split(false);
        if (status == PieceStatus::ok) break;
        ASSERT_EQ(status, PieceStatus::no_work_room);
        const WorkSize needed = o.lit_part().needed();
        ASSERT_TRUE(needed.pieces > work.pieces || needed.lines > work.lines ||
                    needed.longest > work.longest);
        work = needed;
        ASSERT_LT(tries, 100);
    }
    EXPECT_GT(tries, 1);
    EXPECT_EQ(o.mask(), expected);
}

}  // namespace
}  // namespace umbra78::shadow::rivals::test
