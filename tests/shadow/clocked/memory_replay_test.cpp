// The memory replay: against a model clock by clock, against closed forms, and its sums.
#include "shadow/clocked/memory_replay.hpp"

#include "tests/shadow/clocked/slow_replay.hpp"
#include "tests/shadow/frame/figure_frame.hpp"
#include "tests/shadow/random_frames.hpp"
#include "tests/shadow/slow_lookup.hpp"
#include "tests/shadow/slow_point.hpp"
#include "tests/support/effort.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace umbra78::shadow {
namespace {

using test::OwnedStore;
using test::Random;

auto list(const hw::DramCounts& c) {
    return std::array{c.requests,        c.accesses,      c.page_hits,      c.row_misses,
                      c.row_changes,     c.refresh_cycles, c.video_cycles,  c.refresh_waits,
                      c.video_waits,     c.bank_waits,    c.refresh_wait_ns, c.video_wait_ns,
                      c.bank_wait_ns,    c.busy_ns};
}

auto list(const PathTime& t) {
    return std::array{t.read_ns, t.unit_ns, t.light_ns, t.write_ns};
}

void expect_sums(const MemoryLedger& l, const Settings& s) {
    EXPECT_EQ(l.path.total_ns(), l.total_ns);
    EXPECT_EQ(l.ideal_path.total_ns(), l.ideal_ns);
    const hw::DramTiming& t = s.timing.dram;
    for (const hw::DramCounts* c : {&l.observer, &l.light, &l.mask}) {
        EXPECT_EQ(c->page_hits + c->row_misses, c->accesses);
        if (c->requests != c->accesses) continue;  // banks overlap
        EXPECT_EQ(c->busy_ns, c->page_hits * static_cast<std::uint64_t>(t.column_ns) +
                                  c->row_misses * static_cast<std::uint64_t>(t.access_ns) +
                                  c->row_changes * static_cast<std::uint64_t>(t.recovery_ns()));
    }
    const auto word_px = static_cast<std::uint64_t>(test::slow_word_px(s.machine.xy_bits));
    EXPECT_EQ(l.observer.requests, l.pixels / word_px);
    EXPECT_EQ(l.mask.requests, l.observer.requests);
    const bool together = s.timing.light_banks == 4 && s.lookup == Lookup::bilinear;
    if (together || s.lookup == Lookup::nearest) {
        EXPECT_EQ(l.light.requests, l.looked_up);
    }
}

Settings random_timing(Random& random, Settings s) {
    const auto between = [&](int low, int high) {
        return static_cast<int>(random.between(low, high));
    };
    s.timing.clock_ns = test::pick(random, {100, 167, 200, 333, 1000});
    s.timing.light_banks = test::pick(random, {1, 4});
    hw::DramTiming& t = s.timing.dram;
    t.rows = test::pick(random, {hw::DramRows::lines, hw::DramRows::words});
    t.video = test::pick(random, {hw::Video::off, hw::Video::observer, hw::Video::all});
    if (random.bits() % 2 == 0) return s;
    t.access_ns = between(1, 600);
    t.cycle_ns = between(1, 1000);
    t.column_ns = between(1, 300);
    t.page_ns = between(0, 3) == 0 ? 0 : between(1, 400);
    return s;
}

TEST(MemoryReplay, IsTheModelOfSingleClocks) {
    Random random;
    std::uint64_t looked_up = 0, hidden = 0, shown = 0;
    for (int round = 0; round < umbra78::test::effort(150); ++round) {
        Settings s = random_timing(random, test::random_settings(random, false));
        s.machine.xy_bits = static_cast<int>(random.between(4, 5));
        const hw::MachineSpec& m = s.machine;
        OwnedStore<hw::Depth32> observer(m.xy_bits);
        test::fill_depth(random, m, observer.depth);
        const hw::MatrixWords matrix = test::random_matrix(random, m, random.bits() % 4 != 0);
        const auto issue = static_cast<std::uint64_t>(random.between(1, 9));

        const test::SlowNoise noise(s.dither, m);
        const test::SlowTapNoise taps(s);
        std::vector<test::SlowToken> tokens;
        for (std::size_t a = 0; a < observer.depth.size(); ++a) {
            const int x = static_cast<int>(a) % m.size_px(), y = static_cast<int>(a) / m.size_px();
            test::SlowToken t{x, y, observer.depth[a] != m.background(), {}};
            if (t.visible)
                t.reads = test::slow_reads(
                    s,
                    test::slow_transform(matrix, m, test::slow_words(s, x, y, observer.depth[a])),
                    noise.words(a), taps.bytes(a));
            tokens.push_back(t);
        }
        test::SlowReplay slow(s, issue, tokens);
        const std::uint64_t total = slow.run();
        const MemoryLedger got = replay_memory(observer.store, matrix, s, issue);
        const std::string where = "round " + std::to_string(round);
        EXPECT_EQ(got.total_ns, total) << where;
        EXPECT_EQ(list(got.observer), list(slow.observer.counts)) << where;
        EXPECT_EQ(list(got.light), list(slow.light.counts)) << where;
        EXPECT_EQ(list(got.mask), list(slow.mask.counts)) << where;
        EXPECT_GE(got.total_ns, got.ideal_ns) << where;
        const PathTime path = test::slow_ideal_path(s, issue, tokens);
        EXPECT_EQ(list(got.ideal_path), list(path)) << where;
        EXPECT_EQ(got.ideal_ns, path.total_ns()) << where;
        expect_sums(got, s);
        if (HasFailure()) return;
        looked_up += got.looked_up;
        hidden += got.total_ns == got.ideal_ns;
        shown += got.total_ns > got.ideal_ns;
    }
    EXPECT_GT(looked_up, std::uint64_t(umbra78::test::effort(4000)));
    EXPECT_GT(hidden, 0u);
    EXPECT_GT(shown, std::uint64_t(umbra78::test::effort(50)));
}

// A memory quicker than the clock is the ideal one, whatever is stolen from it.
TEST(MemoryReplay, QuickMemoryIsIdealExactly) {
    Random random;
    for (int round = 0; round < umbra78::test::effort(60); ++round) {
        Settings s = random_timing(random, test::random_settings(random, false));
        s.timing.dram.access_ns = s.timing.dram.cycle_ns = 1;
        s.timing.dram.column_ns = 1;
        s.timing.dram.page_ns = static_cast<int>(random.between(0, 1));
        OwnedStore<hw::Depth32> observer(s.machine.xy_bits);
        test::fill_depth(random, s.machine, observer.depth);
        const hw::MatrixWords matrix = test::random_matrix(random, s.machine, true);
        const std::uint64_t issue = 1 + random.bits() % 6;
        const MemoryLedger l = replay_memory(observer.store, matrix, s, issue);
        expect_sums(l, s);
        EXPECT_EQ(l.total_ns, l.ideal_ns);
    }
}

TEST(MemoryReplay, IdealTotalsAreTheClosedForm) {
    Settings s;
    s.machine.xy_bits = 6;
    OwnedStore<hw::Depth16> observer(6);
    const hw::MatrixWords none{};  // every point in the middle of the map
    const std::uint64_t pixels = 64 * 64, clock = 200;
    for (const std::uint64_t issue : {1, 3, 9}) {
        std::fill(observer.depth.begin(), observer.depth.end(), hw::Depth16{65535});
        MemoryLedger l = replay_memory(observer.store, none, s, issue);
        EXPECT_EQ(l.ideal_ns, (pixels + 3) * clock) << "a clock a pixel, three to drain";
        EXPECT_EQ(l.visible, 0u);
        EXPECT_EQ(l.light.requests, 0u);
        std::fill(observer.depth.begin(), observer.depth.end(), hw::Depth16{1000});
        l = replay_memory(observer.store, none, s, issue);
        EXPECT_EQ(l.ideal_ns, (pixels * issue + 3) * clock);
        EXPECT_EQ(l.visible, pixels);
        EXPECT_EQ(l.looked_up, pixels);
        s.lookup = Lookup::bilinear;
        l = replay_memory(observer.store, none, s, issue);
        EXPECT_EQ(l.ideal_ns, issue >= 4 ? (pixels * issue + 6) * clock
                                         : (pixels * 4 + 2 + issue) * clock);
        EXPECT_EQ(l.light.requests, 4 * pixels);
        s.timing.light_banks = 4;
        l = replay_memory(observer.store, none, s, issue);
        EXPECT_EQ(l.ideal_ns, (pixels * issue + 3) * clock);
        EXPECT_EQ(l.light.requests, pixels);
        EXPECT_EQ(l.light.accesses, 4 * pixels);
        s.lookup = Lookup::nearest;
        s.timing.light_banks = 1;
    }
}

// The texels, in order, are the model's; and they are those of the comparison: with all others
// changed, it has the same result.
TEST(LookupTexels, AreThoseTheComparisonReads) {
    Random random;
    std::uint64_t four = 0, fewer = 0, none = 0;
    for (int round = 0; round < umbra78::test::effort(4000); ++round) {
        Settings s = test::random_settings(random, false);
        s.machine.xy_bits = 4;
        const hw::MachineSpec& m = s.machine;
        const std::int64_t edge = std::int64_t{m.half_px()} << m.fraction_bits;
        const hw::Point p{random.between(-edge - 9, edge + 9), random.between(-edge - 9, edge + 9),
                          random.between(-m.depth_offset() - 2, m.depth_offset() + 1),
                          random.bits() % 8 == 0 ? hw::DivideStatus::divisor_not_positive
                                                 : hw::DivideStatus::ok};
        const hw::DitherWords d{static_cast<std::int32_t>(random.between(-64, 64)),
                                static_cast<std::int32_t>(random.between(-64, 64))};
        OwnedStore<hw::Depth32> light(4), other(4);
        test::fill_depth(random, m, light.depth);
        test::fill_depth(random, m, other.depth);
        s.timing.light_banks = test::pick(random, {1, 4});
        hw::TapBytes noise;
        for (auto* bytes : {&noise.x, &noise.y})
            for (std::uint8_t& b : *bytes) b = static_cast<std::uint8_t>(random.bits());
        const Texels texels = lookup_texels(s, s.timing.light_banks, p, d, noise);
        const auto reads = test::slow_reads(s, p, d, noise);
        ASSERT_EQ(texels.count, reads.size()) << round;
        for (std::size_t k = 0; k < texels.count; ++k) {
            ASSERT_EQ((test::SlowTexel{texels.at[k].x, texels.at[k].y}), reads[k].texel) << round;
            ASSERT_EQ(k > 0 && texels.cycle[k] == texels.cycle[k - 1],
                      k > 0 && reads[k].request == reads[k - 1].request) << round;
        }
        for (std::size_t k = 0; k < texels.count; ++k) {
            const std::size_t a = light.store.address(texels.at[k].x, texels.at[k].y);
            other.depth[a] = light.depth[a];
        }
        const auto map = light_map<hw::Depth32>(light.store, s);
        const auto changed = light_map<hw::Depth32>(other.store, s);
        ASSERT_EQ(test::slow_darkness(map, p, d, noise),
                  test::slow_darkness(changed, p, d, noise)) << round;
        const auto all = static_cast<std::size_t>(
            has_window(s.lookup) ? s.taps * s.taps
            : s.lookup == Lookup::nearest || m.fraction_bits == 0 ? 1 : 4);
        ASSERT_LE(texels.count, all);
        four += texels.count >= 4;
        fewer += texels.count != 0 && texels.count < all;
        none += texels.count == 0;
    }
    EXPECT_GT(four, std::uint64_t(umbra78::test::effort(500)));
    EXPECT_GT(fewer, std::uint64_t(umbra78::test::effort(50))) << "at the map's edge";
    EXPECT_GT(none, std::uint64_t(umbra78::test::effort(500)));
}

// The figures' frame: what depends on settings and addresses does so, what must not does not.
TEST(MemoryReplay, OfTheFiguresFrame) {
    const test::FigureScene figures;
    Settings s = figure_settings(3);
    const test::Frame<> frame(figures.scene(), s);
    ASSERT_EQ(frame.status, FrameStatus::ok);
    const auto replay = [&](const Settings& with) {
        const MemoryLedger l =
            replay_memory(frame.buffers.observer, frame.matrices.lights[0].observer_to_light, with,
                          3);
        expect_sums(l, with);
        return l;
    };
    const MemoryLedger plain = replay(s);
    EXPECT_EQ(plain.pixels, 262144u);
    EXPECT_EQ(plain.visible, 106772u);
    EXPECT_GE(plain.ideal_ns, (155372 + 3 * std::uint64_t{106772}) * 200);
    EXPECT_GT(plain.total_ns, plain.ideal_ns);
    s.timing.dram.page_ns = 0;
    EXPECT_EQ(replay(s).light.page_hits, 0u);
    s.timing.dram = {};
    s.timing.dram.video = hw::Video::all;
    EXPECT_GT(replay(s).light.row_misses, plain.light.row_misses) << "read-out closes rows";
    EXPECT_EQ(replay(s).ideal_ns, plain.ideal_ns);
}

// hw/MACHINE.md, section 17: the ledgers of figures 3 and 4.
struct Published {
    int figure, banks;
    std::uint64_t slot_cycles;  // S
    std::array<std::uint64_t, 3> row_misses, row_changes;  // observer, light, mask
    std::uint64_t latency_ns, total_ns, ideal_ns;
};
constexpr Published published[] = {
    {3, 1, 3, {15050, 8649, 7833}, {26, 3841, 1698}, 23'621'920, 95'858'800, 95'138'200},
    {4, 1, 4, {15262, 64467, 10264}, {26, 56321, 1492}, 101'789'655, 148'384'400, 116'934'800},
    {4, 4, 3, {15023, 81762, 7827}, {29, 62490, 1691}, 29'597'070, 95'875'000, 95'138'200},
};

TEST(MemoryReplay, LedgersArePublished) {
    const test::FigureScene figures;
    for (const Published& p : published) {
        Settings s = figure_settings(p.figure);
        s.timing.light_banks = p.banks;
        const test::Frame<> frame(figures.scene(), s);
        const MemoryLedger l =
            replay_memory(frame.buffers.observer, frame.matrices.lights[0].observer_to_light, s,
                          p.slot_cycles);
        EXPECT_EQ((std::array{l.observer.row_misses, l.light.row_misses, l.mask.row_misses}),
                  p.row_misses);
        EXPECT_EQ((std::array{l.observer.row_changes, l.light.row_changes, l.mask.row_changes}),
                  p.row_changes);
        EXPECT_EQ(l.observer.latency_ns() + l.light.latency_ns() + l.mask.latency_ns(),
                  p.latency_ns);
        EXPECT_EQ(l.total_ns, p.total_ns);
        EXPECT_EQ(l.ideal_ns, p.ideal_ns);
    }
}

}  // namespace
}  // namespace umbra78::shadow
