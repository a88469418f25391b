// Random scenes of coinciding words: the rivals equal brute force in every pixel.
#include "tests/shadow/rivals/scenes.hpp"

#include <gtest/gtest.h>

namespace umbra78::shadow::rivals::test {
namespace {

// The scenes do test something: what they show, what is lit, dark, and exactly on a border.
TEST(RivalFuzz, ScenesAreFullOfTies) {
    std::size_t seen = 0, attached = 0, cast = 0, ties = 0;
    for (std::uint32_t seed = 0; seed < 1000; ++seed) {
        const Scene scene(random_polygons(seed));
        const Setting& s = scene.setting();
        const auto mask = scene.brute_mask();
        for (std::size_t at = 0; at < mask.size(); ++at) {
            const std::uint32_t on = scene.shown()[at];
            if (on == nothing_seen) continue;
            ++seen;
            attached += s.attached(on) ? 1 : 0;
            cast += mask[at] == dark && !s.attached(on) ? 1 : 0;
            const std::int32_t px = s.space.centre(static_cast<int>(at % 8));
            const std::int32_t py = s.space.centre(static_cast<int>(at / 8));
            for (const SeenPlane& edge : s.light.edges)
                ties += meet(s.planes[on], edge).value(px, py).is_zero() ? 1 : 0;
        }
    }
    EXPECT_GT(attached, 2'000u);
    EXPECT_GT(cast, 500u);
    EXPECT_GT(seen - attached - cast, 2'000u);
    EXPECT_GT(ties, 3'000u);
}

// Which brute force asks by lines that it keeps.
TEST(RivalFuzz, BruteForceIsWhatHides) {
    for (std::uint32_t seed = 0; seed < random_scenes; ++seed) {
        const Scene scene(random_polygons(seed));
        const Setting& s = scene.setting();
        const auto mask = scene.brute_mask();
        const int size = s.space.size_px();
        for (std::size_t at = 0; at < mask.size(); ++at) {
            const std::uint32_t on = scene.shown()[at];
            const int column = static_cast<int>(at) % size, row = static_cast<int>(at) / size;
            const bool is_dark = on != nothing_seen &&
                                 (s.attached(on) || surfaces_before(s, on, column, row) > 0);
            ASSERT_EQ(mask[at], is_dark ? dark : lit) << "seed " << seed << ", pixel " << at;
        }
    }
}

TEST(RivalFuzz, TheGridLeavesOutNothing) {
    for (std::uint32_t seed = 0; seed < random_scenes; ++seed) {
        const Scene scene(random_polygons(seed));
        std::vector<std::uint8_t> mask(scene.shown().size());
        for (const int cells : {0, 1, 8}) {
            LightGrid grid;
            std::size_t needed = 0;
            Memory memory(1 << 16);
            ASSERT_TRUE(grid.build(scene.setting(), cells, memory.bytes(), needed)) << needed;
            BruteCounts counts;
            brute(scene.setting(), scene.shown(), &grid, mask, counts);
            ASSERT_EQ(mask, scene.brute_mask()) << "seed " << seed << ", cells " << cells;
        }
    }
}

TEST(RivalFuzz, VolumesCountTheSurfaces) {
    for (std::uint32_t seed = 0; seed < random_scenes; ++seed) {
        const Scene scene(random_polygons(seed));
        const Setting& s = scene.setting();
        std::vector<ContourEdge> contour(find_contour(s, {}));
        find_contour(s, contour);
        std::vector<std::int32_t> surfaces(scene.shown().size());
        VolumeCounts counts;
        count_volumes(s, scene.shown(), contour, surfaces, counts);
        std::vector<std::uint8_t> mask(surfaces.size());
        mask_of_counts(s, scene.shown(), surfaces, mask);
        ASSERT_EQ(mask, scene.brute_mask()) << "seed " << seed;
        if (seed % 16 != 0) continue;
        for (std::size_t at = 0; at < mask.size(); ++at) {
            const std::uint32_t on = scene.shown()[at];
            if (on == nothing_seen || s.attached(on)) continue;
            const auto column = static_cast<int>(at % 8), row = static_cast<int>(at / 8);
            ASSERT_EQ(surfaces[at], static_cast<int>(surfaces_before(s, on, column, row)))
                << "seed " << seed << ", pixel " << at;
        }
    }
}

}  // namespace
}  // namespace umbra78::shadow::rivals::test
