// The ledger: closed forms against the clock, drawing's counts against a drawing, sums.
#include "shadow/frame/ledger.hpp"

#include "raster/drawing_cost.hpp"
#include "shadow/frame/profiles.hpp"
#include "tests/shadow/clocked/clocked_frames.hpp"
#include "tests/shadow/frame/figure_frame.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

namespace umbra78::shadow {
namespace {

using test::OwnedStore;
using test::Random;

void expect_same_rows(const PostProcessLedger& a, const PostProcessLedger& b) {
    EXPECT_EQ(a.total, b.total);
    EXPECT_EQ(a.visible, b.visible);
    ASSERT_EQ(a.count, b.count);
    for (std::size_t k = 0; k < std::size_t(a.count); ++k) {
        const StageLedger &x = a.rows[k], &y = b.rows[k];
        EXPECT_EQ(x.stage, y.stage);
        EXPECT_EQ(x.unit, y.unit) << x.stage;
        EXPECT_EQ(x.stay, y.stay) << x.stage;
        EXPECT_EQ(x.work, y.work) << x.stage;
        EXPECT_EQ(x.blocked, y.blocked) << x.stage;
        EXPECT_EQ(x.held, y.held) << x.stage;
        EXPECT_EQ(x.idle, y.idle) << x.stage;
    }
}

// Random machines and planes: what the functional machine says without ticking is what the clock
// says, stage by stage.
TEST(Ledger, ClosedFormIsTheClocks) {
    Random random;
    for (int round = 0; round < 100 && !HasFailure(); ++round) {
        Settings s = test::random_settings(random, false);
        s.machine.xy_bits = 5;
        s.machine.multipliers = test::pick(random, {1, 4, 16});
        s.timing.divider = test::pick(random, {hw::Divider::serial, hw::Divider::pipelined});
        s.timing.noise_bits = test::pick(random, {8, 192});
        OwnedStore<hw::Depth32> observer(5), light(5);
        test::fill_depth(random, s.machine, observer.depth);
        test::fill_depth(random, s.machine, light.depth);
        const hw::MatrixWords matrix = test::random_matrix(random, s.machine, round % 2 == 0);
        std::vector<std::uint8_t> mask(observer.depth.size());
        const auto machine = std::make_unique<ClockedPostProcess<hw::Depth32>>(
            observer.store, light.store, matrix, s, mask);
        while (!machine->done()) machine->tick();
        const PostProcessPipeline plan(s, matrix);
        const Schedule plain = schedule<hw::Depth32>(observer.depth, s.machine.background(),
                                                     plan.read_cycles, plan.slot_cycles);
        expect_same_rows(closed_form(plain, plan), ledger_of(*machine));
    }
}

// The schedule's scan by chunks against a pixel at a time.
TEST(Ledger, ScheduleIsTheScan) {
    Random random;
    for (int round = 0; round < 300; ++round) {
        std::vector<hw::Depth16> depth(std::size_t(random.between(1, 700)));
        const auto mostly = random.bits() % 3;
        bool visible = false;
        for (hw::Depth16& z : depth) {
            if (mostly == 0 || random.bits() % 40 == 0) visible = random.bits() % 2 == 0;
            z = visible ? static_cast<hw::Depth16>(random.bits() % 65535) : 65535;
        }
        const int p = test::pick(random, {1, 1, 2, 8}), slot = test::pick(random, {1, 3, 4, 60});
        const Schedule got = schedule<hw::Depth16>(depth, 65535, p, slot);
        std::uint64_t seen = 0, at = 0, gap = 0;
        for (const hw::Depth16 z : depth) {
            ++gap;
            if (z == 65535) continue;
            const std::uint64_t reading = gap * std::uint64_t(p);
            at += seen == 0 ? reading - 1 : std::max(reading, std::uint64_t(slot));
            gap = 0;
            ++seen;
        }
        EXPECT_EQ(got.visible, seen);
        EXPECT_EQ(got.pixels, depth.size());
        EXPECT_EQ(got.last_issue, at);
        EXPECT_EQ(got.trailing, gap * std::uint64_t(p));
    }
}

FrameLedger figure_ledger(const Settings& s, const Scene& scene) {
    const test::Frame<> frame(scene, s);
    EXPECT_EQ(frame.status, FrameStatus::ok);
    return frame_ledger({scene, s, frame.matrices}, frame.buffers, frame.counts);
}

// Every phase is there, and the frame is their sum, with and without overlap.
TEST(Ledger, AFrameIsTheSumOfItsPhases) {
    const test::FigureScene figures;
    const FrameLedger l = figure_ledger(figure_settings(6), figures.scene());
    for (const bool overlap : {true, false}) {
        std::uint64_t sum = l.transformation(overlap);
        for (const PhaseLedger* p :
             {&l.light, &l.observer, &l.dequantize, &l.low_pass, &l.composite}) {
            EXPECT_GT(FrameLedger::cycles(*p, overlap), 0u);
            sum += FrameLedger::cycles(*p, overlap);
        }
        EXPECT_EQ(l.total(overlap), sum);
    }
    EXPECT_LT(l.total(true), l.total(false));
    EXPECT_EQ(l.visible, 106772u);
    EXPECT_EQ(l.post_process.bottleneck().stage, "fetch") << "four words a point on one bank";
}

// Filters that are off cost nothing.
TEST(Ledger, WhatIsLeftOutIsFree) {
    const test::FigureScene figures;
    const FrameLedger l = figure_ledger(figure_settings(3), figures.scene());
    EXPECT_EQ(l.dequantize.units.one_after_the_other(), 0u);
    EXPECT_EQ(l.low_pass.units.one_after_the_other(), 0u);
    EXPECT_EQ(l.post_process.bottleneck().stage, "multiply");
}

// Drawing costs neither more nor less for the order of its patches.
TEST(Ledger, DoesNotDependOnTheOrderOfPatches) {
    test::FigureScene figures;
    const FrameLedger a = figure_ledger(figure_settings(3), figures.scene());
    std::reverse(figures.patches.begin(), figures.patches.end());
    const FrameLedger b = figure_ledger(figure_settings(3), figures.scene());
    EXPECT_EQ(a.total(true), b.total(true));
    EXPECT_EQ(a.total(false), b.total(false));
    EXPECT_EQ(a.observer_counts.samples, b.observer_counts.samples);
}

// The paper, p. 272: the correct form sends every generated point to the light.
TEST(Ledger, TheCorrectFormPaysForEachGeneratedPoint) {
    const test::FigureScene figures;
    Settings s = figure_settings(3);
    s.form = Form::correct;
    const FrameLedger l = figure_ledger(s, figures.scene());
    EXPECT_EQ(l.post_process.visible, l.observer_counts.samples);
    EXPECT_GT(l.observer_counts.samples, 2 * l.visible);
    EXPECT_EQ(l.post_process.total, 1 + 3 * (l.observer_counts.samples - 1) + 10);
}

// Operations add up unit by unit.
TEST(Operations, CyclesOfTheUnits) {
    const hw::Operations o{40, 3, 7, 2, 44, 9};
    hw::MachineSpec spec;
    const hw::UnitCycles u = hw::unit_cycles(2 * o, spec);
    EXPECT_EQ(u.adders, 20u);
    EXPECT_EQ(u.multipliers, 4u) << "14 passes on four multipliers";
    EXPECT_EQ(u.divider, 88u);
    EXPECT_EQ(u.store, 18u);
    EXPECT_EQ(u.one_after_the_other(), 130u);
    EXPECT_STREQ(u.busiest(), "divider");
    const hw::UnitCycles ap = hw::ap120b_cycles(o, 2);
    EXPECT_EQ(ap.adders, 40u);
    EXPECT_EQ(ap.multipliers, 3u);
    EXPECT_EQ(ap.divider, 46u);
    EXPECT_EQ(ap.store, 18u);
}

// What a drawing does is what its cost counts: one flat patch of one block, counted by hand.
TEST(Operations, OfOneBlock) {
    raster::DrawCounts counts;
    counts.patches = counts.blocks = counts.tested_blocks = 1;
    counts.tested_centres = 10;
    counts.samples = 4;
    const hw::Operations o = raster::drawing_operations(counts, {}, true,
                                                        raster::Sampling::centre, false, 0);
    EXPECT_EQ(o.adds, 3u * (60 + 43 + 1260) + 256 * 16 + 10 * 60 + 4 * 6);
    EXPECT_EQ(o.passes, 16u * 12 + 10 * 16 + 4 * 4);
    EXPECT_EQ(o.quotient_bits, 4u * 22);
    EXPECT_EQ(o.accesses, 8u);
}

}  // namespace
}  // namespace umbra78::shadow
