// Bouknight & Kelley's second scan, in both forms, equals brute force.
#include "tests/shadow/rivals/named_scenes.hpp"
#include "tests/shadow/rivals/scan_out.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace umbra78::shadow::rivals::test {
namespace {

struct SecondScanForm {
    const char* name;
    bool borders, stop;
};
constexpr std::array<SecondScanForm, 3> second_scan_forms{
    {{"every edge", false, false}, {"stopped when dark", false, true}, {"borders", true, true}}};

std::vector<std::uint8_t> second_scan(const Setting& s, std::span<const std::uint32_t> shown,
                                      const Linked& linked, const Bordered& bordered,
                                      const SecondScanForm& form, ScanOutCounts& counts) {
    std::vector<CounterChange> room(2 * linked.counts.longest + bordered.counts.longest);
    std::vector<std::uint8_t> mask(shown.size(), 77);
    fixed::require(bouknight_kelley(s, shown, linked.links,
                                    form.borders ? &bordered.borders : nullptr, {form.stop}, room,
                                    mask, counts),
                   "a test's room for crossings");
    return mask;
}

TEST(BouknightKelley, EqualsBruteForceInRandomScenes) {
    std::array<ScanOutCounts, 3> counts{};
    BorderCounts borders;
    for (std::uint32_t seed = 0; seed < random_scenes; ++seed) {
        const Scene scene(random_polygons(seed));
        const Linked linked(scene.setting(), scene.shown());
        const Bordered bordered(scene.setting(), linked.links);
        borders.edges += bordered.counts.edges;
        borders.facets += bordered.counts.facets;
        const auto right = scene.brute_mask();
        for (std::size_t i = 0; i < second_scan_forms.size(); ++i)
            ASSERT_EQ(second_scan(scene.setting(), scene.shown(), linked, bordered,
                                  second_scan_forms[i], counts[i]),
                      right)
                << "seed " << seed << ", " << second_scan_forms[i].name;
    }
    // The scenes do ask for all of it.
    EXPECT_GT(counts[0].crossings, enough(3'000));
    EXPECT_GT(counts[0].compares, enough(500));
    EXPECT_GT(counts[1].stopped, enough(3'000));
    EXPECT_GT(counts[2].crossings, enough(1'000));
    EXPECT_GT(borders.edges, enough(10'000));
    EXPECT_GT(borders.facets, enough(5'000));
}

// Of a Scene or a FiguresScene.
template <class Tested>
void expect_equal_in(const Tested& scene, const std::string& name) {
    const Linked linked(scene.setting(), scene.shown());
    const Bordered bordered(scene.setting(), linked.links);
    const auto right = scene.brute_mask();
    for (const SecondScanForm& form : second_scan_forms) {
        ScanOutCounts counts;
        const auto mask =
            second_scan(scene.setting(), scene.shown(), linked, bordered, form, counts);
        EXPECT_TRUE(mask == right) << name << ", " << form.name;
    }
}

TEST(BouknightKelley, EqualsBruteForceInTheFiguresScene) {
    for (int levels = 1; levels <= figures_levels; ++levels)
        expect_equal_in(FiguresScene(levels, 9, -100), "levels " + std::to_string(levels));
    expect_equal_in(FiguresScene(4, 7, -100), "levels 4");
}

TEST(BouknightKelley, EqualsBruteForceInTheNamedScenes) {
    for (const Polygons& p : named_scenes()) expect_equal_in(Scene(p), p.name);
}

TEST(BouknightKelley, EqualsBruteForceWithALightAtAPlace) {
    expect_equal_in(FiguresScene(2, 8, 40, 3), "40 degrees");
    expect_equal_in(FiguresScene(2, 8, -100, 3), "-100 degrees");
}

// A row of the floor under a bar: lit, dark, lit; the counter's two crossings, sorted.
TEST(BouknightKelley, CountsWhatItDoes) {
    Polygons p;
    p.light = {-4, 0, -8, 0};
    p.quad({-512, -512, 0}, {512, -512, 0}, {512, 512, 0}, {-512, 512, 0});
    p.triangle({-128, -512, -200}, {128, -512, -200}, {0, 600, -200});
    const Scene scene(p);
    const Linked linked(scene.setting(), scene.shown());
    const Bordered bordered(scene.setting(), linked.links);
    for (const SecondScanForm& form : second_scan_forms) {
        ScanOutCounts counts;
        const auto mask =
            second_scan(scene.setting(), scene.shown(), linked, bordered, form, counts);
        EXPECT_EQ(mask, scene.brute_mask());
        EXPECT_EQ(counts.runs, counts.lit_runs);
        EXPECT_GE(counts.tones, counts.runs);
        EXPECT_GT(counts.crossings, 0u);
        EXPECT_LE(counts.longest, 2u);
    }
}

TEST(BouknightKelley, SaysHowLongAListWas) {
    const FiguresScene scene(2, 7, -100);
    const Linked linked(scene.setting(), scene.shown());
    std::vector<std::uint8_t> mask(scene.shown().size());
    ScanOutCounts counts;
    EXPECT_FALSE(bouknight_kelley(scene.setting(), scene.shown(), linked.links, nullptr, {false},
                                  {}, mask, counts));
    const std::size_t needed = counts.longest;
    ASSERT_GT(needed, 1u);
    std::vector<CounterChange> room(needed);
    EXPECT_FALSE(bouknight_kelley(scene.setting(), scene.shown(), linked.links, nullptr, {false},
                                  std::span(room).first(needed - 1), mask, counts));
    counts = {};
    EXPECT_TRUE(bouknight_kelley(scene.setting(), scene.shown(), linked.links, nullptr, {false},
                                 room, mask, counts));
    EXPECT_EQ(counts.longest, needed);
    EXPECT_EQ(mask, scene.brute_mask());
}

TEST(BouknightKelley, SortsByColumn) {
    std::mt19937 random(7);
    for (std::size_t size = 0; size < 200; ++size) {
        std::vector<CounterChange> changes(size);
        std::int64_t sum = 0, of_columns = 0;
        for (CounterChange& c : changes) {
            c = {static_cast<int>(random() % 50), static_cast<std::int32_t>(random() % 9)};
            sum += c.change * (c.column + 1);
            of_columns += c.column;
        }
        sort_changes(changes);
        for (const CounterChange& c : changes) {
            sum -= c.change * (c.column + 1);
            of_columns -= c.column;
        }
        EXPECT_EQ(sum, 0);
        EXPECT_EQ(of_columns, 0);
        const auto before = [](const CounterChange& a, const CounterChange& b) {
            return a.column < b.column;
        };
        EXPECT_TRUE(std::is_sorted(changes.begin(), changes.end(), before));
    }
}

}  // namespace
}  // namespace umbra78::shadow::rivals::test
