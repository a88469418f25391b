// Appel's quantitative invisibility, carried along, equals the number counted by brute force.
#include "tests/shadow/rivals/named_scenes.hpp"
#include "tests/shadow/rivals/scan_out.hpp"

#include <gtest/gtest.h>

namespace umbra78::shadow::rivals::test {
namespace {

std::vector<std::int32_t> carried_numbers(const Setting& s, std::span<const std::uint32_t> shown,
                                          const LightGrid* grid, const Bordered& bordered,
                                          bool carry, AppelCounts& counts) {
    std::vector<CounterChange> room(bordered.counts.longest);
    std::vector<std::int32_t> numbers(shown.size(), 77);
    fixed::require(appel(s, shown, grid, bordered.borders, {carry}, room, numbers, counts),
                   "a test's room for crossings");
    return numbers;
}

// The invariant, at each pixel and so at each run's end.
TEST(Appel, CarriesTheNumberOfSurfacesInRandomScenes) {
    std::array<AppelCounts, 2> all{};
    for (std::uint32_t seed = 0; seed < random_scenes; ++seed) {
        const Scene scene(random_polygons(seed));
        const Setting& s = scene.setting();
        const Linked linked(s, scene.shown());
        const Bordered bordered(s, linked.links);
        std::vector<std::int32_t> right(scene.shown().size());
        for (std::size_t at = 0; at < right.size(); ++at) {
            const std::uint32_t on = scene.shown()[at];
            if (on != nothing_seen && !s.attached(on))
                right[at] = static_cast<std::int32_t>(
                    surfaces_before(s, on, static_cast<int>(at % 8), static_cast<int>(at / 8)));
        }
        for (const bool carry : {false, true})
            ASSERT_EQ(carried_numbers(s, scene.shown(), nullptr, bordered, carry, all[carry]),
                      right)
                << "seed " << seed << ", carry " << carry;
        std::vector<std::uint8_t> mask(right.size());
        mask_of_counts(s, scene.shown(), right, mask);
        ASSERT_EQ(mask, scene.brute_mask()) << "seed " << seed;
    }
    const AppelCounts& c = all[1];
    EXPECT_EQ(c.seeds, c.first + c.not_joined + c.contour + c.vertex + c.border_on_edge);
    EXPECT_EQ(c.seeds + c.carried, c.runs);
    EXPECT_EQ(all[0].seeds, all[0].runs);
    // The scenes do ask for each case.
    EXPECT_GT(c.carried, enough(300));
    EXPECT_GT(c.not_joined, enough(300));
    EXPECT_GT(c.contour, enough(20));
    EXPECT_GE(c.vertex, enough(3));
    EXPECT_GE(c.border_on_edge, enough(3));
    EXPECT_GT(c.crossings, enough(1'000));
}

// `coarse`: facets are larger than pixels, so that most follow a neighbour.
void expect_mask_in(const FiguresScene& scene, bool coarse = true) {
    const Setting& s = scene.setting();
    const Linked linked(s, scene.shown());
    const Bordered bordered(s, linked.links);
    const Gridded gridded(s);
    const auto right = scene.brute_mask();
    for (const bool carry : {false, true}) {
        AppelCounts counts;
        const auto numbers =
            carried_numbers(s, scene.shown(), &gridded.grid, bordered, carry, counts);
        std::vector<std::uint8_t> mask(numbers.size());
        mask_of_counts(s, scene.shown(), numbers, mask);
        ASSERT_EQ(mask, right) << "carry " << carry;
        if (carry) {
            EXPECT_EQ(counts.carried > counts.seeds, coarse);
        }
    }
}

TEST(Appel, EqualsBruteForceInTheNamedScenes) {
    for (const Polygons& p : named_scenes()) {
        const Scene scene(p);
        const Setting& s = scene.setting();
        const Linked linked(s, scene.shown());
        const Bordered bordered(s, linked.links);
        AppelCounts counts;
        const auto numbers =
            carried_numbers(s, scene.shown(), nullptr, bordered, true, counts);
        std::vector<std::uint8_t> mask(numbers.size());
        mask_of_counts(s, scene.shown(), numbers, mask);
        EXPECT_EQ(mask, scene.brute_mask()) << p.name;
    }
}

TEST(Appel, EqualsBruteForceInTheFiguresScene) {
    for (int levels = 1; levels <= figures_levels; ++levels)
        expect_mask_in(FiguresScene(levels, 9, -100));
    expect_mask_in(FiguresScene(4, 7, -100), false);
}

TEST(Appel, EqualsBruteForceWithALightAtAPlace) {
    expect_mask_in(FiguresScene(2, 8, 40, 3));
    expect_mask_in(FiguresScene(2, 8, -100, 3));
}

TEST(Appel, SaysHowLongAListWas) {
    Polygons p;
    p.light = {-4, 0, -8, 0};
    p.quad({-512, -512, 0}, {512, -512, 0}, {512, 512, 0}, {-512, 512, 0});
    p.triangle({-128, -512, -200}, {128, -512, -200}, {0, 600, -200});
    const Scene scene(p);
    const Linked linked(scene.setting(), scene.shown());
    const Bordered bordered(scene.setting(), linked.links);
    std::vector<std::int32_t> numbers(scene.shown().size());
    AppelCounts counts;
    EXPECT_FALSE(appel(scene.setting(), scene.shown(), nullptr, bordered.borders, {}, {}, numbers,
                       counts));
    ASSERT_GT(counts.longest, 0u);
    std::vector<CounterChange> room(counts.longest);
    EXPECT_TRUE(appel(scene.setting(), scene.shown(), nullptr, bordered.borders, {}, room, numbers,
                      counts));
    std::vector<std::uint8_t> mask(numbers.size());
    mask_of_counts(scene.setting(), scene.shown(), numbers, mask);
    EXPECT_EQ(mask, scene.brute_mask());
}

}  // namespace
}  // namespace umbra78::shadow::rivals::test
