// The watch reports the same no matter when it is attached, and the reader's pixel is the one
// released.
#include "tools/watch/machine_watch.hpp"

#include "tests/support/effort.hpp"
#include "tests/tools/watch/traced.hpp"

#include <gtest/gtest.h>

namespace umbra78::tools {
namespace {

using test::Random;
using Watch = MachineWatch<hw::Depth32>;

void expect_same(const StageCycle& early, const StageCycle& late) {
    EXPECT_EQ(early.point, late.point);
    EXPECT_EQ(early.step, late.step);
    EXPECT_EQ(early.activity, late.activity);
    EXPECT_EQ(early.valid, late.valid);
    EXPECT_EQ(early.ready, late.ready);
}

TEST(MachineWatch, AttachedLateItReportsTheSame) {
    Random random;
    std::uint64_t released = 0;
    for (int round = 0; round < umbra78::test::effort(100); ++round) {
        const auto frame = test::random_frame(random, test::random_machine(random));
        const auto machine = frame->machine();
        const int stages = machine->chain().stages(), bits = frame->settings().machine.xy_bits;
        Watch early(*machine);
        const auto holds = shadow::test::random_holds(random, stages, 600, 16);
        for (std::size_t t = 0; t < 300; ++t) early.tick(holds[t]);
        // Two machines are in the same state; one is watched from here on only.
        const auto twin = frame->machine();
        for (std::size_t t = 0; t < 300; ++t) twin->tick(holds[t]);
        Watch late(*twin);
        for (std::size_t t = 300; t < 600; ++t) {
            early.tick(holds[t]);
            late.tick(holds[t]);
            for (int k = 0; k < stages; ++k) expect_same(early.stage(k), late.stage(k));
            const ReaderCycle& r = late.reader();
            EXPECT_EQ(r.released, early.reader().released);
            EXPECT_EQ(r.pixel, early.reader().pixel);
            if (r.released == 0) continue;
            const shadow::PointRegisters& f = twin->flight(twin->chain().slot(0));
            EXPECT_EQ(r.pixel, (std::size_t(f.py) << bits) + std::size_t(f.px));
            EXPECT_EQ(r.code, f.code);
            ++released;
        }
        if (HasFailure()) return;
    }
    EXPECT_GT(released, std::uint64_t(umbra78::test::effort(100)));
}

}  // namespace
}  // namespace umbra78::tools
