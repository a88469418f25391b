// The alias-free shadow map, asked of exact planes, equals brute force at every size of its grid.
#include "tests/shadow/rivals/named_scenes.hpp"
#include "tests/shadow/rivals/scan_out.hpp"

#include <gtest/gtest.h>

namespace umbra78::shadow::rivals::test {
namespace {

TEST(Irregular, EqualsBruteForceInRandomScenes) {
    std::uint64_t asked = 0;
    for (std::uint32_t seed = 0; seed < random_scenes; ++seed) {
        const Scene scene(random_polygons(seed));
        const auto right = scene.brute_mask();
        for (const int texels : {1, 4, 32}) {
            IrregularCounts counts;
            ASSERT_EQ(mask_by_lists(scene.setting(), scene.shown(), texels, counts), right)
                << "seed " << seed << ", texels " << texels;
            asked += counts.facets_asked;
        }
    }
    EXPECT_GT(asked, enough(100'000));
}

void expect_lists_equal_in(const FiguresScene& scene) {
    const auto right = scene.brute_mask();
    std::uint64_t asked = 0;
    for (const int texels : {16, 128, 512}) {
        IrregularCounts counts;
        ASSERT_EQ(mask_by_lists(scene.setting(), scene.shown(), texels, counts), right) << texels;
        EXPECT_LE(counts.texels_filled, counts.samples);
        EXPECT_GE(counts.longest * counts.texels_filled, counts.samples);
        // What is asked is decided by boxes, not by texels.
        EXPECT_TRUE(asked == 0 || counts.facets_asked == asked);
        asked = counts.facets_asked;
        EXPECT_GE(counts.visits, asked);
    }
}

TEST(Irregular, EqualsBruteForceInTheNamedScenes) {
    for (const Polygons& p : named_scenes()) {
        const Scene scene(p);
        IrregularCounts counts;
        EXPECT_EQ(mask_by_lists(scene.setting(), scene.shown(), 16, counts), scene.brute_mask())
            << p.name;
    }
}

TEST(Irregular, EqualsBruteForceInTheFiguresScene) {
    for (int levels = 1; levels <= figures_levels; ++levels)
        expect_lists_equal_in(FiguresScene(levels, 9, -100));
    expect_lists_equal_in(FiguresScene(4, 7, -100));
}

TEST(Irregular, EqualsBruteForceWithALightAtAPlace) {
    expect_lists_equal_in(FiguresScene(2, 8, 40, 3));
    expect_lists_equal_in(FiguresScene(2, 8, -100, 3));
}

TEST(Irregular, SaysHowMuchItNeeds) {
    const FiguresScene scene(1, 6, -100);
    std::vector<std::uint8_t> mask(scene.shown().size());
    IrregularCounts counts;
    EXPECT_FALSE(irregular(scene.setting(), scene.shown(), {}, {}, mask, counts));
    const std::size_t needed = counts.bytes;
    Memory memory(needed);
    counts = {};
    EXPECT_FALSE(irregular(scene.setting(), scene.shown(), {}, memory.bytes().first(needed - 1),
                           mask, counts));
    counts = {};
    EXPECT_TRUE(irregular(scene.setting(), scene.shown(), {}, memory.bytes().first(needed), mask,
                          counts));
    EXPECT_EQ(mask, scene.brute_mask());
}

}  // namespace
}  // namespace umbra78::shadow::rivals::test
