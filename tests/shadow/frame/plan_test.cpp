// The plan: what is left out changes no bit of any buffer, and what may not be left out is seen.
//
// Each scene is drawn with FramePlan{}, which leaves out nothing, and then with its plan, with each
// omission alone, and with each omission alone put back; all buffers must be the same.
#include "shadow/frame/plan.hpp"

#include "shadow/frame/frame.hpp"
#include "tests/shadow/frame/equal_frames.hpp"
#include "tests/shadow/frame/planned_scenes.hpp"
#include "tests/support/effort.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <set>
#include <string>

namespace umbra78::shadow {
namespace {

using test::equal_frames;
using test::expect_equal_frames;
using test::PlannedFrame;
using test::PlannedScene;

constexpr std::size_t first_standing = static_cast<std::size_t>(Omission::same_light_map);

FramePlan only(const FramePlan& plan, std::size_t omission) {
    FramePlan one = plan;
    for (std::size_t k = 0; k < omission_count; ++k)
        if (k != omission) one.at(static_cast<Omission>(k)).left_out = false;
    return one;
}

FramePlan put_back(FramePlan plan, std::size_t omission) {
    plan.at(static_cast<Omission>(omission)).left_out = false;
    return plan;
}

TEST(FramePlan, MapsAndMasksAreALightsFiltersASources) {
    std::array<int, 3> of{};
    for (std::size_t k = 0; k < omission_count; ++k)
        ++of[static_cast<std::size_t>(scope_of(static_cast<Omission>(k)))];
    EXPECT_EQ(of, (std::array{10, 6, 4})) << "of the frame, of a light, of a source";
    for (const Omission o : {Omission::light_map, Omission::post_process, Omission::same_light_map,
                             Omission::same_mask})
        EXPECT_EQ(scope_of(o), Scope::light);
    EXPECT_EQ(scope_of(Omission::composite), Scope::source);
    EXPECT_EQ(scope_of(Omission::same_picture), Scope::frame);
}

// --- leaving out --------------------------------------------------------------------------------

TEST(FramePlan, LeavingOutChangesNoBit) {
    std::set<std::size_t> seen;
    int frames = 0;
    for (PlannedScene& planned : test::planned_scenes()) {
        SCOPED_TRACE(planned.name);
        if (umbra78::test::sanitized) planned.settings.machine.xy_bits = 5;
        PlannedFrame expected(planned);
        const FrameInputs in = expected.inputs;
        expected.draw(FramePlan{});
        const FramePlan plan = make_plan(in);
        PlannedFrame got(planned);
        got.draw(plan);
        expect_equal_frames(expected.frame.buffers, got.frame.buffers,
                            umbra78::test::Constant::expected);  // some views are empty
        for (std::size_t k = 0; k < first_standing; ++k) {
            if (!plan.leaves_out(static_cast<Omission>(k))) continue;
            if (!seen.insert(k).second && umbra78::test::sanitized) continue;  // once is enough
            for (const FramePlan& variant : {only(plan, k), put_back(plan, k)}) {
                PlannedFrame other(planned);
                other.draw(variant);
                EXPECT_TRUE(equal_frames(expected.frame.buffers, other.frame.buffers))
                    << "omission " << k;
                ++frames;
            }
        }
    }
    std::printf("%d frames; omissions tried: %zu of %zu\n", frames, seen.size(), first_standing);
    EXPECT_EQ(seen.size(), first_standing) << "an omission no scene makes is not tested";
}

// The frame that leaves out nothing is the machine's: figure 6's, by its other way.
TEST(FramePlan, DoingEverythingIsTheSameFrame) {
    const test::FigureScene figures;
    for (const int figure : {3, 6}) {
        const Settings s = figure_settings(figure);
        const test::Frame<> expected(figures.scene(), s);
        test::Frame<> got(s.machine, figures.patches.size());
        draw_frame(FrameInputs{figures.scene(), s, expected.matrices}, FramePlan{}, got.buffers,
                   got.counts);
        expect_equal_frames(expected.buffers, got.buffers);
        EXPECT_EQ(got.counts.lights[0].post_process.visible, 512u * 512u);
        EXPECT_EQ(got.counts.lights[0].post_process.shadowed,
                  expected.counts.lights[0].post_process.shadowed);
    }
}

// Leaving out what is needed is seen by the same comparison, or it proves nothing.
TEST(FramePlan, AWrongOmissionIsSeen) {
    PlannedScene figure = test::planned_scenes().front();
    PlannedFrame expected(figure);
    expected.draw(FramePlan{});
    const FramePlan plan = make_plan(expected.inputs);
    for (const Omission wrong : {Omission::noise, Omission::light_map, Omission::post_process,
                                 Omission::dequantize, Omission::low_pass, Omission::composite,
                                 Omission::light_drawing,
                                 Omission::same_light_map, Omission::same_depth,
                                 Omission::same_observer, Omission::same_mask,
                                 Omission::same_picture}) {
        ASSERT_FALSE(plan.leaves_out(wrong)) << static_cast<int>(wrong);
        PlannedFrame got(figure);  // its memory is filled with other bytes
        FramePlan planted = plan;
        planted.at(wrong).left_out = true;
        got.draw(planted);
        EXPECT_FALSE(equal_frames(expected.frame.buffers, got.frame.buffers))
            << static_cast<int>(wrong);
    }
}

// --- reasons ------------------------------------------------------------------------------------

Reason reason(const PlannedScene& planned, Omission o) {
    return make_plan(PlannedFrame(planned).inputs).at(o).reason;
}

TEST(FramePlan, SaysWhy) {
    using enum Omission;
    const auto scene = [](const char* name) { return test::planned_scene(name); };
    EXPECT_EQ(reason(scene("figure 6"), divide), Reason::affine);
    EXPECT_EQ(reason(scene("figure 6"), noise), Reason::asked_for);
    EXPECT_EQ(reason(scene("figure 6"), post_process), Reason::may_shadow);
    EXPECT_EQ(reason(scene("figure 6"), light_map), Reason::may_shadow);
    EXPECT_EQ(reason(scene("figure 6"), same_light_map), Reason::no_frame_before);
    EXPECT_EQ(reason(scene("figure 3"), noise), Reason::dither_off);
    EXPECT_EQ(reason(scene("figure 3"), low_pass), Reason::no_passes);
    EXPECT_EQ(reason(scene("silent dither"), noise), Reason::dither_rounds_to_zero);
    EXPECT_EQ(reason(scene("point light"), divide), Reason::partly_affine);
    EXPECT_EQ(reason(scene("perspective"), w_row), Reason::partly_affine);
    EXPECT_EQ(reason(scene("perspective, point light"), divide), Reason::perspective);
    EXPECT_EQ(reason(scene("empty"), post_process), Reason::nothing_visible);
    EXPECT_EQ(reason(scene("no caster"), light_map), Reason::no_caster);
    EXPECT_EQ(reason(scene("no caster"), post_process), Reason::no_caster);
    EXPECT_EQ(reason(scene("no caster"), composite), Reason::nothing_shadowed);
    EXPECT_EQ(reason(scene("outside the light"), light_map), Reason::may_shadow);
    EXPECT_EQ(reason(scene("outside the light"), post_process), Reason::outside_light);
    EXPECT_EQ(reason(scene("outside a point light"), post_process), Reason::outside_light);
    EXPECT_EQ(reason(scene("no density"), composite), Reason::invisible_shadow);
    EXPECT_EQ(reason(scene("correct"), composite), Reason::shadow_in_shading);
    for (const Omission o : {background_pixels, empty_lines, noise, light_shading})
        EXPECT_EQ(reason(scene("ground"), o), Reason::shadow_drawn);
    EXPECT_EQ(reason(scene("ground"), light_drawing), Reason::masked_when_drawn);
    EXPECT_EQ(reason(scene("ground"), light_map), Reason::may_shadow);
    for (const char* name : {"ground, shadow beside the picture", "ground, below it"}) {
        EXPECT_EQ(reason(scene(name), light_map), Reason::no_shadow_in_view) << name;
        EXPECT_EQ(reason(scene(name), composite), Reason::nothing_shadowed) << name;
    }
    for (const Omission o : {background_pixels, empty_lines, lit_lines})
        EXPECT_EQ(reason(scene("correct"), o), Reason::tested_when_drawn);
    EXPECT_EQ(reason(scene("figure 6"), empty_lines), Reason::nothing_there);
    EXPECT_EQ(reason(scene("figure 6"), lit_lines), Reason::no_shadow_near);
    EXPECT_EQ(reason(scene("figure 6"), light_drawing), Reason::other_view);
    EXPECT_EQ(reason(scene("same view"), light_drawing), Reason::same_view);
    EXPECT_EQ(reason(scene("same eye"), light_drawing), Reason::same_view);
    EXPECT_EQ(reason(scene("same view, AP-120B"), light_drawing), Reason::same_view);
    EXPECT_EQ(reason(scene("same view, correct"), light_drawing), Reason::tested_when_drawn);
    EXPECT_EQ(reason(scene("same view, back"), light_drawing), Reason::other_map);
    EXPECT_EQ(reason(scene("figure 6"), outside_surfaces), Reason::none_outside);
    EXPECT_EQ(reason(scene("near, diced"), outside_surfaces), Reason::outside_view);
    EXPECT_EQ(reason(scene("diced, no caster"), light_map), Reason::no_caster);
}

// The faintest shadow, and each setting of a filter next to the one that leaves it out.
TEST(FramePlan, TheLeastThatIsAskedForIsNeeded) {
    PlannedScene faint = test::planned_scene("figure 6");
    faint.settings.density_q8 = 1;
    faint.settings.dequantize_passes = faint.settings.low_pass_passes = 1;
    EXPECT_EQ(reason(faint, Omission::composite), Reason::asked_for);
    EXPECT_EQ(reason(faint, Omission::dequantize), Reason::asked_for);
    EXPECT_EQ(reason(faint, Omission::low_pass), Reason::asked_for);
    PlannedFrame expected(faint), got(faint);
    expected.draw(FramePlan{});
    got.draw(make_plan(got.inputs));
    expect_equal_frames(expected.frame.buffers, got.frame.buffers);
    EXPECT_FALSE(std::equal(got.frame.buffers.picture.begin(), got.frame.buffers.picture.end(),
                            got.frame.buffers.observer.intensity.begin()))
        << "density 1/256 darkens something";
}

// What is left out of a part of the work is counted when the frame is done.
TEST(FramePlan, CountsWhatItDid) {
    const auto draw = [](const char* name, bool everything) {
        const PlannedScene planned = test::planned_scene(name);
        PlannedFrame f(planned);
        const FramePlan plan = make_plan(f.inputs);
        f.draw(everything ? FramePlan{} : plan);
        return f.frame.counts;
    };
    const FrameCounts near = draw("near, subdivided", false), all = draw("near, subdivided", true);
    const PlannedScene planned = test::planned_scene("near, subdivided");
    const OutsideSurfaces outside = make_plan(PlannedFrame(planned).inputs).outside;
    const auto sent = [](const raster::DrawCounts& c) { return c.patches + c.facets; };
    EXPECT_EQ(sent(all.observer), 256u);
    EXPECT_EQ(sent(near.observer), 256 - outside.observer);
    EXPECT_EQ(sent(near.lights[0].map), 256 - outside.light[0]);
    EXPECT_EQ(near.observer.samples, all.observer.samples);
    EXPECT_EQ(all.lights[0].filtered_lines, (FilteredLines{128, 256, 128}));
    EXPECT_EQ(draw("no shadow after all", false).lights[0].filtered_lines, FilteredLines{});
    EXPECT_EQ(draw("no shadow after all", false).lights[0].post_process.shadowed, 0u);
    const FilteredLines few = draw("shadow in few lines", false).lights[0].filtered_lines;
    EXPECT_GT(few.dequantize, 5u);
    EXPECT_EQ(few.composite, few.dequantize + 2 * 3) << "a run of lines, three passes";
    EXPECT_LT(few.composite, 100u);
    EXPECT_EQ(draw("same view", false).lights[0].map.patches, 0u);
}

TEST(FramePlan, CountsThePatchesOutside) {
    const auto outside = [](const char* name) {
        return make_plan(PlannedFrame(test::planned_scene(name)).inputs).outside;
    };
    EXPECT_EQ(outside("figure 6").light[0], 0u);
    EXPECT_EQ(outside("figure 6").observer, 0u);
    EXPECT_EQ(outside("no caster").light[0], 128u);
    EXPECT_EQ(outside("no caster").observer, 0u);
    EXPECT_EQ(outside("outside the light").light[0], 128u);
    EXPECT_EQ(outside("outside the light").observer, 32u);
}

// What a plan calls out of the light's reach is lit when it is drawn, for lights all over.
TEST(FramePlan, WhatIsOutOfReachIsLit) {
    fixed::test::Random random;
    int left_out = 0, shadowed = 0;
    const int rounds = umbra78::test::sanitized ? 20 : 60;
    for (int k = 0; k < rounds; ++k) {
        PlannedScene planned = test::planned_scene(k % 2 ? "figure 6" : "point light");
        planned.settings.machine.xy_bits = 5;
        planned.settings.form = k % 3 == 0 ? Form::correct : Form::post_process;
        planned.settings.registration = k % 5 == 0 ? Registration::index : Registration::centre;
        if (k % 7 < 3) planned.settings.surface = raster::PatchForm::diced;
        const auto place = [&] { return static_cast<std::int32_t>(random.between(-3, 3) << 16); };
        planned.light.target = {place(), place(), place()};
        if (k % 2) planned.light.extent = static_cast<std::int32_t>(random.between(1, 3) << 15);
        PlannedFrame expected(planned), got(planned);
        expected.draw(FramePlan{});
        const FramePlan plan = make_plan(expected.inputs);
        got.draw(plan);
        EXPECT_TRUE(equal_frames(expected.frame.buffers, got.frame.buffers)) << k;
        left_out += plan.leaves_out(Omission::post_process);
        shadowed += !plan.leaves_out(Omission::post_process);
    }
    std::printf("post-process left out %d times, needed %d times\n", left_out, shadowed);
    EXPECT_GT(left_out, rounds / 20);
    EXPECT_GT(shadowed, rounds / 20);
}

}  // namespace
}  // namespace umbra78::shadow
