// A frame that is shared out among workers has the same bits, counts and costs with any number.
#include "raster/census.hpp"
#include "shadow/frame/drawing.hpp"
#include "shadow/frame/frame.hpp"
#include "shadow/frame/ledger.hpp"
#include "tests/shadow/frame/equal_frames.hpp"
#include "tests/shadow/frame/planned_scenes.hpp"
#include "tests/support/effort.hpp"
#include "tests/support/workers.hpp"

#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <string>

namespace umbra78::shadow {
namespace {

using test::PlannedFrame;
using test::PlannedScene;
using umbra78::test::Shuffled;
using umbra78::test::Threads;

auto list(const raster::DrawCounts& c) {  // but for what is hidden, and not drawn for that
    return std::array{c.patches,       c.unresolved, c.tested_blocks,  c.splits,
                      c.facets,        c.cut_facets, c.diced_patches,  c.diced_vertices,
                      c.turned_triangles, c.triangles, c.triangle_lines, c.unresolved_facets,
                      c.facet_samples};
}
auto list(const LightCounts& c) {
    return std::array{c.post_process.visible,      c.post_process.shadowed,
                      c.post_process.lines,        c.chain_steps,
                      c.filtered_lines.dequantize, c.filtered_lines.low_pass,
                      c.filtered_lines.composite};
}
auto list(const FrameLedger& l) {
    return std::array{l.total(true), l.total(false), l.transformation(true), l.filters(false),
                      l.observer_counts.samples, l.light_counts.samples, l.visible};
}

// Several bands test the centres of a block that crosses their limits, each all of them.
void expect_as_many_centres(const raster::DrawCounts& one, const raster::DrawCounts& many) {
    EXPECT_GE(many.tested_centres, one.tested_centres);
    EXPECT_LE(many.tested_centres, max_workers * one.tested_centres);
}

void expect_same(const PlannedFrame& one, const PlannedFrame& many) {
    test::expect_equal_frames(one.frame.buffers, many.frame.buffers,
                        umbra78::test::Constant::expected);
    const FrameCounts &a = one.frame.counts, &b = many.frame.counts;
    EXPECT_EQ(list(a.observer), list(b.observer));
    EXPECT_EQ(list(a.lights[0].map), list(b.lights[0].map));
    EXPECT_EQ(list(a.lights[0]), list(b.lights[0]));
    expect_as_many_centres(a.observer, b.observer);
    expect_as_many_centres(a.lights[0].map, b.lights[0].map);
    EXPECT_EQ(list(frame_ledger(one.inputs, one.frame.buffers, a)),
              list(frame_ledger(many.inputs, many.frame.buffers, b)));
}

// A frame that one worker draws, and what an executor's workers make of the same.
class DrawnByOne {
public:
    DrawnByOne(const PlannedScene& planned, bool all_work) : planned_(planned), one_(planned) {
        plan_ = all_work ? FramePlan{} : make_plan(one_.inputs);
        one_.draw(plan_);
    }
    void expect_same_from(const Executor& executor) const {
        PlannedFrame many(planned_, false, executor);
        many.draw(plan_);
        expect_same(one_, many);
    }

private:
    const PlannedScene& planned_;
    PlannedFrame one_;
    FramePlan plan_;
};

TEST(Workers, AnyNumberDrawsTheSameFrame) {
    std::size_t parts = 0;
    for (PlannedScene& planned : test::planned_scenes()) {
        SCOPED_TRACE(planned.name);
        if (umbra78::test::sanitized) planned.settings.machine.xy_bits = 5;
        for (const bool all_work : {false, true}) {
            if (umbra78::test::sanitized && all_work) break;
            const DrawnByOne one(planned, all_work);
            Shuffled two(2), seven(7), sixty_four(max_workers);
            for (Shuffled* workers : {&seven, &two, &sixty_four}) {
                one.expect_same_from(workers->executor());
                parts += workers->parts();
                if (umbra78::test::sanitized || all_work) break;
            }
        }
        if (HasFailure()) return;
    }
    EXPECT_GT(parts, umbra78::test::sanitized ? 500u : 10000u) << "the work is shared";
}

TEST(Workers, ThreadsDrawTheSameFrame) {
    if (umbra78::test::sanitized) GTEST_SKIP() << "guard_threads has ThreadSanitizer";
    Threads three(3), seven(7);
    for (PlannedScene& planned : test::planned_scenes()) {
        SCOPED_TRACE(planned.name);
        const DrawnByOne frame(planned, false);
        for (Threads* threads : {&three, &seven}) {
            frame.expect_same_from(threads->executor());
            if (HasFailure()) break;
        }
        if (HasFailure()) return;
    }
}

// Facets go into stores of the workers' own, or where there are none into bands of the one store.
TEST(Workers, NeedNoStoresOfTheirOwn) {
    for (const char* name : {"kept normals", "same view, back"}) {
        const PlannedScene planned = test::planned_scene(name);
        PlannedFrame one(planned);
        Shuffled workers(3);
        PlannedFrame many(planned, false, workers.executor());
        many.frame.buffers.worker_depth = {};
        one.draw(FramePlan{});
        many.draw(FramePlan{});
        expect_same(one, many);
    }
}

// The frame that was there before is kept where the plan says so, whoever draws the rest.
TEST(Workers, KeepWhatTheFrameBeforeLeft) {
    const PlannedScene before = test::planned_scene("kept normals");
    PlannedScene now = before;
    now.materials[0].shininess = 3;
    Shuffled workers(4);
    PlannedFrame one(before), many(before, false, workers.executor());
    for (PlannedFrame* f : {&one, &many}) {
        const FrameInputs old = f->inputs;
        f->draw(make_plan(old));
        f->inputs.scene = now.scene();
        const FramePlan plan = make_plan(f->inputs, &old);
        EXPECT_TRUE(plan.leaves_out(Omission::same_depth));
        f->draw(plan);
    }
    expect_same(one, many);
}

TEST(Workers, AreNoMoreThanTheFrameWasCarvedFor) {
    const PlannedScene planned = test::planned_scene("figure 6");
    Shuffled two(2);
    PlannedFrame frame(planned, false, two.executor());
    frame.frame.buffers.executor.workers = 3;
    EXPECT_DEATH(frame.draw(FramePlan{}), "fewer workers");
    FrameShape shape;
    shape.workers = max_workers + 1;
    EXPECT_DEATH(test::Frame<>(planned.settings.machine, 1, shape), "too many");
}

// --- how the work is cut -------------------------------------------------------------------------

TEST(Census, CutsBandsOfAboutEqualWork) {
    raster::Census census;
    hw::MachineSpec spec;  // 512 lines, so eight a strip
    for (std::size_t k = 16; k < 48; ++k) census.pixels[k] = 10;
    std::array<hw::Band, 4> bands;
    ASSERT_EQ(raster::cut_bands(census, spec, bands), 4u);
    EXPECT_EQ(bands[0].first, 0);
    EXPECT_EQ(bands[0].end, 24 * 8);
    EXPECT_EQ(bands[1].end, 32 * 8);
    EXPECT_EQ(bands[2].end, 40 * 8);
    EXPECT_EQ(bands[3].end, 512);
    for (std::size_t k = 1; k < 4; ++k) EXPECT_EQ(bands[k].first, bands[k - 1].end);
    spec.xy_bits = 4;  // 16 lines, so four strips each
    for (std::size_t workers = 1; workers <= 4; ++workers) {
        const std::size_t n = raster::cut_bands(census, spec, std::span(bands).first(workers));
        EXPECT_EQ(bands[0].first, 0);
        EXPECT_EQ(bands[n - 1].end, 16);
    }
    ASSERT_EQ(raster::cut_bands({}, spec, bands), 1u) << "nothing to draw";
    EXPECT_EQ(bands[0].end, 16);
}

TEST(Census, IsOfThePixelsThatAreDrawn) {
    const PlannedScene planned = test::planned_scene("figure 6");
    PlannedFrame frame(planned);
    const FrameInputs& in = frame.inputs;
    frame.draw(FramePlan{});
    const raster::Census census =
        raster::take_census(planned.patches, draw_setup(in, FramePlan{},
                                                        in.matrices.world_to_observer),
                            *frame.frame.buffers.draw);
    EXPECT_TRUE(census.splits_suffice);
    const int size = in.settings.machine.size_px();
    const LineSet visible = lines_with_visible<hw::Depth16>(
        frame.frame.buffers.observer.depth, size, in.settings.machine.background());
    std::uint64_t all = 0;
    for (int y = 0; y < size; ++y)
        if (visible.has(y)) {
            EXPECT_GT(census.pixels[static_cast<std::size_t>(y * 64 / size)], 0u) << "line " << y;
        }
    for (const std::uint64_t n : census.pixels) all += n;
    EXPECT_GT(all, frame.frame.counts.observer.samples);
    EXPECT_LT(all, 4 * frame.frame.counts.observer.samples);
}

// A line through the eye uses up its splits. It is drawn by one worker, and so as by one alone.
TEST(Census, SeesAPatchThatUsesUpItsSplits) {
    if (umbra78::test::sanitized) GTEST_SKIP() << "a million splits, one like the other";
    PlannedScene planned = test::planned_figure("through the eye", 3);
    planned.settings.machine.coefficient_bits = 24;
    planned.settings.machine.xy_bits = 4;
    raster::View& view = planned.observer;
    view.projection = raster::Projection::perspective;
    view.distance = 5 << 16;
    view.extent = 1;
    view.near_depth = 1;
    view.far_depth = 20 << 16;
    planned.patches = {raster::plane_patch({{0, 0, 6 << 16}, {0, 0, -(2 << 16)}, {}, 0}),
                       raster::plane_patch({{-(7 << 16), -(7 << 16), 4 << 16}, {14 << 16, 0, 0},
                                            {0, 14 << 16, 0}, 0})};
    Shuffled workers(3);
    PlannedFrame one(planned), many(planned, false, workers.executor());
    one.draw(FramePlan{});
    many.draw(FramePlan{});
    EXPECT_GE(one.frame.counts.observer.splits, raster::max_splits);
    expect_same(one, many);
}

}  // namespace
}  // namespace umbra78::shadow
