// Where pixels lie in the chips: every place once, pages and refresh as the closed forms say.
#include "hw/memory/dram_map.hpp"

#include "hw/memory/dram.hpp"

#include <gtest/gtest.h>

#include <set>
#include <tuple>
#include <vector>

namespace umbra78::hw {
namespace {

constexpr DramRows both_rows[] = {DramRows::lines, DramRows::words};

TEST(DramMap, EveryPixelHasAPlaceOfItsOwnInTheChips) {
    for (int bits = 4; bits <= 10; ++bits)
        for (const int banks : {1, 4})
            for (const DramRows rows : both_rows) {
                const DramMap map{bits, banks, rows};
                const int chips = map.word_px() / banks;
                std::vector<bool> seen(std::size_t{1} << (14 + map.word_bits()));
                for (int y = 0; y < 1 << bits; ++y)
                    for (int x = 0; x < 1 << bits; ++x) {
                        const DramPlace p = map.place(x, y);
                        ASSERT_TRUE(p.bank >= 0 && p.bank < banks && p.chip >= 0 &&
                                    p.chip < chips && p.row >= 0 && p.row < 128 &&
                                    p.column >= 0 && p.column < 128);
                        const int at = ((p.row * 128 + p.column) * banks + p.bank) * chips + p.chip;
                        ASSERT_FALSE(seen[static_cast<std::size_t>(at)]) << x << ' ' << y;
                        seen[static_cast<std::size_t>(at)] = true;
                    }
            }
}

TEST(DramMap, FrameOf1978FillsSixteenChipsABitPlane) {
    const DramMap map;
    EXPECT_EQ(map.word_px(), 16);
    EXPECT_EQ(1 << (2 * map.xy_bits), 16 * 128 * 128);
    EXPECT_EQ(video_words_a_line(map), 32u);
    for (const int bits : {10, 11, 12})  // more chips, as many rows
        EXPECT_EQ((DramMap{bits, 1, DramRows::lines}.word_px()), 1 << (2 * bits - 14));
}

TEST(DramMap, SixteenPixelsOfALineAreAWord) {
    for (const DramRows rows : both_rows) {
        const DramMap map{9, 1, rows};
        for (int x = 0; x < 512; ++x) {
            const DramPlace p = map.place(x, 77), first = map.place(x & ~15, 77);
            EXPECT_EQ(p.chip, x % 16);
            EXPECT_EQ(std::tie(p.row, p.column), std::tie(first.row, first.column));
        }
    }
}

TEST(DramMap, APageIsFourLinesOrAWordOfEachFour) {
    const DramMap lines{9, 1, DramRows::lines}, words{9, 1, DramRows::words};
    for (int y = 0; y < 512; ++y)
        for (int x = 0; x < 512; ++x) {
            ASSERT_EQ(lines.place(x, y).row, y / 4);
            ASSERT_EQ(words.place(x, y).row, y % 4 * 32 + x / 16);
        }
}

TEST(DramMap, AnyTwoByTwoTexelsLieInFourBanks) {
    for (const DramRows rows : both_rows) {
        const DramMap map{9, 4, rows};
        for (int y = 0; y < 511; y += 3)
            for (int x = 0; x < 511; ++x) {
                std::set<int> banks;
                for (int k = 0; k < 4; ++k) banks.insert(map.place(x + k % 2, y + k / 2).bank);
                ASSERT_EQ(banks.size(), 4u) << x << ' ' << y;
            }
    }
    // A bank has 4 chips a plane: half a line of it is 64 words, a page two such: four lines.
    for (int y = 0; y < 512; ++y)
        EXPECT_EQ((DramMap{9, 4, DramRows::lines}.place(300, y).row), y / 4);
}

// Reading out four lines of 512 pixels visits all 128 rows, in an eighth of the refresh period.
TEST(DramMap, VideoVisitsEveryRowWhereRowsAreWords) {
    const DramMap words{9, 1, DramRows::words};
    for (const int first : {0, 5, 500}) {
        std::set<int> rows;
        for (int y = first; y < first + 4; ++y)
            for (int x = 0; x < 512; ++x) rows.insert(words.place(x, y).row);
        EXPECT_EQ(rows.size(), 128u);
    }
    EXPECT_TRUE(video_refreshes(words));
    EXPECT_FALSE(video_refreshes({9, 1, DramRows::lines})) << "512 lines would take 33 ms";
    EXPECT_FALSE(video_refreshes({5, 1, DramRows::words})) << "two words a line: 64 lines, 4 ms";
}

}  // namespace
}  // namespace umbra78::hw
