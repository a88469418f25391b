// Links leave out no facet that shadows another, and sectors change none.
#include "shadow/rivals/facet_picture.hpp"
#include "tests/shadow/rivals/scan_out.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace umbra78::shadow::rivals::test {
namespace {

std::vector<std::uint32_t> sorted_links(const Links& links, std::size_t facet) {
    const auto list = links.of(facet);
    std::vector<std::uint32_t> sorted(list.begin(), list.end());
    std::sort(sorted.begin(), sorted.end());
    return sorted;
}

TEST(PictureBox, OverlapsWhereBothHaveAPlace) {
    const PictureBox box{-3, 4, 10, 20};  // both ends are in it
    EXPECT_TRUE(box.overlaps(box));
    EXPECT_TRUE(box.overlaps({0, 1, 12, 13}));
    for (const PictureBox& touching : {PictureBox{4, 9, 20, 30}, PictureBox{-9, -3, 0, 10}}) {
        EXPECT_TRUE(box.overlaps(touching));
        EXPECT_TRUE(touching.overlaps(box));
    }
    for (const PictureBox& beside : {PictureBox{5, 9, 10, 20}, PictureBox{-9, -4, 10, 20},
                                     PictureBox{-3, 4, 21, 22}, PictureBox{-3, 4, 8, 9}}) {
        EXPECT_FALSE(box.overlaps(beside));
        EXPECT_FALSE(beside.overlaps(box));
    }
}

TEST(RivalLinks, LeaveOutNoFacetThatShadows) {
    std::size_t shadows = 0, links = 0, left_out = 0;
    for (std::uint32_t seed = 0; seed < random_scenes; ++seed) {
        const Scene scene(random_polygons(seed));
        const Setting& s = scene.setting();
        const Linked linked(s, scene.shown());
        const Linked before(s, scene.shown(), {0, true, true});
        links += linked.counts.links;
        left_out += linked.counts.links - before.counts.links;
        const auto size = static_cast<std::size_t>(s.space.size_px());
        for (std::size_t at = 0; at < scene.shown().size(); ++at) {
            const std::uint32_t on = scene.shown()[at];
            if (on == nothing_seen || s.attached(on)) continue;
            const auto list = linked.links.of(on), shorter = before.links.of(on);
            for (std::uint32_t f = 0; f < s.mesh.facets.size(); ++f) {
                if (!s.hides(s.light, f, on, s.space.centre(static_cast<int>(at % size)),
                             s.space.centre(static_cast<int>(at / size))))
                    continue;
                ++shadows;
                ASSERT_EQ(std::count(list.begin(), list.end(), f), 1)
                    << "seed " << seed << ": facet " << f << " shadows " << on;
                ASSERT_EQ(std::count(shorter.begin(), shorter.end(), f), 1)
                    << "before the plane, seed " << seed << ": facet " << f << " shadows " << on;
            }
        }
    }
    EXPECT_GT(shadows, enough(10'000));
    EXPECT_GT(links, enough(20'000));
    EXPECT_GT(left_out, enough(3'000));
}

TEST(RivalLinks, AreThoseOfEveryPairWhateverTheSectors) {
    for (std::uint32_t seed = 0; seed < 2'000; ++seed) {
        const Scene scene(random_polygons(seed));
        const Setting& s = scene.setting();
        const Linked one(s, scene.shown(), {1, true, false});
        for (const int cells : {0, 2, 8, 32}) {
            const Linked many(s, scene.shown(), {cells, true, false});
            for (std::size_t f = 0; f < s.mesh.facets.size(); ++f)
                ASSERT_EQ(sorted_links(one.links, f), sorted_links(many.links, f))
                    << "seed " << seed << ", facet " << f << ", cells " << cells;
        }
        const Linked all(s, {}, {1, false, false});
        for (std::size_t f = 0; f < s.mesh.facets.size(); ++f) {
            if (one.links.of(f).empty()) continue;
            ASSERT_EQ(sorted_links(one.links, f), sorted_links(all.links, f)) << "seed " << seed;
        }
    }
}

// A floor, a roof over it, and one below: boxes and depths decide.
TEST(RivalLinks, AskBoxAndDepth) {
    Polygons p;
    p.light = {0, 0, -8, 0};
    p.triangle({0, 0, 0}, {64, 0, 0}, {0, 64, 0});           // the receiver
    p.triangle({8, 8, -9}, {24, 8, -9}, {8, 24, -9});        // over it
    p.triangle({80, 8, -9}, {99, 8, -9}, {80, 24, -9});      // over nothing
    p.triangle({8, 8, 9}, {24, 8, 9}, {8, 24, 9});           // below
    p.triangle({8, 8, 0}, {24, 8, 0}, {8, 24, 0});           // in its plane
    p.triangle({64, 0, -9}, {99, 0, -9}, {99, 24, -9});      // touches its box at a corner
    const Scene scene(p);
    const Linked linked(scene.setting(), {}, {0, false, false});
    const auto& mesh = scene.setting().mesh;
    std::size_t receiver = 0;
    for (std::size_t f = 0; f < mesh.facets.size(); ++f)
        if (mesh.corners(f)[0] == Point{0, 0, 0}) receiver = f;
    const auto list = sorted_links(linked.links, receiver);
    ASSERT_EQ(list.size(), 2u);
    EXPECT_EQ(mesh.corners(list[0])[0], (Point{8, 8, -9}));
    EXPECT_EQ(mesh.corners(list[1])[0], (Point{64, 0, -9}));
}

TEST(RivalLinks, SayHowMuchTheyNeed) {
    const FiguresScene scene(1, 6, -100);
    Links links;
    LinkCounts counts;
    std::size_t needed = 0;
    EXPECT_EQ(links.build(scene.setting(), scene.shown(), {}, {}, needed, counts),
              LinkStatus::no_room);
    const std::size_t before_links = needed;
    Memory some(before_links);
    EXPECT_EQ(links.build(scene.setting(), scene.shown(), {}, some.bytes().first(before_links),
                          needed, counts),
              LinkStatus::no_room);
    EXPECT_GT(needed, before_links);
    const std::size_t all = needed;
    Memory enough(all);
    EXPECT_EQ(links.build(scene.setting(), scene.shown(), {}, enough.bytes().first(all - 1), needed,
                          counts),
              LinkStatus::no_room);
    EXPECT_EQ(needed, all);
    EXPECT_EQ(links.build(scene.setting(), scene.shown(), {}, enough.bytes().first(all), needed,
                          counts),
              LinkStatus::ok);
}

// Crow: with S sectors S (N / S)^2 tests. Facets that several cells share are the remainder.
TEST(RivalLinks, SectorsSaveTestsUntilTheyAreAsSmallAsFacets) {
    const FiguresScene scene(2, 9, -100);
    std::vector<std::uint64_t> tests;
    for (int cells = 1; cells <= 64; cells *= 2) {
        const Linked linked(scene.setting(), scene.shown(), {cells, true, false});
        tests.push_back(linked.counts.box_tests);
    }
    EXPECT_GT(tests[0], 3 * tests[1]);  // 1 to 4 sectors
    EXPECT_GT(tests[1], tests[3]);
    EXPECT_LT(tests[4], tests[6]);      // 256 to 4096: worse again
}

}  // namespace
}  // namespace umbra78::shadow::rivals::test
