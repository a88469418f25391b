// Broken preconditions of a frame: memory that does not fit, buffers of other widths. Each traps
// at the entry of carve or of a stage, before anything is written.
#include "shadow/frame/frame.hpp"

#include "tests/shadow/frame/figure_frame.hpp"

#include <gtest/gtest.h>

namespace umbra78::shadow {
namespace {

TEST(FrameDeathTest, MemoryThatDoesNotFit) {
    const hw::MachineSpec spec{.xy_bits = 5};
    const std::size_t bytes = frame_bytes<hw::Depth16>(spec, 3);
    const test::Memory memory(bytes + frame_alignment);
    const auto carved = [&](std::size_t from, std::size_t size, const hw::MachineSpec& m) {
        return carve<hw::Depth16>(memory.span().subspan(from, size), m, 3).picture.size();
    };
    EXPECT_EQ(carved(0, bytes, spec), 1024u);
    EXPECT_EQ(carved(frame_alignment, bytes, spec), 1024u);
    for (const std::size_t off : {1, 8, 32, 63}) EXPECT_DEATH(carved(off, bytes, spec), "") << off;
    EXPECT_DEATH(carved(0, bytes - 1, spec), "");
    EXPECT_DEATH(carved(0, bytes, {.xy_bits = 3}), "");
    EXPECT_DEATH(carved(0, bytes, {.xy_bits = 5, .z_bits = 27}), "");
}

// Frames of 32 x 32 pixels, asked for the stages of others.
class StageDeathTest : public testing::Test {
protected:
    StageDeathTest() { settings.machine.xy_bits = 5; }

    void expect_death(const char* why) {
        FrameInputs in{figures.scene(), asked, {}};
        ASSERT_EQ(load_matrices(in.scene, in.settings, in.matrices), FrameStatus::ok);
        const FramePlan plan;
        EXPECT_DEATH(draw_light(in, plan, frame.buffers, frame.counts), "") << why;
        EXPECT_DEATH(draw_observer(in, plan, frame.buffers, frame.counts), "") << why;
        EXPECT_DEATH(cast_shadows(in, plan, frame.buffers, frame.counts), "") << why;
        EXPECT_DEATH(filter_and_composite(in, plan, frame.buffers, frame.counts), "") << why;
    }

    test::FigureScene figures;
    Settings settings = figure_settings(6), asked = settings;
    test::Frame<> frame{hw::MachineSpec{.xy_bits = 5}, figures.patches.size()};
};

TEST_F(StageDeathTest, OtherWidths) {
    for (const int xy_bits : {4, 6, 9}) {
        asked.machine.xy_bits = xy_bits;
        expect_death("xy_bits");
    }
    asked = settings;
    asked.machine.z_bits = 17;
    expect_death("z_bits");
}

TEST_F(StageDeathTest, APlaneTooShort) {
    asked = settings;
    const FrameBuffers<hw::Depth16> whole = frame.buffers;
    LightBuffers<hw::Depth16>& light = frame.buffers.lights[0];
    for (std::span<std::uint8_t>* const plane :
         {&frame.buffers.picture, &frame.buffers.observer.intensity,
          &frame.buffers.observer.direct, &light.mask, &light.edges, &light.filtered}) {
        *plane = plane->first(1023);
        expect_death("a plane of bytes");
        frame.buffers = whole;
    }
    for (std::span<hw::Depth16>* const plane : {&frame.buffers.observer.depth, &light.map.depth}) {
        *plane = plane->first(1023);
        expect_death("a plane of Z");
        frame.buffers = whole;
    }
}

}  // namespace
}  // namespace umbra78::shadow
