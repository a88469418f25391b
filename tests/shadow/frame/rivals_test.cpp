// The rivals as forms of a frame: one mask from all of them, whatever is left out, and what they
// refuse.
#include "shadow/frame/rivals.hpp"

#include "shadow/frame/costs.hpp"
#include "shadow/rivals/depth_code.hpp"
#include "tests/shadow/frame/equal_frames.hpp"
#include "tests/shadow/frame/planned_scenes.hpp"
#include "tests/shadow/frame/variant_scenes.hpp"
#include "tests/shadow/rivals/scenes.hpp"
#include "tests/support/effort.hpp"

#include <gtest/gtest.h>

#include <vector>

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
    const std::vector<const char*> scenes{"floor", "figure 6", "point light"};
    for (const char* name : scenes) {
        if (umbra78::test::sanitized && name != scenes[0]) break;
        const std::vector<std::uint8_t> expected = mask_of(with_form(name, Form::brute));
        const auto dark = std::count(expected.begin(), expected.end(), mask_shadow);
        EXPECT_GT(dark, 300) << name;
        EXPECT_LT(dark, static_cast<std::ptrdiff_t>(expected.size())) << name;
        for (const Form form : rival_forms()) {
            if (!is_exact(form)) continue;
            EXPECT_EQ(mask_of(with_form(name, form)), expected)
                << name << ", " << static_cast<int>(form);
        }
    }
}

// Volumes in the frame store, whose codes may be too coarse for them.
TEST(RivalForms, StencilsHaveOneMaskThatNeedsTheCodes) {
    const struct {
        const char* name;
        int at_16_bits, at_6_bits;
    } scenes[] = {{"figure 6", 0, 34}, {"point light", 0, 25}, {"floor", 2, 8}};
    for (const auto& [name, at_16_bits, at_6_bits] : scenes) {
        for (const int z_bits : {16, 6}) {
            const auto mask = [&, scene = name, z_bits](Form form) {
                PlannedScene planned = with_form(scene, form);
                planned.settings.machine.z_bits = z_bits;
                return mask_of(planned);
            };
            const std::vector<std::uint8_t> right = mask(Form::brute);
            const std::vector<std::uint8_t> pass = mask(Form::stencil_pass);
            EXPECT_EQ(pass, mask(Form::stencil_fail)) << name;
            int wrong = 0;
            for (std::size_t at = 0; at < right.size(); ++at) wrong += pass[at] != right[at];
            EXPECT_EQ(wrong, z_bits == 16 ? at_16_bits : at_6_bits) << name;
        }
    }
}

// Counting what lies behind the visible surface takes the volumes' far ends, too.
TEST(RivalForms, CountingBehindTakesMore) {
    const auto accesses = [](Form form) {
        const PlannedScene planned = with_form("floor", form);
        PlannedFrame f(planned);
        f.draw(make_plan(f.inputs));
        const LightCounts& c = f.frame.counts.lights[0];
        return c.method_once.accesses + c.method_frame.accesses;
    };
    EXPECT_GT(accesses(Form::stencil_fail), accesses(Form::stencil_pass));
}

// A rival's codes are on the scale of the observer's store. They are not the same everywhere: a
// facet's vertices are rounded otherwise, and the machine dices a patch by its own levels.
TEST(RivalForms, TheirCodesAreTheStores) {
    for (const char* name : {"figure 6", "perspective", "floor"}) {
        PlannedScene planned = with_form(name, Form::brute);
        planned.settings.surface = raster::PatchForm::diced;
        planned.settings.machine.z_bits = 12;
        PlannedFrame f(planned);
        f.draw(FramePlan{});
        rivals::test::Memory memory(rival_bytes(f.inputs));
        const RivalView view = rival_view(f.inputs, 0, memory.bytes());
        const rivals::Space& space = view.setting.space;
        const rivals::DepthScale scale = rivals::depth_scale(f.inputs.scene.observer, space, 12);
        std::array<int, 3> off{};
        int pixels = 0;
        for (std::size_t at = 0; at < view.shown.size(); ++at) {
            const hw::Depth16 drawn = f.frame.buffers.observer.depth[at];
            if (view.shown[at] == rivals::nothing_seen || drawn == scale.background()) continue;
            const rivals::PlaneCodes codes(view.setting.planes[view.shown[at]], space, scale);
            const auto size = static_cast<std::size_t>(space.size_px());
            const std::uint32_t code = codes.at(space.centre(static_cast<int>(at % size)),
                                                space.centre(static_cast<int>(at / size)));
            ++pixels;
            ++off[std::min<std::size_t>(2, code > drawn ? code - drawn : drawn - code)];
        }
        EXPECT_GT(pixels, 6000) << name;
        EXPECT_GT(off[0], pixels * 9 / 10) << name << ": equal";
        EXPECT_LE(off[2], 1) << name << ": two codes off or more";
    }
}

TEST(RivalForms, LeavingOutChangesNothing) {
    for (const Form form : rival_forms()) {
        PlannedScene planned = with_form("figure 6", form);
        if (umbra78::test::sanitized) planned.settings.dice_levels = 1;
        PlannedFrame all(planned), f(planned);
        all.draw(FramePlan{});
        f.draw(make_plan(f.inputs));
        test::expect_equal_frames(all.frame.buffers, f.frame.buffers);
    }
}

// Too little memory is a status with the number of bytes that suffice, or that bring it further.
TEST(RivalForms, SayHowMuchTheyNeed) {
    for (const Form form : rival_forms()) {
        PlannedScene planned = with_form("figure 6", form);
        if (umbra78::test::sanitized) planned.settings.dice_levels = 1;
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

// A light with an area is many lights, whose masks have a mean (Brotman & Badler 1984), whatever
// makes the masks.
TEST(RivalForms, AnAreasDarknessIsTheMeanOfItsMasks) {
    const test::VariantScene made("floor");
    const Scene area = made.scene("oblique", "panel");
    const auto n = static_cast<int>(area.light_count);
    ASSERT_EQ(n, 4);
    for (const Form form : {Form::volumes, Form::ordered_volumes, Form::stencil_fail}) {
        Settings s = figure_settings(6);
        s.machine.xy_bits = 6;
        s.form = form;
        s.dice_levels = 2;
        const test::Memory room(std::size_t{1} << 24);
        const auto drawn = [&](const Scene& scene) {
            test::Frame<> frame(s.machine, scene.patches.size(), FrameShape(scene, s));
            frame.buffers.method_memory = room.span();
            EXPECT_EQ(frame.draw(scene, s), FrameStatus::ok);
            EXPECT_TRUE(frame.counts.lights[0].capacity.enough);
            return frame;
        };
        const auto all = drawn(area);
        std::vector<int> sums(all.buffers.pixels());
        for (std::size_t l = 0; l < area.light_count; ++l) {
            Scene one = area;
            one.light_count = one.sources[0].lights = 1;
            one.lights[0] = area.lights[l];
            const auto alone = drawn(one);
            for (std::size_t at = 0; at < sums.size(); ++at)
                sums[at] += alone.buffers.lights[0].mask[at];
        }
        int grey = 0;
        for (std::size_t at = 0; at < sums.size(); ++at) {
            const int mean = (2 * sums[at] + n) / (2 * n);
            ASSERT_EQ(all.buffers.lights[0].joined[at], mean) << at;
            grey += mean > 0 && mean < 255 ? 1 : 0;
        }
        EXPECT_GT(grey, 20);
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
