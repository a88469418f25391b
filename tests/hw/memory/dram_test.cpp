// The memory's times against closed forms where there are any, else against a model that counts
// single nanoseconds.
#include "hw/memory/dram.hpp"

#include "tests/fixed/boundary.hpp"
#include "tests/hw/memory/slow_dram.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <span>
#include <string>
#include <vector>

namespace umbra78::hw {
namespace {

using fixed::test::Random;

// Refresh is never switched off; where a test is not about it, it ends before the first one.
constexpr std::uint64_t first_refresh_ns = 15625;

struct Store {
    explicit Store(const DramTiming& timing = {}, bool shown = false, int banks = 1)
        : map{9, banks, timing.rows}, dram(timing, map, shown) {}
    std::uint64_t read(int x, int y) {
        const DramPlace p = map.place(x, y);
        return now = dram.access({&p, 1}, now);
    }
    DramMap map;
    Dram dram;
    std::uint64_t now = 0;
};

TEST(Dram, OneRowIsOneMissAndThenPageHits) {
    Store s;
    for (int k = 0; k < 30; ++k) s.read(16 * k, 0);
    EXPECT_EQ(s.now, 200u + 29 * 225);
    EXPECT_EQ(s.dram.counts().page_hits, 29u);
    EXPECT_EQ(s.dram.counts().row_misses, 1u);
    EXPECT_EQ(s.dram.counts().row_changes, 0u);
    EXPECT_EQ(s.dram.counts().busy_ns, 200u + 29 * 135);
    EXPECT_EQ(s.dram.counts().bank_wait_ns, 29u * 90) << "from column to column";
    s.now += 90;
    const std::uint64_t before = s.now;
    EXPECT_EQ(s.read(0, 0), before + 135) << "at rest, the open row answers at once";
}

TEST(Dram, PingPongRowsPayAWholeCycleEach) {
    Store s;
    for (int k = 0; k < 30; ++k) s.read(0, k % 2 * 4);
    EXPECT_EQ(s.now, 200u + 29 * 375);
    EXPECT_EQ(s.dram.counts().row_misses, 30u);
    EXPECT_EQ(s.dram.counts().row_changes, 29u);
}

TEST(Dram, WithoutPageModeEveryAccessIsACycle) {
    DramTiming t;
    t.page_ns = 0;
    Store s(t);
    for (int k = 0; k < 30; ++k) s.read(16 * k, 0);
    EXPECT_EQ(s.now, 29u * 375 + 200);
    EXPECT_EQ(s.dram.counts().row_misses, 30u);
    EXPECT_EQ(s.dram.counts().bank_waits, 29u);
    EXPECT_EQ(s.dram.counts().bank_wait_ns, 29u * 175);
    EXPECT_EQ(s.dram.counts().busy_ns, 30u * 200);
}

// A row may stay open for 10 us: 200 ns and 43 page cycles of 225 are 9.875.
TEST(Dram, ARowIsNotLeftOpenForTooLong) {
    Store s;
    for (int k = 0; k < 60; ++k) s.read(0, 0);
    EXPECT_EQ(s.dram.counts().row_misses, 2u);
    EXPECT_EQ(s.dram.counts().row_changes, 1u);
    EXPECT_EQ(s.now, 200u + 43 * 225 + 375 + 15 * 225);
    EXPECT_LT(s.now, first_refresh_ns);
}

TEST(Dram, TenMicrosecondsAreStillInTime) {
    for (const std::uint64_t late : {0u, 1u}) {
        Store s;
        s.read(0, 0);
        s.now = 10'000 - 135 + late;
        s.read(0, 0);
        EXPECT_EQ(s.dram.counts().page_hits, 1 - late);
        EXPECT_EQ(s.now, 10'000 + (late == 0 ? 0 : 1 - 135 + 375));
    }
}

// 128 refresh cycles in any 2 ms, read or not; each closes the row.
TEST(Dram, RefreshIs128CyclesEachTwoMilliseconds) {
    for (const bool busy : {false, true}) {
        Store s;
        std::uint64_t until_2ms = 0;
        for (std::uint64_t ms = 1; ms <= 8; ++ms) {
            while (busy && s.now < ms * 1'000'000) s.read(0, 0);
            s.now = std::max(s.now, ms * 1'000'000);
            s.read(0, 0);
            if (ms == 2) until_2ms = s.dram.counts().refresh_cycles;
        }
        EXPECT_EQ(until_2ms, 128u);
        EXPECT_EQ(s.dram.counts().refresh_cycles, 4 * 128u);
        EXPECT_EQ(s.dram.counts().video_cycles, 0u);
    }
}

TEST(Dram, ARefreshWaitsForWhatHasBegunAndThenGoesFirst) {
    Store s;
    s.now = first_refresh_ns - 100;
    s.read(0, 0);  // until 15725, over the refresh's time
    EXPECT_EQ(s.now, first_refresh_ns + 100);
    EXPECT_EQ(s.dram.counts().refresh_waits, 0u);
    s.read(0, 0);  // after it: the row closed, a cycle, and the row opened again
    EXPECT_EQ(s.now, first_refresh_ns + 100 + 175 + 375 + 200);
    EXPECT_EQ(s.dram.counts().refresh_wait_ns, 175u + 375);
    EXPECT_EQ(s.dram.counts().refresh_waits, 1u);
    EXPECT_EQ(s.dram.counts().row_misses, 2u);
    EXPECT_EQ(s.dram.counts().row_changes, 0u) << "the refresh had closed it";
}

TEST(Dram, AtATieTheVideoGoesFirstThenTheRefreshThenTheRequest) {
    Store s({}, true);
    s.read(0, 0);  // word 0 of the first line is due at 0 too
    EXPECT_EQ(s.now, 375u + 200);
    EXPECT_EQ(s.dram.counts().video_wait_ns, 375u);
    // 78125 ns: the fifth refresh, and word 9 of the second line.
    ASSERT_EQ(video_due_ns({}, 32 + 9), 5 * first_refresh_ns);
    Store both({}, true);
    both.now = 5 * first_refresh_ns;
    both.read(0, 0);
    EXPECT_EQ(both.now, 5 * first_refresh_ns + 375 + 375 + 200);
    EXPECT_EQ(both.dram.counts().video_wait_ns, 375u);
    EXPECT_EQ(both.dram.counts().refresh_wait_ns, 375u);
}

// 16 pixels of a 512-pixel line are shown in 1.625 us: a quarter of the visible line's time goes
// to the video, by the cycle of the chips' grade.
TEST(Dram, VideoTakesAQuarterOfTheCycles) {
    EXPECT_EQ(video_due_ns({}, 1), 1625u);
    EXPECT_EQ(video_due_ns({}, 31), 50375u);
    EXPECT_EQ(video_due_ns({}, 32), 63500u) << "the next line";
    for (const auto& [cycle, per_mille] :
         {std::pair{320, 197u}, {375, 231u}, {410, 252u}, {480, 295u}}) {
        DramTiming t;
        t.cycle_ns = cycle;
        t.page_ns = 0;
        Store s(t, true);
        s.now = 51'999;
        s.read(0, 0);
        const std::uint64_t cycles = s.dram.counts().video_cycles;
        EXPECT_EQ(cycles, 32u);
        const std::uint64_t taken = cycles * static_cast<std::uint64_t>(cycle);
        EXPECT_EQ(1000 * taken / 52'000 + (1000 * taken % 52'000 >= 26'000), per_mille) << cycle;
        std::printf("cycle %d ns: video takes %.1f %% of a visible line, %.1f %% of a line\n",
                    cycle, static_cast<double>(taken) / 520, static_cast<double>(taken) / 635);
    }
}

TEST(Dram, VideoRefreshesWhereItVisitsEveryRow) {
    for (const DramRows rows : {DramRows::lines, DramRows::words}) {
        DramTiming t;
        t.rows = rows;
        Store s(t, true);
        s.now = 2'000'000;
        s.read(0, 0);
        EXPECT_EQ(s.dram.counts().refresh_cycles, rows == DramRows::lines ? 128u : 0u);
        EXPECT_EQ(s.dram.counts().video_cycles, 31u * 32 + 20) << "31.5 lines";
    }
}

// A scan of the whole frame by words: a miss at each page, and one after each refresh.
TEST(Dram, ASequentialScanMissesOncePerPageAndOncePerStolenCycle) {
    Store s;
    for (int y = 0; y < 512; ++y)
        for (int x = 0; x < 512; x += 16) s.read(x, y);
    const DramCounts& c = s.dram.counts();
    EXPECT_EQ(c.accesses, 512u * 32);
    // Only its time closes a row: at most 43 hits after every miss.
    EXPECT_GE(c.row_misses, 128 + 512u * 32 / 44 - 128);
    EXPECT_LE(c.row_misses, 128 + c.refresh_cycles + 512u * 32 / 44);
    EXPECT_EQ(c.busy_ns, 135 * c.page_hits + 200 * c.row_misses + 175 * c.row_changes);
    EXPECT_EQ(s.now, c.latency_ns());

    DramTiming words;
    words.rows = DramRows::words;
    Store other(words);
    for (int y = 0; y < 512; ++y)
        for (int x = 0; x < 512; x += 16) other.read(x, y);
    EXPECT_EQ(other.dram.counts().page_hits, 0u) << "every word lies in another row";
}

TEST(Dram, FourBanksStartTogetherAndKeepARowEach) {
    Store s({}, false, 4);
    const auto quad = [&](int x, int y) {
        std::array<DramPlace, 4> p;
        for (std::size_t k = 0; k < 4; ++k)
            p[k] = s.map.place(x + static_cast<int>(k % 2), y + static_cast<int>(k / 2));
        return s.now = s.dram.access(p, s.now);
    };
    quad(0, 2);
    EXPECT_EQ(s.now, 200u);
    quad(301, 2);
    EXPECT_EQ(s.now, 200u + 225);
    quad(301, 3);  // lines 3 and 4: two banks stay in their row, two change, the four as one
    EXPECT_EQ(s.now, 200u + 225 + 90 + 375);
    EXPECT_EQ(s.dram.counts().requests, 3u);
    EXPECT_EQ(s.dram.counts().accesses, 12u);
    EXPECT_EQ(s.dram.counts().page_hits, 6u);
    EXPECT_EQ(s.dram.counts().row_changes, 2u);
    EXPECT_EQ(s.dram.counts().busy_ns, 200u + 135 + 375);
    EXPECT_EQ(s.dram.counts().bank_wait_ns, 2u * 90);
}

void expect_equal(const DramCounts& a, const DramCounts& b, const std::string& where) {
    const auto list = [](const DramCounts& c) {
        return std::array{c.requests,        c.accesses,      c.page_hits,    c.row_misses,
                          c.row_changes,     c.refresh_cycles, c.video_cycles, c.refresh_waits,
                          c.video_waits,     c.bank_waits,    c.refresh_wait_ns,
                          c.video_wait_ns,   c.bank_wait_ns,  c.busy_ns};
    };
    EXPECT_EQ(list(a), list(b)) << where;
}

// Random machines and streams: runs, jumps, pauses and requests at the moments of stolen cycles.
TEST(Dram, IsTheModelOfSingleNanoseconds) {
    Random random;
    DramCounts sum;
    for (int round = 0; round < 120; ++round) {
        const auto between = [&](int low, int high) {
            return static_cast<int>(random.between(low, high));
        };
        DramTiming t;
        if (round % 3 != 0) {
            t.access_ns = between(1, 1000);
            t.cycle_ns = between(1, 1000);
            t.column_ns = between(1, 500);
            t.page_ns = between(0, 3) == 0 ? 0 : between(1, 600);
        }
        t.rows = static_cast<DramRows>(between(0, 1));
        const bool shown = between(0, 1) != 0;
        const DramMap map{between(4, 9), between(0, 1) != 0 ? 4 : 1, t.rows};
        Dram dram(t, map, shown);
        test::SlowDram slow(t, map, shown);
        const int size = 1 << map.xy_bits;
        int x = 0, y = 0;
        std::uint64_t now = 0;
        while (now < 300'000) {
            x = (x + between(0, 2)) % (size - 1);
            if (between(0, 7) == 0) y = between(0, size - 2);
            const int pause = between(0, 19);
            if (pause < 6) now += static_cast<std::uint64_t>(between(0, 900));
            if (pause == 6) now = std::max(now, now / 15625 * 15625 + 15625);
            if (pause == 7) now += static_cast<std::uint64_t>(between(0, 15000));
            std::vector<DramPlace> places;
            for (int k = 0; k < (map.banks == 4 && between(0, 3) != 0 ? 4 : 1); ++k)
                places.push_back(map.place(x + k % 2, y + k / 2));
            const std::uint64_t done = dram.access(places, now);
            ASSERT_EQ(done, slow.access(places, now)) << "round " << round << " at " << now;
            now = done;
        }
        expect_equal(dram.counts(), slow.counts, "round " + std::to_string(round));
        if (HasFailure()) return;
        sum.page_hits += dram.counts().page_hits;
        sum.row_changes += dram.counts().row_changes;
        sum.video_waits += dram.counts().video_waits;
        sum.refresh_waits += dram.counts().refresh_waits;
        sum.bank_waits += dram.counts().bank_waits;
    }
    EXPECT_GT(sum.page_hits, 5000u);
    EXPECT_GT(sum.row_changes, 1000u);
    EXPECT_GT(sum.video_waits, 500u);
    EXPECT_GT(sum.refresh_waits, 100u);
    EXPECT_GT(sum.bank_waits, 500u);
}

}  // namespace
}  // namespace umbra78::hw
