// The table of methods: each row against the plan, the stages, the ledger and the costs; and a toy
// row of this test's own, which everything but the table must take as it takes the others.
#include "shadow/frame/methods.hpp"

#include "shadow/filters/composite.hpp"
#include "shadow/frame/costs.hpp"
#include "tests/shadow/frame/equal_frames.hpp"
#include "tests/shadow/frame/planned_scenes.hpp"
#include "tests/support/effort.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string_view>

namespace umbra78::shadow {
namespace {

using test::PlannedFrame;
using test::PlannedScene;

PlannedScene scene_of(const Method& method) {
    PlannedScene planned = test::planned_scene(!method.on_ground()          ? "figure 6"
                                               : method.form == Form::blob ? "blob"
                                                                           : "ground");
    planned.settings.form = method.form;
    planned.settings.arithmetic = method.arithmetic;
    planned.settings.lookup = method.lookups.back();
    return planned;
}

FrameLedger ledger_of_method(const PlannedFrame& f) {
    return frame_ledger(f.inputs, f.frame.buffers, f.frame.counts);
}

// --- the table -----------------------------------------------------------------------------------

TEST(Methods, TheSettingsChooseARow) {
    std::set<std::string_view> names;
    for (const Method& m : methods()) {
        EXPECT_TRUE(names.insert(m.name).second) << m.name;
        EXPECT_FALSE(m.meaning.empty()) << m.name;
        Settings s;
        s.form = m.form;
        s.arithmetic = m.arithmetic;
        for (const Lookup lookup : m.lookups) {
            s.lookup = lookup;
            EXPECT_EQ(method_of(s), &m) << m.name;
        }
        s.machine.z_bits = m.max_z_bits;
        EXPECT_TRUE(method_can(s)) << m.name;
        EXPECT_TRUE(can_be_built(s)) << m.name;
        s.machine.z_bits = m.max_z_bits + 1;
        EXPECT_FALSE(method_can(s)) << m.name;
        EXPECT_FALSE(can_be_built(s)) << m.name;
        s.machine.z_bits = m.max_z_bits;
        for (const Lookup lookup : m.lookups) {
            s.lookup = lookup;
            s.receiver = Receiver::plane;
            EXPECT_EQ(method_can(s), m.takes_plane && !has_window(lookup)) << m.name;
            s.receiver = Receiver::normal;
            EXPECT_EQ(method_can(s), m.takes_normal) << m.name;
        }
    }
    EXPECT_EQ(names, (std::set<std::string_view>{"post_process", "percentage", "correct",
                                                  "ap120b", "ground", "blob", "brute",
                                                  "volumes", "ordered_volumes",
                                                  "stencil_pass", "stencil_fail",
                                                  "bouknight_kelley", "appel", "splitting",
                                                  "perimeters", "atherton", "irregular",
                                                  "irregular_map"}));
    Settings none;
    none.form = Form::correct;
    none.arithmetic = Arithmetic::ap120b;
    EXPECT_EQ(method_of(none), nullptr);
    EXPECT_FALSE(method_can(none));
    for (const Lookup lookup : {Lookup::percentage, Lookup::filtered_depth}) {
        none.form = Form::post_process;
        none.lookup = lookup;
        EXPECT_EQ(method_of(none), nullptr) << "the AP-120B has no window";
    }
    none = {};
    none.form = Form::correct;
    none.lookup = Lookup::percentage;
    EXPECT_EQ(method_of(none), nullptr) << "no sample is shaded by a share of a light";
    for (const int taps : {1, 6}) {
        Settings s;
        s.taps = taps;
        EXPECT_TRUE(method_can(s)) << "nearest lookup has no window";
        s.lookup = Lookup::filtered_depth;
        EXPECT_FALSE(method_can(s)) << taps;
    }
}

TEST(Methods, ARowIsConsistent) {
    for (const Method& m : methods()) {
        SCOPED_TRACE(m.name);
        EXPECT_TRUE(m.depth_layers >= 0 && m.depth_layers <= 2);
        EXPECT_TRUE(!m.on_ground() || m.tests_when_drawn()) << "a shadow on a ground is drawn";
        EXPECT_EQ(m.memory != nullptr, m.may_run_out);
        EXPECT_TRUE(!m.in_shading || m.tests_when_drawn());
        EXPECT_EQ(m.trace == Trace::none, !m.no_trace.empty());
        EXPECT_EQ(m.plan_cost == nullptr, !m.no_plan_cost.empty());
        EXPECT_NE(m.units, nullptr);
        EXPECT_EQ(m.stages16.draw == nullptr, m.stages32.draw == nullptr);
        EXPECT_TRUE(m.stages16.cast != nullptr && m.stages32.cast != nullptr);
        EXPECT_TRUE(m.stages16.frame_cost != nullptr && m.stages32.frame_cost != nullptr);
        EXPECT_EQ(m.cannot.empty(), false) << "every method of 1978 has something it cannot do";
    }
}

// The plan decides by the row, and the mask holds what the row says it holds.
void expect_plan_and_stages_of_row(const Method& m, const PlannedFrame& f, const FramePlan& plan) {
    EXPECT_EQ(plan.at(Omission::composite).reason,
              m.in_shading ? Reason::shadow_in_shading : Reason::asked_for);
    EXPECT_EQ(plan.at(Omission::background_pixels).reason,
              m.on_ground()          ? Reason::shadow_drawn
              : !m.has_map()         ? Reason::no_map_kept
              : m.tests_when_drawn() ? Reason::tested_when_drawn
                                     : Reason::nothing_there);
    std::uint64_t dark = 0, between = 0;
    for (const std::uint8_t darkness : f.frame.buffers.lights[0].mask) {
        dark += darkness != mask_lit;
        between += darkness != mask_lit && darkness != mask_shadow;
        EXPECT_TRUE(m.darkness == Darkness::graded || darkness == mask_lit ||
                    darkness == mask_shadow);
    }
    EXPECT_GT(dark, 100u);
    EXPECT_EQ(between > 0, m.darkness == Darkness::graded);
    EXPECT_EQ(plan.at(Omission::dequantize).reason,
              m.darkness == Darkness::graded ? Reason::graded : Reason::asked_for);
    EXPECT_EQ(dark, f.frame.counts.lights[0].post_process.shadowed);
    EXPECT_TRUE(f.frame.counts.lights[0].capacity.enough);
}

void expect_ledger_and_costs_of_row(const Method& m, const PlannedFrame& f, const FramePlan& plan) {
    const FrameLedger l = ledger_of_method(f);
    EXPECT_EQ(l.on_array, m.arithmetic == Arithmetic::ap120b);
    EXPECT_EQ(l.has_map, m.has_map());
    EXPECT_EQ(l.post_process.count > 0, m.arithmetic == Arithmetic::fixed && m.has_map());
    EXPECT_GT(l.transformation(true), l.visible);
    EXPECT_FALSE(l.bottleneck().empty());
    const hw::Operations o{1000, 100, 400, 10, 220, 50};
    const hw::UnitCycles units = m.units(o, f.inputs.settings);
    EXPECT_EQ(units.multipliers, 100u);
    EXPECT_EQ(units.divider, m.arithmetic == Arithmetic::ap120b ? 230u : 220u);
    EXPECT_EQ(l.scene.units.one_after_the_other() > 0, m.surfaces == Surfaces::facets);
    if (m.plan_cost == nullptr) return;
    const DrawnFrame drawn{f.inputs, l};
    const std::uint64_t tested = !m.has_map()           ? 0
                                 : m.tests_when_drawn() ? l.observer_counts.samples
                                                        : l.visible;
    EXPECT_EQ(cycles_of(plan, drawn)[2].transform, 3 * tested);
    EXPECT_EQ(saving(Omission::divide, plan, drawn).after_drawing, m.tests_when_drawn());
}

TEST(Methods, PlanStagesLedgerAndCostsAskTheRow) {
    for (const Method& m : methods()) {
        SCOPED_TRACE(m.name);
        PlannedScene planned = scene_of(m);
        planned.settings.machine.xy_bits = 6;
        if (umbra78::test::sanitized) planned.settings.dice_levels = 2;
        PlannedFrame f(planned);
        EXPECT_EQ(&method_of(f.inputs), &m);
        const FramePlan plan = make_plan(f.inputs);
        f.draw(plan);
        expect_plan_and_stages_of_row(m, f, plan);
        expect_ledger_and_costs_of_row(m, f, plan);
    }
}

// --- a row of one's own --------------------------------------------------------------------------

constexpr std::uint64_t room = 2000;

// Everything that is visible is dark; it keeps a word for each such pixel and has room for 2000.
template <class Depth, std::uint8_t darkness>
void darken(const FrameInputs& in, const FramePlan&, std::size_t l, FrameBuffers<Depth>& frame,
            FrameCounts& counts) {
    const std::uint32_t none = in.settings.machine.background();
    LightCounts& c = counts.lights[l];
    c.post_process = {};
    for (std::size_t k = 0; k < frame.observer.depth.size(); ++k) {
        const bool visible = frame.observer.depth[k] != none;
        c.post_process.visible += visible;
        frame.lights[l].mask[k] = visible ? darkness : std::uint8_t{0};
    }
    c.post_process.shadowed = c.post_process.visible;
    c.capacity = {c.post_process.visible <= room, c.post_process.visible};
}

template <class Depth>
void cost_of_darkness(const FrameInputs& in, std::size_t, const FrameBuffers<Depth>&,
                      const FrameCounts&, FrameLedger& ledger) {
    const hw::Operations o = ledger.visible * hw::Operations{.adds = 1, .accesses = 8};
    ledger.test = {o, method_of(in).units(o, in.settings)};
}

void cost_of_the_scene(const FrameInputs& in, std::size_t, FrameLedger& ledger) {
    const hw::Operations o = in.scene.patches.size() * hw::Operations{.adds = 40};
    ledger.scene = {o, method_of(in).units(o, in.settings)};
}

StageCycles darkness_cycles(const DrawnFrame& drawn, const FramePlan&, std::size_t) {
    StageCycles c;
    c.operations = drawn.ledgers[0].test.units;
    return c;
}

template <std::uint8_t darkness>
Method toy() {
    Method m = methods()[0];
    m.name = "dark";
    m.darkness = darkness == 255 ? Darkness::binary : Darkness::graded;
    m.may_run_out = true;
    m.scene_cost = cost_of_the_scene;
    m.plan_cost = darkness_cycles;
    m.stages16 = {nullptr, darken<hw::Depth16, darkness>, cost_of_darkness<hw::Depth16>};
    m.stages32 = {nullptr, darken<hw::Depth32, darkness>, cost_of_darkness<hw::Depth32>};
    return m;
}

// Draws the scene by the plan and by FramePlan{}, compares, and returns the planned frame's
// expected picture in place.
template <std::uint8_t darkness>
void expect_dark(int dequantize_passes) {
    const Method method = toy<darkness>();
    PlannedScene planned = test::planned_scene("figure 6");
    planned.settings.dequantize_passes = dequantize_passes;
    planned.settings.low_pass_passes = 0;
    PlannedFrame all(planned), f(planned);
    all.inputs.method = f.inputs.method = &method;
    const FramePlan plan = make_plan(f.inputs);
    f.draw(plan);
    FramePlan everything;
    everything.at(Omission::dequantize) = plan.at(Omission::dequantize);
    all.draw(everything);
    test::expect_equal_frames(all.frame.buffers, f.frame.buffers);
    const FrameBuffers<hw::Depth16>& b = f.frame.buffers;
    const std::uint32_t none = planned.settings.machine.background();
    for (std::size_t k = 0; k < b.picture.size(); ++k) {
        const std::uint8_t expected = b.observer.depth[k] == none ? 0 : darkness;
        ASSERT_EQ(b.lights[0].mask[k], expected) << k;
        ASSERT_EQ(b.picture[k], composite(b.observer.intensity[k], b.observer.direct[k], expected,
                                          planned.settings.density_q8))
            << k;
    }
}

TEST(ToyMethod, IsDrawnAsTheOthersAre) {
    expect_dark<255>(0);
    expect_dark<120>(0);
}

// Graded darkness has no edges to follow: the plan leaves dequantizing out and says why.
TEST(ToyMethod, GradedDarknessIsNotDequantized) {
    expect_dark<120>(3);
    const Method method = toy<120>();
    const PlannedScene planned = test::planned_scene("figure 6");
    PlannedFrame f(planned);
    f.inputs.method = &method;
    const FramePlan plan = make_plan(f.inputs);
    EXPECT_TRUE(plan.leaves_out(Omission::dequantize));
    EXPECT_EQ(plan.at(Omission::dequantize).reason, Reason::graded);
}

// Too little room is a status with the number needed.
TEST(ToyMethod, SaysWhatItHasNoRoomFor) {
    const Method method = toy<255>();
    for (const int xy_bits : {5, 7}) {
        PlannedScene planned = test::planned_scene("figure 6");
        planned.settings.machine.xy_bits = xy_bits;
        PlannedFrame f(planned);
        f.inputs.method = &method;
        f.draw(make_plan(f.inputs));
        const LightCounts& c = f.frame.counts.lights[0];
        EXPECT_EQ(c.capacity.needed, c.post_process.visible);
        EXPECT_EQ(c.capacity.enough, xy_bits == 5);
    }
}

// What it takes for a frame is in the frame's total, what it takes for the scene is apart.
TEST(ToyMethod, HasItsPlaceInLedgerAndCosts) {
    const Method method = toy<255>();
    const PlannedScene planned = test::planned_scene("figure 6");
    PlannedFrame f(planned);
    f.inputs.method = &method;
    const FramePlan plan = make_plan(f.inputs);
    f.draw(plan);
    const FrameLedger l = ledger_of_method(f);
    EXPECT_EQ(l.test.units.store, 8 * l.visible);
    EXPECT_EQ(l.transformation(true), 8 * l.visible);
    EXPECT_EQ(l.transformation(false), 8 * l.visible + (l.visible + 3) / 4);
    EXPECT_EQ(l.bottleneck(), "frame store");
    EXPECT_EQ(l.scene.units.one_after_the_other(), 128u * 40 / 4);
    EXPECT_EQ(l.total(true), FrameLedger::cycles(l.light, true) +
                                 FrameLedger::cycles(l.observer, true) + 8 * l.visible +
                                 l.filters(true));
    const DrawnFrame drawn{f.inputs, l};
    EXPECT_EQ(cycles_of(plan, drawn)[2].total(), 8 * l.visible + (l.visible + 3) / 4);
}

// A frame drawn by another method keeps its pictures but no mask.
TEST(ToyMethod, AnotherMethodsMaskIsNotKept) {
    const Method method = toy<255>();
    const PlannedScene planned = test::planned_scene("figure 6");
    const PlannedFrame before(planned);
    PlannedFrame f(planned);
    f.inputs.method = &method;
    const FramePlan plan = make_plan(f.inputs, &before.inputs);
    EXPECT_TRUE(plan.leaves_out(Omission::same_light_map));
    EXPECT_TRUE(plan.leaves_out(Omission::same_observer));
    EXPECT_FALSE(plan.leaves_out(Omission::same_mask));
    EXPECT_FALSE(plan.leaves_out(Omission::same_picture));
    EXPECT_TRUE(make_plan(f.inputs, &f.inputs).leaves_out(Omission::same_picture));
}

TEST(MethodsDeathTest, NoMethodTraps) {
    FrameInputs in{};
    in.settings.form = Form::correct;
    in.settings.arithmetic = Arithmetic::ap120b;
    EXPECT_DEATH(method_of(in).name.size(), "");
}

}  // namespace
}  // namespace umbra78::shadow
