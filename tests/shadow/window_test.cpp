// Windows of taps: where they lie, what they read, percentage closer filtering and its wrong form.
#include "shadow/window.hpp"

#include "hw/memory/dram_map.hpp"
#include "shadow/compare.hpp"
#include "shadow/post_process.hpp"
#include "tests/shadow/random_frames.hpp"
#include "tests/shadow/slow_lookup.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <set>
#include <vector>

namespace umbra78::shadow {
namespace {

using hw::DivideStatus;
using test::Random;

constexpr int one = 128;  // a texel, in the words of X and Y

hw::MachineSpec small_machine() {
    hw::MachineSpec spec;
    spec.xy_bits = 4;
    return spec;
}

// A 16 x 16 map; positions are in 1/128 texel from its left and top edge.
class WindowTable : public ::testing::Test {
protected:
    WindowTable() : light(4) { test.machine = small_machine(); }

    void set(int x, int y, int code) {
        light.depth[static_cast<std::size_t>(16 * y + x)] = static_cast<std::uint16_t>(code);
    }
    void fill(int code) {
        std::fill(light.depth.begin(), light.depth.end(), static_cast<std::uint16_t>(code));
    }
    int dark(Lookup lookup, int side, int x, int y, int code) {
        test.lookup = lookup;
        test.taps = side;
        return darkness(light_map<hw::Depth16>(light.store, test),
                        hw::Point{x - 8 * one, y - 8 * one, code - 32768, DivideStatus::ok},
                        {0, 0});
    }

    ShadowTest test;
    test::OwnedStore<hw::Depth16> light;
};

// Reeves, Salesin and Cook (1987) explain their filter by nine depths, a surface at 49.8, a mean of
// 22.9 and the fraction .55. Here in tenths. The nine are quoted from memory, and no source at hand
// confirms them one by one; they have that mean and that fraction.
constexpr std::array<int, 9> nine_depths{502, 500, 500, 501, 12, 11, 13, 14, 12};
constexpr int surface_depth = 498;

TEST_F(WindowTable, TheTextbooksExampleBothWays) {
    fill(65535);
    int sum = 0, closer = 0;
    for (int t = 0; t < 9; ++t) {
        const int z = nine_depths[static_cast<std::size_t>(t)];
        set(6 + t % 3, 4 + t / 3, z);
        sum += z;
        closer += z < surface_depth;
    }
    EXPECT_EQ(sum, 2065) << "a mean of 22.9";
    EXPECT_EQ(closer, 5);
    // Wherever the point lies in the middle texel, the window is the nine.
    for (const int off : {0, 1, one / 2, one - 1}) {
        const int x = 7 * one + off, y = 5 * one + off;
        EXPECT_EQ(dark(Lookup::percentage, 3, x, y, surface_depth), 142) << "5 / 9 of 255";
        EXPECT_EQ(dark(Lookup::filtered_depth, 3, x, y, surface_depth), 255) << "49.8 > 22.9";
        EXPECT_EQ(dark(Lookup::nearest, 3, x, y, surface_depth), 255) << "the middle is 1.2";
    }
    // A surface at 23.0 is farther than the mean, too, and one at 22.9 nearer: a depth that no
    // surface has decides it. Compared one by one, both are behind five of nine.
    for (const auto& [depth, filtered] : {std::pair{300, 255}, {230, 255}, {229, 0}, {200, 0}}) {
        EXPECT_EQ(dark(Lookup::percentage, 3, 7 * one, 5 * one, depth), 142) << depth;
        EXPECT_EQ(dark(Lookup::filtered_depth, 3, 7 * one, 5 * one, depth), filtered) << depth;
    }
}

// The same nine, through the post-process to the mask: a map and an observer that see alike.
TEST_F(WindowTable, TheTextbooksExampleInTheMask) {
    test::OwnedStore<hw::Depth16> observer(4);
    observer.store.clear(test.machine);
    fill(65535);
    for (int t = 0; t < 9; ++t)
        set(6 + t % 3, 4 + t / 3, nine_depths[static_cast<std::size_t>(t)]);
    observer.depth[16 * 5 + 7] = surface_depth;
    hw::MatrixWords same;
    same.word = {{{1 << 14, 0, 0, 0}, {0, 1 << 14, 0, 0}, {0, 0, 1 << 14, 0}, {0, 0, 0, 1 << 14}}};
    same.exponent = {-5, -5, 0, 0};  // whatever they are, the pixel's centre is to come out again
    const hw::TransformUnit unit(test.machine, same);
    std::vector<std::uint8_t> mask(256);
    for (const auto& [lookup, expected] :
         {std::pair{Lookup::percentage, 142}, {Lookup::filtered_depth, 255}}) {
        test.lookup = lookup;
        for (int e = -8; e <= 8; ++e) {  // the exponent that leaves X and Y as they are
            same.exponent = {e, e, e, e};
            const hw::Point p =
                hw::TransformUnit(test.machine, same)(pixel_words(7, 5, surface_depth, test));
            if (p.x != -one / 2 || p.z != surface_depth - 32768) continue;
            const PostProcessCounts counts =
                post_process(test::maps_of(observer, light), same, test, mask);
            EXPECT_EQ(counts.visible, 1u);
            EXPECT_EQ(counts.shadowed, 1u);
            EXPECT_EQ(mask[16 * 5 + 7], expected);
            mask[16 * 5 + 7] = 0;
            EXPECT_EQ(mask, std::vector<std::uint8_t>(256)) << "nothing else";
            mask[16 * 5 + 7] = 1;
        }
        EXPECT_EQ(mask[16 * 5 + 7], 1) << "no exponent was found";
    }
}

// First texel of a grid of k taps, by hand: odd k about the point's texel, even k about the corner
// that is nearest to the point.
TEST(Window, PlacesOfAGridByHand) {
    const hw::MachineSpec m = small_machine();
    struct Row {
        int x;  // from the map's left edge
        std::array<int, 5> first;  // for k = 1 .. 5
    };
    const Row rows[] = {{8 * one, {8, 7, 7, 6, 6}},
                        {8 * one + one / 2 - 1, {8, 7, 7, 6, 6}},
                        {8 * one + one / 2, {8, 8, 7, 7, 6}},
                        {9 * one - 1, {8, 8, 7, 7, 6}},
                        {9 * one, {9, 8, 8, 7, 7}},
                        {0, {0, -1, -1, -2, -2}},
                        {16 * one - 1, {15, 15, 14, 14, 13}}};
    for (const Row& row : rows)
        for (int k = 1; k <= 5; ++k)
            EXPECT_EQ(first_texel(m, {k, false}, row.x - 8 * one),
                      row.first[static_cast<std::size_t>(k - 1)])
                << "x " << row.x << " k " << k;
}

// One and two taps a side are nearest and bilinear lookup's texels, at every place.
TEST(Window, OfOneAndTwoTapsAreTheOtherLookups) {
    for (int f = 0; f <= 4; ++f) {
        hw::MachineSpec m = small_machine();
        m.fraction_bits = f;
        for (std::int64_t x = -(8 << f); x < 8 << f; ++x) {
            EXPECT_EQ(first_texel(m, {1, false}, x), texel_place(m, false, x, 0).x);
            if (f > 0) {
                EXPECT_EQ(first_texel(m, {2, false}, x), texel_place(m, true, x, 0).x);
            }
        }
    }
}

// Every place of small maps, around their edges, too, for each k and both places of the taps.
TEST(Window, EveryPlaceAgainstTheSlowModel) {
    Random random;
    std::set<int> levels;
    for (int side = 2; side <= 5; ++side)
        for (int f = 0; f <= 2; ++f)
            for (const TapPlaces places : {TapPlaces::grid, TapPlaces::jittered}) {
                ShadowTest t;
                t.machine = small_machine();
                t.machine.fraction_bits = f;
                t.taps = side;
                t.tap_places = places;
                test::OwnedStore<hw::Depth16> light(4);
                test::fill_depth(random, t.machine, light.depth);
                hw::TapNoise noise(77, side * side, t.machine, 0, 0);
                for (const Lookup lookup : {Lookup::percentage, Lookup::filtered_depth}) {
                    t.lookup = lookup;
                    const auto map = light_map<hw::Depth16>(light.store, t);
                    for (int y = -(9 << f); y <= 9 << f; ++y)
                        for (int x = -(9 << f); x <= 9 << f; ++x) {
                            const hw::Point p{x, y, random.between(-32770, 32770),
                                              DivideStatus::ok};
                            const hw::TapBytes bytes = noise.next();
                            const int expected = test::slow_darkness(map, p, {0, 0}, bytes);
                            ASSERT_EQ(darkness(map, p, {0, 0}, bytes), expected)
                                << side << " taps at " << x << " " << y << " of " << f << " bits";
                            levels.insert(expected);
                        }
                }
            }
    EXPECT_GT(levels.size(), 30u);
}

// A map that darkens everywhere: beside its edge the taps beyond it are lit.
TEST_F(WindowTable, TapsBeyondTheMapAreLit) {
    fill(0);
    for (int side = 2; side <= 5; ++side) {
        EXPECT_EQ(dark(Lookup::percentage, side, 8 * one, 8 * one, 1), 255) << side;
        // In the map's corner, of k taps those to the right of and below texel 0 are on the map.
        const int on = (side + 1) / 2, corner = on * on;
        const int expected = (2 * 255 * corner + side * side) / (2 * side * side);
        EXPECT_EQ(dark(Lookup::percentage, side, 0, 0, 1), expected) << side;
        // The mean holds the background's 65535 for each of the others.
        const int code = 65535 * (side * side - corner) / (side * side);
        EXPECT_EQ(dark(Lookup::filtered_depth, side, 0, 0, code), 0) << side;
        EXPECT_EQ(dark(Lookup::filtered_depth, side, 0, 0, code + 1), 255) << side;
        EXPECT_EQ(dark(Lookup::percentage, side, -1, 0, 1), 0) << "the point is outside";
        EXPECT_EQ(dark(Lookup::percentage, side, 16 * one, 0, 1), 0) << "the point is outside";
    }
    fill(65535);
    for (const int code : {0, 1, 65534})
        for (const Lookup lookup : {Lookup::percentage, Lookup::filtered_depth})
            EXPECT_EQ(dark(lookup, 3, 8 * one, 8 * one, code), 0) << "background darkens nothing";
}

// A plane that falls by 40 quanta a texel in x and 24 in y, seen at every eighth of a texel. Its
// own taps lie up to k/2 texels before a point, so that it needs a bias of k (40 + 24) / 2, less
// what an eighth falls; the mean of a window needs what one texel does.
TEST_F(WindowTable, APlaneNeedsABiasThatGrowsWithTheWindow) {
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x) set(x, y, 1000 + 40 * x + 24 * y);
    const auto darkest = [&](Lookup lookup, int side, int bias) {
        int most = 0;
        for (int y = 5 * one; y < 11 * one; y += one / 8)
            for (int x = 5 * one; x < 11 * one; x += one / 8) {
                const int depth = 1000 + 40 * (x - one / 2) / one + 24 * (y - one / 2) / one;
                most = std::max(most, dark(lookup, side, x, y, depth - bias));
            }
        return most;
    };
    for (int side = 2; side <= 5; ++side) {
        const int needed = 32 * side - 8;
        EXPECT_EQ(darkest(Lookup::percentage, side, needed), 0) << side;
        EXPECT_EQ(darkest(Lookup::percentage, side, needed - 1), share_of_dark(1, {side, false}))
            << side << ": the farthest tap alone";
        EXPECT_EQ(darkest(Lookup::filtered_depth, side, 24), 0) << side;
        EXPECT_EQ(darkest(Lookup::filtered_depth, side, 23), 255) << side;
    }
    EXPECT_EQ(darkest(Lookup::nearest, 1, 24), 0);
    EXPECT_EQ(darkest(Lookup::nearest, 1, 23), 255);
}

// half_up(255 count / taps), all of them: both ends, and no step back.
TEST(Window, ShareOfDark) {
    for (int side = 2; side <= 5; ++side) {
        const Window w{side, false};
        EXPECT_EQ(share_of_dark(0, w), 0);
        EXPECT_EQ(share_of_dark(w.taps(), w), 255);
        for (int count = 1; count <= w.taps(); ++count) {
            const int level = share_of_dark(count, w);
            EXPECT_GT(level, share_of_dark(count - 1, w));
            EXPECT_LE(std::abs(2 * (level * w.taps() - 255 * count)), w.taps());
        }
    }
    EXPECT_EQ(share_of_dark(1, {2, false}), 64) << "63.75";
    EXPECT_EQ(share_of_dark(2, {2, false}), 128) << "127.5: a tie goes up";
    EXPECT_EQ(share_of_dark(1, {5, false}), 10) << "10.2";
}

// --- fetching -----------------------------------------------------------------------------------

// Every tap is fetched once, in no cycle beyond the last, and four banks are asked for one texel
// each at most, wherever the window lies.
TEST(Window, FetchesEachTapOnceFromABankOfItsOwn) {
    for (int side = 1; side <= 5; ++side)
        for (const bool jittered : {false, true})
            for (const int banks : {1, 4}) {
                const Window w{side, jittered};
                const int cycles = fetch_cycles(w, banks);
                const int half = (side + 1) / 2;
                EXPECT_EQ(cycles, banks == 4 && !jittered ? half * half : side * side);
                std::vector<std::set<int>> asked(static_cast<std::size_t>(cycles));
                for (int t = 0; t < w.taps(); ++t) {
                    const int c = fetch_cycle(w, banks, t);
                    ASSERT_TRUE(c >= 0 && c < cycles);
                    const int bank =
                        banks == 1 ? 0 : hw::DramMap{4, 4}.place(5 + t % side, 2 + t / side).bank;
                    EXPECT_TRUE(asked[static_cast<std::size_t>(c)].insert(bank).second)
                        << side << " taps, " << banks << " banks, cycle " << c;
                }
                for (const auto& banks_asked : asked) EXPECT_FALSE(banks_asked.empty());
            }
}

TEST(WindowDeathTest, WhatHasNoAnswerTraps) {
    test::OwnedStore<hw::Depth16> light(4);
    ShadowTest t;
    t.machine = small_machine();
    t.lookup = Lookup::percentage;
    const auto map = light_map<hw::Depth16>(light.store, t);
    EXPECT_DEATH(in_shadow(map, {0, 0, 0, DivideStatus::ok}, {0, 0}), "");
    for (const int taps : {-1, 0, 1, 6}) {
        t.taps = taps;
        EXPECT_DEATH(light_map<hw::Depth16>(light.store, t), "") << taps;
    }
}

}  // namespace
}  // namespace umbra78::shadow
