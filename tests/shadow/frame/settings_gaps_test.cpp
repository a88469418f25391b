// Settings within their ranges of which no machine can be built.
#include "shadow/frame/methods.hpp"
#include "shadow/frame/settings.hpp"

#include <gtest/gtest.h>

namespace umbra78::shadow {
namespace {

// What the machine's checks refuse within the table's ranges.
TEST(SettingsTable, GapsAreRefused) {
    Settings s;
    EXPECT_TRUE(can_be_built(s));
    for (const int banks : {2, 3}) {
        s.timing.light_banks = banks;
        EXPECT_FALSE(can_be_built(s)) << banks;
    }
    s = {};
    s.timing.clock_ns = s.timing.register_ns;
    EXPECT_FALSE(can_be_built(s));
    s = {};
    s.machine.multipliers = 3;
    EXPECT_FALSE(can_be_built(s));
    s = {};
    s.arithmetic = Arithmetic::ap120b;
    EXPECT_TRUE(can_be_built(s));
    s.machine.z_bits = 17;
    EXPECT_FALSE(can_be_built(s)) << "the host sends 16 bits";
    s.machine.z_bits = 16;
    s.form = Form::correct;
    EXPECT_FALSE(can_be_built(s));
    for (const Receiver receiver : {Receiver::plane, Receiver::normal}) {
        s = {};
        s.receiver = receiver;
        EXPECT_TRUE(can_be_built(s));
        s.arithmetic = Arithmetic::ap120b;
        EXPECT_FALSE(can_be_built(s)) << "no pass over neighbours";
        s.arithmetic = Arithmetic::fixed;
        s.form = Form::correct;
        EXPECT_FALSE(can_be_built(s)) << "no finished store";
    }
}

}  // namespace
}  // namespace umbra78::shadow
