// The shadow test together with the times of the parts that carry it out: what the clocked forms
// and the memory replay read.
#pragma once

#include "hw/clocked/timing.hpp"
#include "shadow/shadow_test.hpp"

namespace umbra78::shadow {

struct TimedTest : ShadowTest {
    hw::Timing timing{};
};

}  // namespace umbra78::shadow
