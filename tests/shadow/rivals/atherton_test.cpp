// Clipping by outlines equals brute force in every pixel, its loops are what they are said to be,
// and what does not fit is said.
#include "tests/shadow/rivals/atherton.hpp"
#include "tests/shadow/rivals/figures_scene.hpp"
#include "tests/shadow/rivals/object_space_scenes.hpp"

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
    std::printf("walks %llu holes %llu inside %llu ties %llu wrong %llu partly %llu longest %llu\n", (unsigned long long)all.walks, (unsigned long long)all.holes, (unsigned long long)all.inside, (unsigned long long)all.moved.ties, (unsigned long long)wrong, (unsigned long long)partly, (unsigned long long)longest);
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

TEST(Atherton, EqualsBruteForceInTheFiguresScene) {
    for (const int levels : {1, 2, 3}) {
        const FiguresScene scene(levels);
        for (const bool only_seen : {true, false}) {
            Outlines o(scene.setting(), scene.shown(), {1024, {{256, 8192}, 4096}, {65536, 500000}});
            ASSERT_EQ(o.clip(only_seen), PieceStatus::ok);
            EXPECT_EQ(o.mask(), scene.brute_mask());
            const AthertonCounts& c = o.counts();
            std::printf("%d: recv %lu cast %lu wrong %lu clips %lu corners %lu crossings %lu compares %lu walks %lu flat %lu holes %lu inside %lu signs %lu ties %lu loops %lu sides %lu longest %lu\n", levels, c.receivers, c.casters.casters, c.wrong, c.clips.clips, c.clips.corners, c.clips.crossings, c.clips.compares, c.clips.walks, c.clips.flat, c.clips.holes, c.clips.inside, c.clips.moved.signs.edges + c.clips.moved.signs.meetings, c.clips.moved.ties, c.loops, c.sides, c.longest);
        }
    }
}

}  // namespace
}  // namespace umbra78::shadow::rivals::test
