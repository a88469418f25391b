// The ledger: closed forms against the clock, stages and operations against hw/MACHINE.md.
#include "shadow/frame/ledger.hpp"

#include "raster/drawing_cost.hpp"
#include "shadow/frame/profiles.hpp"
#include "tests/shadow/clocked/clocked_frames.hpp"
#include "tests/shadow/frame/cost_by_hand.hpp"
#include "tests/shadow/frame/figure_frame.hpp"

#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <string_view>
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
            test::maps_of(observer, light), matrix, s, mask);
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

// The stages are those of hw/MACHINE.md, section 16, with their stays.
TEST(Ledger, StagesAreTheTables) {
    struct Row {
        PostProcessUnit unit;
        std::string_view stage;
        int stay;
    };
    const auto expect_rows = [](const Settings& s, const hw::MatrixWords& matrix,
                                const std::vector<Row>& expected) {
        const PostProcessLedger l = closed_form(Schedule{}, PostProcessPipeline(s, matrix));
        ASSERT_EQ(std::size_t(l.count), expected.size());
        for (std::size_t k = 0; k < expected.size(); ++k) {
            EXPECT_EQ(l.rows[k].stage, expected[k].stage) << k;
            EXPECT_EQ(l.rows[k].unit, expected[k].unit) << k;
            EXPECT_EQ(l.rows[k].stay, expected[k].stay) << k;
        }
    };
    using enum PostProcessUnit;
    Random random;
    const Settings four = figure_settings(4);
    expect_rows(four, test::random_matrix(random, four.machine, true),
                {{reader, "read", 1}, {transform, "multiply", 3}, {transform, "sum", 1},
                 {transform, "accumulate", 1}, {transform, "round", 1}, {lookup, "place", 1},
                 {lookup, "fetch", 4}, {lookup, "interpolate", 2}, {lookup, "compare", 1},
                 {writer, "write", 1}});
    Settings one = figure_settings(3);
    one.machine.multipliers = 1;
    expect_rows(one, test::random_matrix(random, one.machine, false),
                {{reader, "read", 1}, {transform, "multiply", 16}, {transform, "accumulate", 1},
                 {divider, "divide", 60}, {lookup, "place", 1}, {lookup, "fetch", 1},
                 {lookup, "compare", 1}, {writer, "write", 1}});
}

// A stage whose clock is held often is what every stage before it was blocked by.
TEST(Ledger, BlamesTheStageThatWasHeld) {
    Random random;
    Settings s = figure_settings(4);
    s.machine.xy_bits = 5;
    OwnedStore<hw::Depth32> observer(5), light(5);
    for (hw::Depth32& z : observer.depth) z = static_cast<hw::Depth32>(random.bits() % 1000);
    const hw::MatrixWords matrix = test::random_matrix(random, s.machine, true);
    std::vector<std::uint8_t> mask(observer.depth.size());
    const int stages = closed_form(Schedule{}, PostProcessPipeline(s, matrix)).count - 1;
    for (int held = 1; held < stages; ++held) {
        const auto machine = std::make_unique<ClockedPostProcess<hw::Depth32>>(
            test::maps_of(observer, light), matrix, s, mask);
        while (!machine->done())
            machine->tick(machine->cycles() % 103 < 60 ? hw::StageMask{1} << held : 0);
        const PostProcessLedger l = ledger_of(*machine);
        for (int k = 0; k <= held; ++k) {
            const StageLedger& row = l.rows[std::size_t(k)];
            EXPECT_GT(row.blocked, 0u) << row.stage;
            EXPECT_EQ(row.blamed, held + 1) << row.stage << " while " << held << " is held";
            EXPECT_EQ(row.work + row.blocked + row.held + row.idle, l.total) << row.stage;
        }
        for (int k = held + 1; k < l.count; ++k)
            EXPECT_NE(l.rows[std::size_t(k)].blamed, held + 1) << "it blocks nothing after it";
    }
}

struct DrawnLedger {
    FrameLedger ledger;
    FrameCounts counts;
};
DrawnLedger drawn_ledger(const Settings& s, const Scene& scene) {
    const test::Frame<> frame(scene, s);
    EXPECT_EQ(frame.status, FrameStatus::ok);
    return {frame_ledger({scene, s, frame.matrices}, frame.buffers, frame.counts), frame.counts};
}
FrameLedger figure_ledger(const Settings& s, const Scene& scene) {
    return drawn_ledger(s, scene).ledger;
}

// Figure 6, each phase by hand from its counts; the frame is their sum.
TEST(Ledger, AFrameIsTheSumOfItsPhases) {
    const test::FigureScene figures;
    const auto& [l, counts] = drawn_ledger(figure_settings(6), figures.scene());
    constexpr std::uint64_t n = 512 * 512;
    const std::uint64_t steps = counts.lights[0].chain_steps;
    EXPECT_GT(steps, 1000u);
    const test::Busy light = test::drawing_by_hand(l.light_counts, true, false, 5, 12);
    const test::Busy observer = test::drawing_by_hand(l.observer_counts, true, true, 5, 12);
    const test::Busy dequantize = test::dequantize_by_hand(steps, n, 1);
    const test::Busy low_pass = test::low_pass_by_hand(n, 2);
    const test::Busy composite = test::composite_by_hand(n);
    EXPECT_TRUE(test::same(l.light.operations, light));
    EXPECT_TRUE(test::same(l.observer.operations, observer));
    EXPECT_TRUE(test::same(l.dequantize.operations, dequantize));
    EXPECT_TRUE(test::same(l.low_pass.operations, low_pass));
    EXPECT_TRUE(test::same(l.composite.operations, composite));
    std::uint64_t side_by_side = 580249;  // hw/MACHINE.md, section 16: figure 4's pass
    std::uint64_t in_turn = n + 15 * 106772;
    EXPECT_EQ(l.transformation(true), side_by_side);
    EXPECT_EQ(l.transformation(false), in_turn);
    for (const test::Busy& b : {light, observer, dequantize, low_pass, composite}) {
        side_by_side += b.side_by_side();
        in_turn += b.one_after_the_other();
    }
    EXPECT_EQ(l.total(true), side_by_side);
    EXPECT_EQ(l.total(false), in_turn);
    EXPECT_EQ(l.filters(true), dequantize.side_by_side() + low_pass.side_by_side() +
                                   composite.side_by_side());
    EXPECT_EQ(l.visible, 106772u);
    EXPECT_EQ(l.post_process.bottleneck().stage, "fetch") << "four words a point on one bank";
    EXPECT_EQ(l.scene.units.one_after_the_other(), 0u) << "nothing is made ready for a scene";
}

// In perspective the corners are divided, and W is a component.
TEST(Ledger, APerspectiveFrameByHand) {
    const test::FigureScene figures;
    Scene scene = figures.scene();
    scene.observer.projection = raster::Projection::perspective;
    scene.observer.distance = 8 << 16;
    raster::fit_depth(scene.observer, raster::depth_range(scene.observer, scene.patches));
    Settings s = figure_settings(3);
    s.machine.coefficient_bits = 24;
    const FrameLedger l = figure_ledger(s, scene);
    EXPECT_TRUE(test::same(l.observer.operations,
                           test::drawing_by_hand(l.observer_counts, false, true, 5, 32)))
        << "two passes of 16 products a control point";
    EXPECT_TRUE(test::same(l.light.operations,
                           test::drawing_by_hand(l.light_counts, true, false, 5, 24)));
}

// Every shaded sample is costed with the sharpest highlight of the scene, of whatever material.
TEST(Ledger, TheSharpestOfTwoMaterialsCounts) {
    test::FigureScene figures;
    for (const bool first : {false, true}) {
        std::array<raster::Material, 2> materials{figure_material, figure_material};
        materials[first ? 0 : 1].shininess = 8;
        materials[first ? 1 : 0].shininess = 2;
        Scene scene = figures.scene();
        scene.materials = materials;
        EXPECT_EQ(sample_cost(scene, raster::ShadingRule::phong).shininess, 8);
        const FrameLedger l = figure_ledger(figure_settings(3), scene);
        EXPECT_TRUE(test::same(l.observer.operations,
                               test::drawing_by_hand(l.observer_counts, true, true, 8, 12)));
    }
    EXPECT_EQ(sample_cost({}, raster::ShadingRule::blinn).shininess, 0);
}

// Filters that are off cost nothing.
TEST(Ledger, WhatIsLeftOutIsFree) {
    const test::FigureScene figures;
    const FrameLedger l = figure_ledger(figure_settings(3), figures.scene());
    EXPECT_EQ(l.dequantize.units.one_after_the_other(), 0u);
    EXPECT_EQ(l.low_pass.units.one_after_the_other(), 0u);
    EXPECT_EQ(l.post_process.bottleneck().stage, "multiply");
    EXPECT_EQ(l.transformation(true), 474214u);  // hw/MACHINE.md, section 16
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
                                                        raster::Sampling::centre, false, {});
    EXPECT_EQ(o.adds, 3u * (60 + 43 + 1260) + 256 * 16 + 10 * 60 + 4 * 6);
    EXPECT_EQ(o.passes, 16u * 12 + 10 * 16 + 4 * 4);
    EXPECT_EQ(o.quotient_bits, 4u * 22);
    EXPECT_EQ(o.accesses, 8u);
}

}  // namespace
}  // namespace umbra78::shadow
