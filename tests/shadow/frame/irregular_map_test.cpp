// The alias-free map in the machine's words: its depths are the surfaces' at the visible points
// themselves, and it is a form of a frame like any other.
#include "shadow/frame/irregular_map.hpp"

#include "tests/shadow/frame/equal_frames.hpp"
#include "tests/shadow/frame/planned_scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace umbra78::shadow {
namespace {

using test::PlannedFrame;
using test::PlannedScene;

PlannedScene at_points(const char* scene) {
    PlannedScene planned = test::planned_scene(scene);
    planned.settings.form = Form::irregular_map;
    planned.settings.bias_unit = BiasUnit::quanta;
    return planned;
}

struct Drawn {
    std::uint64_t visible = 0, dark = 0;
};

Drawn draw(const PlannedScene& planned) {
    PlannedFrame f(planned);
    f.draw(make_plan(f.inputs));
    const PostProcessCounts& counted = f.frame.counts.lights[0].post_process;
    const auto mask = f.frame.buffers.lights[0].mask;
    const auto dark = static_cast<std::uint64_t>(std::ranges::count(mask, mask_shadow));
    EXPECT_EQ(dark, counted.shadowed);
    return {counted.visible, dark};
}

// A light that looks as the observer does sees each visible point where the observer sees it, at
// the same depth: no point is in shadow, and with its code moved by one each is.
TEST(IrregularMap, SeesTheVisiblePointsThemselves) {
    for (const char* name : {"same view", "same eye"})
        for (const raster::PatchForm surface :
             {raster::PatchForm::catmull, raster::PatchForm::diced}) {
            PlannedScene planned = at_points(name);
            planned.settings.surface = surface;
            planned.settings.bias_q16 = 0;
            const Drawn equal = draw(planned);
            EXPECT_GT(equal.visible, 500u) << name;
            EXPECT_EQ(equal.dark, 0u) << name;
            planned.settings.bias_q16 = -(1 << 16);
            EXPECT_EQ(draw(planned).dark, equal.visible) << name;
        }
}

std::vector<std::uint8_t> mask_of(const PlannedScene& planned) {
    PlannedFrame f(planned);
    f.draw(make_plan(f.inputs));
    const auto mask = f.frame.buffers.lights[0].mask;
    return {mask.begin(), mask.end()};
}

// A texel's one depth is wrong by its slope on both sides; at the points themselves what is wrong
// is a few quanta, and a bias of some makes nearly nothing of it.
TEST(IrregularMap, NeedsNoTexelOfBias) {
    PlannedScene planned = at_points("figure 6");
    planned.settings.bias_q16 = 8 << 16;
    const auto own = mask_of(planned);
    planned.settings.form = Form::post_process;
    const auto texels = mask_of(planned);
    planned.settings.form = Form::brute;
    planned.settings.dice_levels = 4;
    const auto exact = mask_of(planned);
    const auto wrong = [&](const std::vector<std::uint8_t>& mask) {
        std::size_t count = 0;
        for (std::size_t at = 0; at < mask.size(); ++at) count += mask[at] != exact[at] ? 1 : 0;
        return count;
    };
    EXPECT_GT(wrong(texels), 3 * wrong(own));
    EXPECT_GT(wrong(own), 0u);
}

TEST(IrregularMap, LeavingOutChangesNothing) {
    for (const char* name : {"figure 6", "point light", "floor"}) {
        const PlannedScene planned = at_points(name);
        PlannedFrame all(planned), f(planned);
        all.draw(FramePlan{});
        f.draw(make_plan(f.inputs));
        test::expect_equal_frames(all.frame.buffers, f.frame.buffers);
    }
}

TEST(IrregularMap, CostsItsDrawingAndItsPoints) {
    const PlannedScene planned = at_points("figure 6");
    PlannedFrame f(planned);
    f.draw(make_plan(f.inputs));
    const LightCounts& counted = f.frame.counts.lights[0];
    const FrameLedger l = frame_ledger(f.inputs, f.frame.buffers, f.frame.counts);
    EXPECT_EQ(counted.method_entries, counted.post_process.visible) << "all lie in the volume";
    EXPECT_GT(counted.map.samples, counted.post_process.visible);
    EXPECT_GT(l.test.operations.adds, counted.method_frame.adds);
    EXPECT_EQ(l.light.units.side_by_side(), 0u);
}

TEST(IrregularMap, EachLightHasItsOwnCosts) {
    const PlannedScene planned = at_points("floor");
    PlannedFrame f(planned);
    f.draw(make_plan(f.inputs));
    FrameCounts counts = f.frame.counts;
    counts.lights[1] = counts.lights[0];
    counts.lights[1].method_frame.adds += 1000;
    FrameMatrices matrices = f.inputs.matrices;
    matrices.lights[1] = matrices.lights[0];
    const FrameInputs in{f.inputs.scene, f.inputs.settings, matrices};
    FrameLedger first{}, second{};
    cost_of_irregular_map(in, 0, f.frame.buffers, counts, first);
    cost_of_irregular_map(in, 1, f.frame.buffers, counts, second);
    EXPECT_EQ(second.test.operations.adds, first.test.operations.adds + 1000);
}

}  // namespace
}  // namespace umbra78::shadow
