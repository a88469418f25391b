// The rivals as forms of a frame: one mask from all of them, whatever is left out, and what they
// refuse.
#include "shadow/frame/rivals.hpp"

#include "shadow/frame/costs.hpp"
#include "tests/shadow/frame/equal_frames.hpp"
#include "tests/shadow/frame/planned_scenes.hpp"

#include <gtest/gtest.h>

namespace umbra78::shadow {
namespace {

using test::PlannedFrame;
using test::PlannedScene;

std::vector<Form> rival_forms() {
    std::vector<Form> forms;
    for (const Method& m : methods())
        if (is_rival(m.form)) forms.push_back(m.form);
    return forms;
}

PlannedScene with_form(const char* scene, Form form) {
    PlannedScene planned = test::planned_scene(scene);
    planned.settings.form = form;
    planned.settings.dice_levels = 2;
    return planned;
}

std::vector<std::uint8_t> mask_of(const PlannedScene& planned) {
    PlannedFrame f(planned);
    f.draw(make_plan(f.inputs));
    const auto mask = f.frame.buffers.lights[0].mask;
    return {mask.begin(), mask.end()};
}

// With a light at infinity and at a place, an observer without and with an eye, and meshes.
TEST(RivalForms, HaveOneMask) {
    EXPECT_GE(rival_forms().size(), 2u);
    for (const char* name : {"figure 6", "point light", "floor"}) {
        const std::vector<std::uint8_t> expected = mask_of(with_form(name, Form::brute));
        const auto dark = std::count(expected.begin(), expected.end(), mask_shadow);
        EXPECT_GT(dark, 300) << name;
        EXPECT_LT(dark, static_cast<std::ptrdiff_t>(expected.size())) << name;
        for (const Form form : rival_forms())
            EXPECT_EQ(mask_of(with_form(name, form)), expected)
                << name << ", " << static_cast<int>(form);
    }
}

TEST(RivalForms, LeavingOutChangesNothing) {
    for (const Form form : rival_forms()) {
        const PlannedScene planned = with_form("figure 6", form);
        PlannedFrame all(planned), f(planned);
        all.draw(FramePlan{});
        f.draw(make_plan(f.inputs));
        test::expect_equal_frames(all.frame.buffers, f.frame.buffers);
    }
}

// Too little memory is a status with the number of bytes that suffice, or that bring it further.
TEST(RivalForms, SayHowMuchTheyNeed) {
    for (const Form form : rival_forms()) {
        const PlannedScene planned = with_form("figure 6", form);
        PlannedFrame f(planned);
        std::size_t bytes = frame_alignment;
        int turns = 0;
        do {
            f.make_room(bytes);
            draw_frame(f.inputs, make_plan(f.inputs), f.frame.buffers, f.frame.counts);
            const Capacity& c = f.frame.counts.lights[0].capacity;
            if (c.enough) break;
            ASSERT_GT(c.needed, bytes);
            bytes = c.needed;
        } while (++turns < 9);
        EXPECT_GT(turns, 0);
        EXPECT_LT(turns, 9);
        const auto mask = f.frame.buffers.lights[0].mask;
        EXPECT_EQ(std::vector<std::uint8_t>(mask.begin(), mask.end()), mask_of(planned));
    }
}

TEST(RivalForms, RefuseWhatTheyCannotDo) {
    PlannedScene planned = with_form("figure 6", Form::volumes);
    Scene scene = planned.scene();
    FrameMatrices matrices;
    EXPECT_EQ(load_matrices(scene, planned.settings, matrices), FrameStatus::ok);
    Scene streamed = scene;
    streamed.streamed = true;
    EXPECT_EQ(load_matrices(streamed, planned.settings, matrices), FrameStatus::rival_of_stream);
    // So near that the scene is wider than 2^21 half pixels.
    Scene near = scene;
    near.observer.extent = 2;
    EXPECT_NE(load_matrices(near, planned.settings, matrices), FrameStatus::ok);
}

TEST(RivalForms, CostWhatTheyCount) {
    const PlannedScene planned = with_form("figure 6", Form::volumes);
    PlannedFrame f(planned);
    const FramePlan plan = make_plan(f.inputs);
    f.draw(plan);
    const FrameLedger l = frame_ledger(f.inputs, f.frame.buffers, f.frame.counts);
    const LightCounts& counted = f.frame.counts.lights[0];
    EXPECT_EQ(l.light.units.side_by_side(), 0u) << "there is no light's view";
    EXPECT_EQ(l.test.operations.accesses, counted.method_frame.accesses);
    EXPECT_EQ(l.scene.operations.adds, counted.method_once.adds);
    EXPECT_EQ(cycles_of(plan, {f.inputs, l})[2].operations.store, l.test.units.store);
}

}  // namespace
}  // namespace umbra78::shadow
