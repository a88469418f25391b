// Class 2 equals brute force in every named scene, in whatever order the facets are given.
#include "tests/shadow/rivals/named_scenes.hpp"
#include "tests/shadow/rivals/object_space.hpp"

#include <gtest/gtest.h>

namespace umbra78::shadow::rivals::test {
namespace {

// The facets in another order, and each begun at another of its corners.
Polygons in_another_order(Polygons p, std::uint32_t seed) {
    std::mt19937 random(seed);
    for (std::size_t n = p.facets.size(); n > 1; --n)
        std::swap(p.facets[n - 1], p.facets[random() % n]);
    for (Triangle& t : p.facets)
        std::rotate(t.vertex.begin(), t.vertex.begin() + random() % 3, t.vertex.end());
    return p;
}

TEST(ObjectSpaceScenes, EqualBruteForceInAnyOrderOfFacets) {
    const Capacities room{1024, {4096, 32768, 64}, {32768, 262144}, {4096, 32768, 128}};
    std::uint64_t pairs = 0, cycles = 0;
    for (const Polygons& named : named_scenes()) {
        for (std::uint32_t seed = 0; seed < 4; ++seed) {
            const Scene scene(seed == 0 ? named : in_another_order(named, seed));
            const auto expected = scene.brute_mask();
            ObjectSpace o(scene.setting(), scene.shown(), room);
            ASSERT_EQ(o.split(false), PieceStatus::ok) << named.name;
            EXPECT_EQ(o.mask(), expected) << named.name << ", split, order " << seed;
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
    EXPECT_GT(pairs, 100u);
    EXPECT_GT(cycles, 10u);
}

}  // namespace
}  // namespace umbra78::shadow::rivals::test
