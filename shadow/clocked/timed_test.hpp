// The shadow test together with the times of the parts that carry it out: what the clocked forms
// and the memory replay read.
#pragma once

#include "fixed/trap.hpp"
#include "hw/clocked/timing.hpp"
#include "shadow/depth_maps.hpp"
#include "shadow/shadow_test.hpp"

namespace umbra78::shadow {

struct TimedTest : ShadowTest {
    hw::Timing timing{};
};

// The test, if its widths and times are in their ranges.
inline const TimedTest& checked(const TimedTest& test) {
    check_machine(test.machine);
    fixed::require(hw::check(test.timing) == hw::TimingStatus::ok,
                   "clocked post-process: a part's time is out of its range");
    return test;
}

}  // namespace umbra78::shadow
