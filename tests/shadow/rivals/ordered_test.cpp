// Crow's sides in the order of depth: brute force's mask and volumes' numbers, whatever the order
// does; and what the order takes.
#include "tests/shadow/rivals/class3.hpp"
#include "tests/shadow/rivals/named_scenes.hpp"
#include "tests/support/effort.hpp"

#include <gtest/gtest.h>

namespace umbra78::shadow::rivals::test {
namespace {

template <class Scene>
OrderedCounts expect_exact(const Scene& scene, const std::string& name) {
    OrderedCounts counts;
    const Setting& s = scene.setting();
    const Numbers numbers = ordered(s, scene.shown(), counts);
    EXPECT_EQ(numbers, summed(s, scene.shown())) << name;
    EXPECT_EQ(mask_of(s, scene.shown(), numbers), scene.brute_mask()) << name;
    return counts;
}

TEST(OrderedVolumes, EqualBruteForceInRandomScenes) {
    OrderedCounts all;
    std::uint64_t borders = 0;
    for (std::uint32_t seed = 0; seed < random_scenes && !testing::Test::HasFailure(); ++seed) {
        const Scene scene(random_polygons(seed));
        const OrderedCounts c = expect_exact(scene, "seed " + std::to_string(seed));
        all.swaps += c.swaps;
        all.compares += c.compares;
        all.changes += c.changes;
        all.longest = std::max(all.longest, c.longest);
        borders += c.start_tests > c.facets ? 1 : 0;  // the eye is on a volume's border
    }
    EXPECT_GT(all.swaps, enough(10'000));
    EXPECT_GT(all.compares, enough(100'000));
    EXPECT_GT(all.changes, enough(50'000));
    EXPECT_GT(borders, enough(100));
    EXPECT_GE(all.longest, 12u);
}

TEST(OrderedVolumes, EqualBruteForceInTheNamedScenes) {
    for (const Polygons& p : named_scenes()) expect_exact(Scene(p), p.name);
}

TEST(OrderedVolumes, EqualBruteForceInTheFiguresScene) {
    for (const int levels : {1, 2, 3}) expect_exact(FiguresScene(levels), "an eye far away");
    expect_exact(FiguresScene(4, 7), "16 cells a side");
    for (const int azimuth : {-100, 40})
        expect_exact(FiguresScene(2, 8, azimuth, 3), "an eye and a light at places");
}

// Crow supposes that the sides of one light never meet. A scan line passes through the ray where
// two do unless the ray is level, as all are with the figures' light.
TEST(OrderedVolumes, SidesMeetWhereContoursCross) {
    const auto swaps = [](int elevation) {
        return expect_exact(FiguresScene(3, 9, -100, 0, elevation), "a raised light").swaps;
    };
    EXPECT_EQ(swaps(0), 0u);
    EXPECT_EQ(swaps(30), 119u);
    Polygons p;
    for (const Polygons& named : named_scenes())
        if (named.name == "crossed_bars") p = named;
    EXPECT_EQ(expect_exact(Scene(p), "level").swaps, 0u);
    p.light.y = -32;
    EXPECT_EQ(expect_exact(Scene(p), "raised").swaps, 46u);
}

// n x n cubes stand on a floor.
Polygons cubes(int n) {
    Polygons p;
    p.xy_bits = 7;
    p.fraction = 4;
    p.light = {-64, -90, -40, 0};
    p.quad({-1000, 800, -1400}, {1000, 800, -1400}, {1000, -400, 1400}, {-1000, -400, 1400});
    const int step = 1600 / n, side = step / 2;
    for (int row = 0; row < n; ++row)
        for (int column = 0; column < n; ++column) {
            const int x = -800 + step * column, z = -700 + step * row;
            const int y = 200 - z * 3 / 7;
            p.box({x, y - side, z}, {x + side, y, z + side});
        }
    return p;
}

// Crow: where the visible surface changes, only the sides next to it need be compared.
TEST(OrderedVolumes, FewSidesMatterWhereTheVisibleSurfaceChanges) {
    // Hundredths a change: the sides that are open, and those that are compared.
    const std::array<std::array<std::uint64_t, 3>, 3> expected{
        {{1, 182, 129}, {4, 405, 147}, {8, 686, 142}}};
    for (const auto& [n, open, asked] : expected) {
        if (umbra78::test::sanitized && n > 4) break;
        const OrderedCounts c = expect_exact(Scene(cubes(static_cast<int>(n))), "cubes");
        EXPECT_EQ(100 * c.open_at_changes / c.changes, open) << n;
        EXPECT_EQ(100 * c.asked_at_changes / c.changes, asked) << n;
    }
}

TEST(OrderedVolumes, LinesWithoutObjectsAreSkipped) {
    Polygons p = named("a sheet", from_left);
    with_sheet(with_sheet(p, -100, -40, 100, 40, 96), -80, -24, 0, 24, 0);
    const OrderedCounts c = expect_exact(Scene(p), p.name);
    EXPECT_EQ(c.lines, 5u);
    EXPECT_EQ(c.rows, c.lines * c.sides);
    EXPECT_GT(c.sides, 0u);
}

TEST(OrderedVolumes, SayHowMuchRoomTheyNeed) {
    const Scene scene(cubes(2));
    const Setting& s = scene.setting();
    OrderedCounts counts;
    Numbers numbers(scene.shown().size());
    EXPECT_FALSE(order_volumes(s, scene.shown(), contour_of(s), {}, numbers, counts));
    const std::size_t needed = counts.bytes;
    Memory memory(needed);
    EXPECT_FALSE(order_volumes(s, scene.shown(), contour_of(s), memory.bytes().first(needed - 1),
                               numbers, counts));
    EXPECT_TRUE(order_volumes(s, scene.shown(), contour_of(s), memory.bytes().first(needed),
                              numbers, counts));
    EXPECT_EQ(numbers, summed(s, scene.shown()));
}

}  // namespace
}  // namespace umbra78::shadow::rivals::test
