// Class 2 equals brute force in every named scene, in whatever order the facets are given.
#include "tests/shadow/rivals/atherton.hpp"
#include "tests/shadow/rivals/named_scenes.hpp"
#include "tests/shadow/rivals/object_space.hpp"
#include "tests/support/effort.hpp"

#include <gtest/gtest.h>

namespace umbra78::shadow::rivals::test {
namespace {

TEST(ObjectSpaceScenes, EqualBruteForceInAnyOrderOfFacets) {
    const Capacities room{1024, {4096, 32768, 64}, {32768, 262144}, {4096, 32768, 128}};
    std::uint64_t pairs = 0, cycles = 0, holes = 0, scenes = 0;
    for (const Polygons& named : named_scenes()) {
        if (umbra78::test::sanitized && ++scenes % 2 == 0) continue;
        for (std::uint32_t seed = 0; seed < (umbra78::test::sanitized ? 1u : 2u); ++seed) {
            const Scene scene(seed == 0 ? named : in_another_order(named, seed));
            const auto expected = scene.brute_mask();
            ObjectSpace o(scene.setting(), scene.shown(), room);
            ASSERT_EQ(o.split(false), PieceStatus::ok) << named.name;
            EXPECT_EQ(o.mask(), expected) << named.name << ", split, order " << seed;
            Outlines outlines(scene.setting(), scene.shown());
            ASSERT_EQ(outlines.clip(), PieceStatus::ok) << named.name;
            EXPECT_EQ(outlines.mask(), expected) << named.name << ", outlines, order " << seed;
            holes += outlines.counts().clips.holes;
            for (const bool in_pairs : {false, true}) {
                o.give(room);
                ASSERT_EQ(o.sort_from_light(), OrderStatus::ok) << named.name;
                ASSERT_EQ(o.clip(in_pairs), PieceStatus::ok) << named.name;
                EXPECT_EQ(o.mask(), expected) << named.name << ", merged " << in_pairs
                                              << ", order " << seed;
                pairs += o.perimeter_counts().pairs;
                cycles += o.order_counts().cycles;
            }
        }
    }
    EXPECT_GT(pairs, umbra78::test::sanitized ? 50u : 100u);
    EXPECT_GT(cycles, umbra78::test::sanitized ? 2u : 10u);
    EXPECT_GT(holes, umbra78::test::sanitized ? 2u : 10u);
}

}  // namespace
}  // namespace umbra78::shadow::rivals::test
