// Crow's sides in the order of depth: brute force's mask and volumes' numbers, whatever the order
// does; and what the order takes.
#include "shadow/rivals/ordered_volumes.hpp"
#include "tests/shadow/rivals/figures_scene.hpp"
#include "tests/shadow/rivals/named_scenes.hpp"

#include <gtest/gtest.h>

namespace umbra78::shadow::rivals::test {
namespace {

std::vector<ContourEdge> contour_of(const Setting& s) {
    std::vector<ContourEdge> contour(find_contour(s, {}));
    find_contour(s, contour);
    return contour;
}

std::vector<std::int32_t> summed_numbers(const Setting& s, std::span<const std::uint32_t> shown) {
    std::vector<std::int32_t> numbers(shown.size());
    VolumeCounts counts;
    count_volumes(s, shown, contour_of(s), numbers, counts);
    return numbers;
}

std::vector<std::int32_t> ordered_numbers(const Setting& s, std::span<const std::uint32_t> shown,
                                          OrderedCounts& counts) {
    const std::vector<ContourEdge> contour = contour_of(s);
    std::vector<std::int32_t> numbers(shown.size(), 77);
    Memory none(0);
    order_volumes(s, shown, contour, none.bytes().first(0), numbers, counts);
    Memory memory(counts.bytes);
    counts = {};
    fixed::require(order_volumes(s, shown, contour, memory.bytes(), numbers, counts),
                   "a test's room for sides");
    return numbers;
}

void expect_right(const Setting& s, std::span<const std::uint32_t> shown,
                  std::span<const std::uint8_t> right, OrderedCounts& counts) {
    const auto numbers = ordered_numbers(s, shown, counts);
    ASSERT_EQ(numbers, summed_numbers(s, shown));
    std::vector<std::uint8_t> mask(numbers.size());
    mask_of_counts(s, shown, numbers, mask);
    ASSERT_TRUE(std::ranges::equal(mask, right));
}

TEST(OrderedVolumes, EqualBruteForceInRandomScenes) {
    OrderedCounts all;
    std::uint64_t inside = 0, longest = 0;
    for (std::uint32_t seed = 0; seed < random_scenes; ++seed) {
        const Scene scene(random_polygons(seed));
        OrderedCounts c;
        expect_right(scene.setting(), scene.shown(), scene.brute_mask(), c);
        if (HasFatalFailure()) FAIL() << "seed " << seed;
        all.swaps += c.swaps;
        all.compares += c.compares;
        all.changes += c.changes;
        all.inserts += c.inserts;
        longest = std::max(longest, c.longest);
        inside += c.start_tests > c.facets ? 1 : 0;  // an eye on a volume's border
    }
    EXPECT_GT(all.swaps, enough(1'000));
    EXPECT_GT(all.compares, enough(10'000));
    EXPECT_GT(all.changes, enough(10'000));
    EXPECT_GT(inside, enough(100));
    EXPECT_GT(longest, 8u);
    std::printf("swaps %lu compares %lu changes %lu inserts %lu longest %lu inside %lu\n", all.swaps, all.compares, all.changes, all.inserts, longest, inside);
}

TEST(OrderedVolumes, EqualBruteForceInTheNamedScenes) {
    for (const Polygons& p : named_scenes()) {
        const Scene scene(p);
        OrderedCounts c;
        expect_right(scene.setting(), scene.shown(), scene.brute_mask(), c);
        if (HasFatalFailure()) FAIL() << p.name;
    std::printf("%s swaps %lu compares %lu changes %lu open %lu asked %lu\n", p.name.c_str(), c.swaps, c.compares, c.changes, c.open_at_changes, c.asked_at_changes);
    }
}

TEST(OrderedVolumes, EqualBruteForceInTheFiguresScene) {
    for (const int levels : {1, 2, 3, 4}) {
        const FiguresScene scene(levels);
        OrderedCounts c;
        expect_right(scene.setting(), scene.shown(), scene.brute_mask(), c);
    std::printf("%d sides %lu swaps %lu compares %lu inserts %lu rows %lu lines %lu asked %lu crossings %lu stretches %lu changes %lu open %lu asked %lu longest %lu\n", levels, c.sides, c.swaps, c.compares, c.inserts, c.rows, c.lines, c.asked, c.crossings, c.stretches, c.changes, c.open_at_changes, c.asked_at_changes, c.longest);
    }
}

}  // namespace
}  // namespace umbra78::shadow::rivals::test
