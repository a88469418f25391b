// The order from the light puts no facet after one that it hides, and clipping by footprints in
// this order equals brute force, and so splitting, in every pixel.
#include "tests/shadow/rivals/object_space_scenes.hpp"
#include "tests/shadow/rivals/object_space_table.hpp"

#include <gtest/gtest.h>

namespace umbra78::shadow::rivals::test {
namespace {

constexpr std::uint32_t perimeter_scenes = random_scenes;

// How many fragments are placed after that of `on` which a pixel shows, and hide the point; 1 if
// no fragment has the point.
std::size_t placed_too_late(ObjectSpace& o, const Setting& s, std::uint32_t on, std::int32_t px,
                            std::int32_t py) {
    std::size_t late = 0;
    bool found = false;
    for (const std::uint32_t index : o.order().order()) {
        const Fragment& f = o.order().at(index);
        bool inside = true;
        for (const LineId id : o.order().lines(f))
            inside = inside && o.lines().shown(on, id).sign_at(px, py) > 0;
        if (f.facet == on) found = found || inside;
        if (found && inside && s.hides(s.light, f.facet, on, px, py)) ++late;
    }
    return found ? late : 1;
}

TEST(LightOrder, PutsNothingAfterWhatItHides) {
    std::uint64_t cycles = 0;
    for (std::uint32_t seed = 0; seed < perimeter_scenes / 10; ++seed) {
        const Scene scene(random_polygons(seed));
        const Setting& s = scene.setting();
        ObjectSpace o(s, scene.shown());
        ASSERT_EQ(o.sort_from_light(), OrderStatus::ok) << "seed " << seed;
        cycles += o.order_counts().cycles;
        for (std::size_t at = 0; at < scene.shown().size(); at += 3) {
            const std::uint32_t on = scene.shown()[at];
            if (on == nothing_seen || s.light.sides[on] == 0) continue;
            ASSERT_EQ(placed_too_late(o, s, on, s.space.centre(static_cast<int>(at % 8)),
                                      s.space.centre(static_cast<int>(at / 8))), 0u)
                << "seed " << seed << ", pixel " << at;
        }
    }
    EXPECT_GT(cycles, enough(500));
}

// The plates of a stack come one after the other, and what has no fragment has no rank.
TEST(LightOrder, RanksFacetsByTheirNearestFragment) {
    Polygons p = floor_under_light("stack");
    for (const std::int32_t above : {64, 192, 128}) {
        p.quad(casting(-8, -8, above), casting(8, -8, above), casting(8, 8, above),
               casting(-8, 8, above));
    }
    p.triangle(casting(-12, 1, -200), casting(12, 1, -200), casting(0, 1, 200));  // edge-on
    const Scene scene(p);
    ObjectSpace o(scene.setting(), scene.shown());
    ASSERT_EQ(o.sort_from_light(), OrderStatus::ok);
    std::vector<std::uint32_t> ranks(scene.setting().mesh.facets.size());
    o.order().rank_facets(ranks);
    const auto pair = [&](std::size_t f) {
        return std::pair(std::min(ranks[f], ranks[f + 1]), std::max(ranks[f], ranks[f + 1]));
    };
    EXPECT_EQ(pair(4), std::pair(0u, 1u));
    EXPECT_EQ(pair(6), std::pair(2u, 3u));
    EXPECT_EQ(pair(2), std::pair(4u, 5u));
    EXPECT_EQ(pair(0), std::pair(6u, 7u));
    EXPECT_EQ(ranks[8], LightOrder::none);
}

TEST(Perimeters, EqualBruteForce) {
    std::uint64_t cycles = 0, left_out = 0;
    for (std::uint32_t seed = 0; seed < perimeter_scenes; ++seed) {
        const Scene scene(random_polygons(seed));
        ObjectSpace o(scene.setting(), scene.shown());
        ASSERT_EQ(o.sort_from_light(), OrderStatus::ok) << "seed " << seed;
        ASSERT_EQ(o.clip(), PieceStatus::ok) << "seed " << seed;
        ASSERT_EQ(o.mask(), scene.brute_mask()) << "seed " << seed;
        cycles += o.order_counts().cycles;
        left_out += o.perimeter_counts().fragments - o.perimeter_counts().joined;
        if (seed % 16 != 0) continue;
        expect_partition(o, scene.shown(), 1);
        ASSERT_FALSE(testing::Test::HasFailure()) << "seed " << seed;
    }
    EXPECT_GT(cycles, enough(5'000));
    EXPECT_GT(left_out, enough(5'000));
}

// With footprints merged by two the masks are the same.
TEST(Perimeters, MergedByTwoEqualBruteForce) {
    std::uint64_t pairs = 0;
    for (std::uint32_t seed = 0; seed < perimeter_scenes; ++seed) {
        const Scene scene(random_polygons(seed));
        ObjectSpace o(scene.setting(), scene.shown());
        ASSERT_EQ(o.sort_from_light(), OrderStatus::ok) << "seed " << seed;
        ASSERT_EQ(o.clip(true), PieceStatus::ok) << "seed " << seed;
        ASSERT_EQ(o.mask(), scene.brute_mask()) << "seed " << seed;
        if (seed % 16 == 0) expect_partition(o, scene.shown(), 1);
        ASSERT_FALSE(testing::Test::HasFailure()) << "seed " << seed;
        pairs += o.perimeter_counts().pairs;
    }
    EXPECT_GT(pairs, enough(1'000));
}

// A flap stands on the edge of a sheet that lies in the floor's plane. Their outline is convex, but
// the sheet, which reaches toward the light and so is a footprint before the floor is clipped,
// darkens nothing of it, and is not taken with the flap.
TEST(Perimeters, APartnerInTheFloorsPlaneDarkensNothing) {
    Polygons p = floor_under_light("flap");
    const std::int32_t unit = words_a_pixel;
    const Point a{0, -8 * unit, 0}, b{0, 8 * unit, 0};
    p.triangle(a, b, {40 * unit, 0, 0}).triangle(a, b, {-5 * unit, 0, -5 * unit});
    const Scene scene(p);
    ObjectSpace o(scene.setting(), scene.shown());
    ASSERT_EQ(o.sort_from_light(), OrderStatus::ok);
    ASSERT_EQ(o.clip(true), PieceStatus::ok);
    const auto mask = o.mask();
    EXPECT_EQ(mask, scene.brute_mask());
    EXPECT_EQ(std::count(mask.begin(), mask.end(), dark), 40);  // what the flap leaves to be seen
}

// The widest words, with lines of meetings on third facets: a bound that is too small would trap.
TEST(Perimeters, WideWordsFit) {
    std::uint64_t cycles = 0;
    for (std::uint32_t seed = 0; seed < perimeter_scenes / 20; ++seed) {
        const Scene scene(wide_polygons(seed));
        ObjectSpace o(scene.setting(), scene.shown());
        ASSERT_EQ(o.sort_from_light(), OrderStatus::ok) << "seed " << seed;
        ASSERT_EQ(o.clip(), PieceStatus::ok) << "seed " << seed;
        ASSERT_EQ(o.mask(), scene.brute_mask()) << "seed " << seed;
        cycles += o.order_counts().cycles;
    }
    EXPECT_GT(cycles, enough(500));
}

TEST(Perimeters, CountTheAreasOfNamedScenes) {
    for (const Answered& a : answered_scenes()) {
        const Scene scene(a.polygons);
        ObjectSpace o(scene.setting(), scene.shown());
        ASSERT_EQ(o.sort_from_light(), OrderStatus::ok) << a.polygons.name;
        for (const bool in_pairs : {true, false}) {
            o.give({});
            ASSERT_EQ(o.sort_from_light(), OrderStatus::ok) << a.polygons.name;
            ASSERT_EQ(o.clip(in_pairs), PieceStatus::ok) << a.polygons.name;
            EXPECT_EQ(o.mask(), scene.brute_mask()) << a.polygons.name;
        }
        const auto mask = o.mask();
        EXPECT_EQ(static_cast<std::size_t>(std::count(mask.begin(), mask.end(), dark)),
                  a.dark_pixels) << a.polygons.name;
        EXPECT_EQ(mask, scene.brute_mask()) << a.polygons.name;
        const bool has_cycle =
            a.polygons.name == "cycle_of_three" || a.polygons.name == "through_each_other";
        EXPECT_EQ(o.order_counts().cycles > 0, has_cycle) << a.polygons.name;
    }
}

TEST(Perimeters, CountsOfTheFiguresScene) {
    for (int levels = 1; levels <= figures_levels; ++levels) {
        const FiguresScene scene(levels);
        check_perimeters(scene, 1 << levels, false);
        check_perimeters(scene, 1 << levels, true);
    }
}

TEST(Perimeters, SayWhatDoesNotFit) {
    const Scene scene(cycle_of_three().polygons);
    ObjectSpace o(scene.setting(), scene.shown());
    ASSERT_EQ(o.sort_from_light(), OrderStatus::ok);
    ASSERT_EQ(o.clip(), PieceStatus::ok);
    const auto expected = o.mask();
    const PieceSize exact = o.store().needed();
    const std::size_t meetings = o.lines().meetings_needed();
    ASSERT_GT(meetings, 0u);
    o.give({meetings, {256, 2048, 32}, {exact.pieces - 1, exact.lines}});
    ASSERT_EQ(o.sort_from_light(), OrderStatus::ok);
    EXPECT_EQ(o.clip(), PieceStatus::no_room);
    EXPECT_EQ(o.store().needed().pieces, exact.pieces);
    o.give({meetings - 1, {256, 2048, 32}, exact});
    EXPECT_EQ(o.sort_from_light(), OrderStatus::no_meetings);

    // The order's room grows by what it says until it is enough.
    FragmentSize size{};
    int tries = 0;
    for (;; ++tries) {
        o.give({meetings, {256, 2048, 32}, exact, size});
        const OrderStatus status = o.sort_from_light();
        if (status == OrderStatus::ok) break;
        ASSERT_EQ(status, OrderStatus::no_room);
        const FragmentSize needed = o.order().needed();
        ASSERT_TRUE(needed.fragments > size.fragments || needed.lines > size.lines ||
                    needed.room > size.room);
        size = needed;
        ASSERT_LT(tries, 100);
    }
    EXPECT_GT(tries, 1);
    ASSERT_EQ(o.clip(), PieceStatus::ok);
    EXPECT_EQ(o.mask(), expected);
}

}  // namespace
}  // namespace umbra78::shadow::rivals::test
