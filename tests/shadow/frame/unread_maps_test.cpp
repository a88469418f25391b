// Maps that nothing reads: they are left empty, nothing else of the frame changes, and a frame that
// comes after and reads one draws it.
#include "shadow/frame/costs.hpp"
#include "tests/shadow/frame/equal_frames.hpp"
#include "tests/shadow/frame/planned_scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace umbra78::shadow {
namespace {

using test::PlannedFrame;
using test::PlannedScene;

bool is_empty(const PlannedFrame& f, std::size_t light) {
    const auto none = static_cast<hw::Depth16>(f.inputs.settings.machine.background());
    return std::ranges::all_of(f.frame.buffers.lights[light].map.depth,
                               [&](hw::Depth16 z) { return z == none; });
}

void shade_alone(PlannedFrame& f) { f.inputs.shows_maps = false; }

TEST(UnreadMaps, AreLeftEmptyAndNothingElseChanges) {
    int unread = 0;
    for (const PlannedScene& planned : test::planned_scenes()) {
        SCOPED_TRACE(planned.name);
        PlannedFrame all(planned), f(planned);
        shade_alone(f);
        const FramePlan plan = make_plan(f.inputs);
        all.draw(FramePlan{});
        f.draw(plan);
        const std::size_t lights = f.inputs.scene.light_count;
        for (std::size_t l = 0; l < lights; ++l) {
            if (plan.at(Omission::light_map, l).reason != Reason::outside_light) continue;
            ++unread;
            EXPECT_TRUE(plan.leaves_out(Omission::light_map, l));
            EXPECT_TRUE(plan.leaves_out(Omission::post_process, l)) << "nothing asks it";
            EXPECT_TRUE(is_empty(f, l));
            const auto& drawn = all.frame.buffers.lights[l].map.depth;
            std::ranges::copy(drawn, f.frame.buffers.lights[l].map.depth.begin());
        }
        test::expect_equal_frames(all.frame.buffers, f.frame.buffers,
                                  umbra78::test::Constant::expected);
    }
    EXPECT_GE(unread, 2);
}

TEST(UnreadMaps, AreKeptWhereTheyAreShown) {
    const PlannedScene planned = test::planned_scene("outside the light");
    PlannedFrame f(planned);
    f.draw(make_plan(f.inputs));
    EXPECT_FALSE(is_empty(f, 0));
}

// The observer turns to what the light shines on: the light and what casts stand still, but its
// map was not drawn before. Turned back, the map is kept, though nothing reads it.
TEST(UnreadMaps, AreDrawnWhenTheyAreRead) {
    const PlannedScene away = test::planned_scene("outside the light");
    PlannedScene at = away;
    at.observer.target = at.light.target;
    PlannedFrame f(away), fresh(at), now(at);
    shade_alone(f);
    shade_alone(now);
    f.draw(make_plan(f.inputs));
    EXPECT_TRUE(is_empty(f, 0));
    const FramePlan plan = make_plan(now.inputs, &f.inputs);
    EXPECT_FALSE(plan.leaves_out(Omission::same_light_map));
    const FrameInputs before = f.inputs;
    f.inputs = now.inputs;
    f.draw(plan);
    fresh.draw(FramePlan{});
    test::expect_equal_frames(fresh.frame.buffers, f.frame.buffers);
    PlannedFrame back(away);
    shade_alone(back);
    EXPECT_TRUE(make_plan(back.inputs, &f.inputs).leaves_out(Omission::same_light_map));
    // Had the map been shown, it would be there.
    FrameInputs shown = before;
    shown.shows_maps = true;
    EXPECT_TRUE(make_plan(now.inputs, &shown).leaves_out(Omission::same_light_map));
}

TEST(UnreadMaps, SaveTheirDrawing) {
    const PlannedScene planned = test::planned_scene("outside the light");
    PlannedFrame f(planned);
    shade_alone(f);
    const FramePlan plan = make_plan(f.inputs);
    f.draw(plan);
    const FrameLedger l = frame_ledger(f.inputs, f.frame.buffers, f.frame.counts);
    const DrawnFrame drawn{f.inputs, l};
    EXPECT_EQ(cycles_of(plan, drawn)[0].total(), 0u);
    EXPECT_GT(cycles_of(FramePlan{}, drawn)[0].total(), 10'000u);
}

}  // namespace
}  // namespace umbra78::shadow
