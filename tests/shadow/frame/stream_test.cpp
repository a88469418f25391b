// A frame of primitives that come in batches is the frame of the same primitives in spans: every
// buffer, the counts and the ledger, whatever their order and however they are divided.
#include "shadow/frame/stream.hpp"

#include "raster/extent.hpp"
#include "raster/projection.hpp"
#include "shadow/frame/ledger.hpp"
#include "tests/fixed/boundary.hpp"
#include "tests/shadow/frame/equal_frames.hpp"
#include "tests/shadow/frame/planned_scenes.hpp"
#include "tests/shadow/frame/variant_scenes.hpp"
#include "tests/support/batches.hpp"
#include "tests/support/effort.hpp"
#include "tests/support/trapped.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace umbra78::shadow {
namespace {

using umbra78::test::Batches;
using fixed::test::Random;

std::uint32_t largest_of(const raster::Surfaces& surfaces) {
    raster::Box box;
    surfaces.for_points([&](const raster::World& p) { box.add(p); });
    return box.largest();
}

// A held scene as a stream's, and a frame carved for no patch at all.
struct StreamedFrame {
    explicit StreamedFrame(Scene held, const Settings& settings)
        : frame(settings.machine, 0, test::PlannedFrame::shape(settings, false)) {
        held.streamed = true;
        held.largest_streamed = largest_of(held.surfaces());
        held.patches = {};
        held.mesh = {};
        inputs = {held, settings, {}};
        EXPECT_EQ(load_matrices(inputs.scene, settings, inputs.matrices), FrameStatus::ok);
        plan = make_plan(inputs);
    }
    StreamStatus draw(Batches& source) {
        return draw_stream(inputs, plan, source, frame.buffers, frame.counts);
    }

    test::Frame<> frame;
    FrameInputs inputs;
    FramePlan plan;
};

void expect_same_ledger(const FrameLedger& a, const FrameLedger& b) {
    EXPECT_EQ(a.light_counts.tested_blocks, b.light_counts.tested_blocks);
    EXPECT_EQ(a.observer_counts.samples, b.observer_counts.samples);
    EXPECT_EQ(a.observer_counts.triangles, b.observer_counts.triangles);
    EXPECT_EQ(a.visible, b.visible);
    EXPECT_EQ(a.total(true), b.total(true));
    EXPECT_EQ(a.total(false), b.total(false));
}

void expect_same_as_held(const Scene& held, const Settings& settings) {
    test::Frame<> expected(held, settings);
    ASSERT_EQ(expected.status, FrameStatus::ok);
    const FrameInputs in{held, settings, expected.matrices};
    const FrameLedger ledger = frame_ledger(in, expected.buffers, expected.counts);
    Random random;
    for (const std::size_t size : {1u, 7u, 1000u}) {
        SCOPED_TRACE(size);
        StreamedFrame got(held, settings);
        Batches source(held.surfaces(), size);
        source.shuffle(random);
        ASSERT_EQ(got.draw(source), StreamStatus::ok);
        EXPECT_EQ(source.rewinds, settings.form == Form::correct ? 2 : 1);
        test::expect_equal_frames(expected.buffers, got.frame.buffers,
                                  umbra78::test::Constant::expected);  // some views are empty
        expect_same_ledger(ledger, frame_ledger(got.inputs, got.frame.buffers, got.frame.counts));
        if (umbra78::test::sanitized) break;
    }
}

TEST(Stream, IsTheHeldFrameInAnyOrder) {
    for (test::PlannedScene& planned : test::planned_scenes()) {
        SCOPED_TRACE(planned.name);
        if (map_layers(planned.settings) == 0) continue;  // a stream names no ground
        planned.settings.machine.xy_bits = umbra78::test::sanitized ? 5 : 6;
        expect_same_as_held(planned.scene(), planned.settings);
    }
}

TEST(Stream, OfTrianglesAndDicedPatches) {
    const test::VariantScene made("mesh");
    Settings settings = figure_settings(6);
    settings.machine.xy_bits = 6;
    for (const raster::PatchForm surface : {raster::PatchForm::catmull, raster::PatchForm::diced})
        for (const raster::Facing facing : {raster::Facing::both, raster::Facing::front}) {
            settings.surface = surface;
            settings.facing = facing;
            expect_same_as_held(made.scene("front", "sun"), settings);
        }
}

TEST(Stream, FailuresAreNamed) {
    const test::PlannedScene planned = test::planned_scene("correct");
    StreamedFrame frame(planned.scene(), planned.settings);
    Batches source(planned.scene().surfaces(), 4);
    source.once = true;
    EXPECT_EQ(frame.draw(source), StreamStatus::cannot_rewind) << "the correct form reads twice";
    EXPECT_EQ(frame.draw(source), StreamStatus::cannot_rewind) << "it was read before";
    Batches torn(planned.scene().surfaces(), 4);
    torn.fails_at = 60;
    EXPECT_EQ(frame.draw(torn), StreamStatus::source_failed);
    Batches whole(planned.scene().surfaces(), 4);
    frame.inputs.scene.largest_streamed -= 1;
    EXPECT_EQ(frame.draw(whole), StreamStatus::beyond_largest);
}

TEST(Stream, HeldStagesRefuseAStream) {
    const test::PlannedScene planned = test::planned_scene("figure 6");
    StreamedFrame frame(planned.scene(), planned.settings);
    throw_when_trapped = true;
    EXPECT_THROW(draw_light(frame.inputs, frame.plan, frame.frame.buffers, frame.frame.counts),
                 std::logic_error);
    EXPECT_THROW(draw_observer(frame.inputs, frame.plan, frame.frame.buffers, frame.frame.counts),
                 std::logic_error);
    throw_when_trapped = false;
    EXPECT_EQ(frame.plan.at(Omission::light_map).reason, Reason::not_held);
}

// Minima and maxima of many batches are those of all points; views fitted to either are the same.
TEST(Stream, ExtentAddsUp) {
    const test::VariantScene made("mesh");
    const raster::Surfaces all = made.scene("front", "sun").surfaces();
    raster::Box whole, parts;
    raster::ViewRanges ranges{raster::axes_from_angles(-100 * 65536, 30 * 65536)};
    all.for_points([&](const raster::World& p) { whole.add(p); });
    Batches source(all, 3);
    Random random;
    source.shuffle(random);
    raster::Surfaces batch;
    ASSERT_TRUE(source.rewind());
    while (source.next(batch) == Batches::Next::batch)
        batch.for_points([&](const raster::World& p) {
            parts.add(p);
            ranges.add(p);
        });
    EXPECT_EQ(whole.min, parts.min);
    EXPECT_EQ(whole.max, parts.max);
    EXPECT_EQ(whole.centre(), parts.centre());
    EXPECT_EQ(raster::object_format(parts.largest()).fraction,
              raster::object_format(all).fraction);
    raster::View view = made.scene("front", "sun").lights[0];
    view.axes = ranges.axes;
    const raster::DepthRange held = raster::depth_range(view, all);
    const raster::DepthRange streamed = raster::depth_range_of(view, ranges.back);
    EXPECT_EQ(held.min, streamed.min);
    EXPECT_EQ(held.max, streamed.max);
    EXPECT_EQ(raster::Box{}.largest(), 0u);
    EXPECT_EQ(raster::Box{}.centre(), raster::World{});
}

}  // namespace
}  // namespace umbra78::shadow
