// What memory of the time costs the post-process, and where it shows: dither, interpolation and the
// light's angle as page misses of the light map (hw/MACHINE.md, section 17). Where a line that is
// printed names no other settings they are figure 3's: nearest lookup, no dither, four multipliers,
// one bank, pages of whole lines, the observer's store read out to a monitor.
#include "shadow/clocked/memory_replay.hpp"
#include "shadow/clocked/post_process.hpp"
#include "tests/claims/ground.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <string>
#include <vector>

namespace umbra78::claims {
namespace {

using hw::DramRows;
using shadow::Lookup;
using shadow::MemoryLedger;

// A frame of the figures' scene under any light at infinity. What the replay depends on, the
// observer's Z and the matrix, is the same for all settings below.
struct Lit {
    explicit Lit(int azimuth = -100, int elevation = 0) : settings(shadow::figure_settings(3)) {
        shadow::Scene scene = figures().scene();
        scene.lights[0].axes = raster::axes_from_angles(azimuth * 65536, elevation * 65536);
        EXPECT_EQ(frame.draw(scene, settings), shadow::FrameStatus::ok);
    }
    MemoryLedger replay(const Settings& s) const {
        const hw::MatrixWords& matrix = frame.matrices.lights[0].observer_to_light;
        const shadow::PostProcessPipeline plan(s, matrix);
        return replay_memory(frame.buffers.observer, matrix, s,
                             static_cast<std::uint64_t>(plan.slot_cycles));
    }

    Settings settings;
    shadow::test::Frame<> frame{hw::MachineSpec{}, figures().patches.size()};
};

const Lit& figure3() {
    static const Lit lit;
    return lit;
}

double ms(std::uint64_t ns) { return static_cast<double>(ns) * 1e-6; }
double miss_rate(const MemoryLedger& l) {
    return static_cast<double>(l.light.row_misses) / static_cast<double>(l.light.accesses);
}
double slowdown(const MemoryLedger& l) {
    return static_cast<double>(l.total_ns) / static_cast<double>(l.ideal_ns) - 1;
}

MemoryLedger print(const std::string& what, const MemoryLedger& l) {
    const auto number = [](std::uint64_t n) { return static_cast<unsigned long long>(n); };
    std::printf("%-36s %6llu reads, %6llu row misses (%5.2f %%); frame %7.3f ms, ideal %7.3f "
                "(%+.1f %%)\n",
                what.c_str(), number(l.light.accesses), number(l.light.row_misses),
                100 * miss_rate(l), ms(l.total_ns), ms(l.ideal_ns), 100 * slowdown(l));
    return l;
}

Settings dithered(Settings s) {
    s.dither.shape = hw::DitherShape::normal;
    return s;
}
Settings bilinear(Settings s, int banks) {
    s.lookup = Lookup::bilinear;
    s.timing.light_banks = banks;
    return s;
}
Settings in_rows(Settings s, DramRows rows) {
    s.timing.dram.rows = rows;
    return s;
}
Settings unpaged(Settings s) {
    s.timing.dram.page_ns = 0;
    return s;
}
Settings with_multipliers(Settings s, int n) {
    s.machine.multipliers = n;
    return s;
}

// With four multipliers a point takes three clocks, and one read hides in them. Four reads of one
// bank do not; four banks again do.
TEST(Memory, InterpolationWantsFourBanks) {
    const Settings s = figure3().settings;
    const MemoryLedger nearest = print("figure 3", figure3().replay(s));
    const MemoryLedger one = print("bilinear, 1 bank", figure3().replay(bilinear(s, 1)));
    const MemoryLedger four = print("bilinear, 4 banks", figure3().replay(bilinear(s, 4)));
    EXPECT_EQ(nearest.ideal_ns, (155372 + 3 * 106772 + 3) * std::uint64_t{200})
        << "no queues: a clock a background pixel, three a visible one, three to drain";
    EXPECT_LT(slowdown(nearest), 0.01);
    EXPECT_GT(slowdown(one), 0.25);
    EXPECT_LT(slowdown(four), 0.01);
    EXPECT_EQ(one.light.accesses, 4 * nearest.light.accesses);
    EXPECT_GT(miss_rate(one), 1.5 * miss_rate(nearest)) << "two lines, and a page ends between";
    EXPECT_EQ(miss_rate(four), miss_rate(nearest)) << "each bank has its own open row";
    const auto part = [](const char* store, const hw::DramCounts& c) {
        std::printf("  %-10s %6llu accesses, %6llu page hits, waits: refresh %4llu (%5.3f ms), "
                    "video %4llu (%5.3f ms), bank %5llu (%5.3f ms), busy %6.3f ms\n",
                    store, static_cast<unsigned long long>(c.accesses),
                    static_cast<unsigned long long>(c.page_hits),
                    static_cast<unsigned long long>(c.refresh_waits), ms(c.refresh_wait_ns),
                    static_cast<unsigned long long>(c.video_waits), ms(c.video_wait_ns),
                    static_cast<unsigned long long>(c.bank_waits), ms(c.bank_wait_ns),
                    ms(c.busy_ns));
    };
    part("observer", nearest.observer);
    part("light", nearest.light);
    part("mask", nearest.mask);
    std::printf("  waited for: read %.3f, unit %.3f, light map %.3f, write %.3f ms\n",
                ms(nearest.path.read_ns), ms(nearest.path.unit_ns), ms(nearest.path.light_ns),
                ms(nearest.path.write_ns));
}

// A light that only turns about the vertical axis moves points along their scan line, and the
// dither's half texel does not leave the line: in pages of whole lines neither costs a miss. Four
// banks fetch the next line too, and there dither decides which.
TEST(Memory, DitherCostsMissesOnlyAcrossLines) {
    const Settings s = figure3().settings;
    const MemoryLedger plain = print("figure 3", figure3().replay(s));
    const MemoryLedger noisy = print("dithered", figure3().replay(dithered(s)));
    EXPECT_EQ(noisy.light.row_misses, plain.light.row_misses);
    EXPECT_EQ(noisy.total_ns, plain.total_ns);
    const MemoryLedger four = print("bilinear, 4 banks", figure3().replay(bilinear(s, 4)));
    const MemoryLedger both =
        print("bilinear, 4 banks, dithered", figure3().replay(dithered(bilinear(s, 4))));
    EXPECT_GT(both.light.row_misses, 2 * four.light.row_misses);
    EXPECT_LT(slowdown(both), 0.01) << "and hides in the unit's three clocks";
    const Settings wide = with_multipliers(s, 16);
    const MemoryLedger fast =
        print("16 multipliers, bilinear, 4 banks", figure3().replay(bilinear(wide, 4)));
    const MemoryLedger fast_noisy = print("16 multipliers, ..., dithered",
                                          figure3().replay(dithered(bilinear(wide, 4))));
    EXPECT_GT(slowdown(fast_noisy), slowdown(fast) + 0.05) << "but not in one";
}

// Left open, a row answers sooner only if the next access comes within a cycle; at three clocks a
// point it would have been closed and ready again.
TEST(Memory, PageModePaysWhereAccessesAreDense) {
    const Settings s = figure3().settings;
    const MemoryLedger page = print("figure 3", figure3().replay(s));
    const MemoryLedger none = print("figure 3, no page mode", figure3().replay(unpaged(s)));
    EXPECT_LE(none.total_ns, page.total_ns);
    const MemoryLedger dense = print("bilinear, 1 bank", figure3().replay(bilinear(s, 1)));
    const MemoryLedger dense_none =
        print("bilinear, 1 bank, no page mode", figure3().replay(unpaged(bilinear(s, 1))));
    EXPECT_GT(slowdown(dense_none), 2 * slowdown(dense));
    const Settings wide = with_multipliers(s, 16);
    const MemoryLedger fast = print("16 multipliers", figure3().replay(wide));
    const MemoryLedger fast_none =
        print("16 multipliers, no page mode", figure3().replay(unpaged(wide)));
    EXPECT_GT(slowdown(fast_none), 2 * slowdown(fast));
}

// The light's azimuth: nothing to pages of whole lines. Where every word lies in another row, it
// is seen how fast a scan line's points run over the light's words.
TEST(Memory, TheLightsAzimuthShowsInRowsOfWords) {
    std::vector<MemoryLedger> lines, words;
    for (const int azimuth : {0, -30, -60, -100}) {
        const Lit lit(azimuth);
        const std::string at = "figure 3, azimuth " + std::to_string(azimuth);
        lines.push_back(print(at + ", lines", lit.replay(lit.settings)));
        words.push_back(print(at + ", words", lit.replay(in_rows(lit.settings, DramRows::words))));
    }
    for (std::size_t k = 1; k < lines.size(); ++k) {
        EXPECT_EQ(lines[k].light.row_misses, lines[0].light.row_misses);
        EXPECT_EQ(lines[k].total_ns, lines[0].total_ns);
        EXPECT_GT(words[k].light.row_misses, words[k - 1].light.row_misses);
    }
    EXPECT_GT(miss_rate(words[0]), 1.2 * miss_rate(lines[0]));
}

// The light's elevation does show in pages of lines: depth moves points across them.
TEST(Memory, TheLightsElevationShowsInPagesOfLines) {
    std::vector<MemoryLedger> plain, noisy;
    for (const int elevation : {0, 15, 30, 60}) {
        const Lit lit(-100, elevation);
        const std::string at = "figure 3, elevation " + std::to_string(elevation);
        plain.push_back(print(at, lit.replay(lit.settings)));
        noisy.push_back(print(at + ", dithered", lit.replay(dithered(lit.settings))));
    }
    for (std::size_t k = 1; k < plain.size(); ++k) {
        EXPECT_GT(plain[k].light.row_misses, plain[k - 1].light.row_misses);
        EXPECT_GT(noisy[k].light.row_misses, plain[k].light.row_misses);
    }
}

// Read out to a monitor, a store gives away a quarter of a visible line's cycles and its open row.
TEST(Memory, VideoOfEveryStoreClosesItsPages) {
    for (const int multipliers : {4, 16}) {
        Settings s = with_multipliers(figure3().settings, multipliers);
        const std::string at = std::to_string(multipliers) + " multipliers, video ";
        s.timing.dram.video = hw::Video::off;
        const MemoryLedger off = print(at + "off", figure3().replay(s));
        s.timing.dram.video = hw::Video::observer;
        const MemoryLedger observer = print(at + "observer", figure3().replay(s));
        s.timing.dram.video = hw::Video::all;
        const MemoryLedger all = print(at + "all", figure3().replay(s));
        EXPECT_LE(off.total_ns, observer.total_ns);
        EXPECT_LT(observer.total_ns, all.total_ns);
        EXPECT_GT(all.light.row_misses, 3 * off.light.row_misses);
        EXPECT_EQ(off.light.video_cycles, 0u);
        EXPECT_EQ(off.ideal_ns, all.ideal_ns);
    }
}

}  // namespace
}  // namespace umbra78::claims
