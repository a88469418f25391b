// How many stages each step takes, against a table for the ends of what is legal and against
// counting clocks; and which timings are legal.
#include "hw/clocked/timing.hpp"

#include <gtest/gtest.h>

#include <ostream>

namespace umbra78::hw {
namespace {

struct Stages {
    int multiply, sum, accumulate, round, divide_bits;
    friend bool operator==(const Stages&, const Stages&) = default;
    friend std::ostream& operator<<(std::ostream& out, const Stages& s) {
        return out << s.multiply << ' ' << s.sum << ' ' << s.accumulate << ' ' << s.round << ' '
                   << s.divide_bits;
    }
};

Stages stages_of(const Timing& t) {
    return {t.multiply_stages(), t.sum_stages(), t.accumulate_stages(), t.round_stages(),
            t.divide_bits_a_stage()};
}

// By hand, from the parts: a sum is two levels of adders, rounding a shifter and an increment.
TEST(Timing, StagesByHand) {
    struct Case {
        int clock_ns, multiply_ns, add_ns, register_ns;
        Stages expected;
    };
    for (const Case& c : {
             Case{200, 160, 60, 20, {1, 1, 1, 1, 3}},    // the default: 180 ns of room
             Case{100, 160, 60, 20, {2, 2, 1, 2, 1}},    // 80 ns
             Case{100, 400, 150, 40, {7, 5, 3, 5, 1}},   // 60 ns, the slowest legal parts
             Case{100, 400, 150, 0, {4, 3, 2, 3, 1}},    // 100 ns: multiply fits exactly
             Case{139, 400, 100, 39, {4, 2, 1, 2, 1}},   // 100 ns: so do sum and accumulate
             Case{138, 400, 100, 39, {5, 3, 2, 3, 1}},   // 99 ns: and here nothing does
             Case{100, 1, 1, 40, {1, 1, 1, 1, 60}},      // the fastest parts
             Case{140, 160, 60, 20, {2, 1, 1, 1, 2}},    // 120 ns: two additions exactly
             Case{139, 160, 60, 20, {2, 2, 1, 2, 1}},    // 119 ns
         }) {
        Timing t;
        t.clock_ns = c.clock_ns;
        t.multiply_ns = c.multiply_ns;
        t.add_ns = c.add_ns;
        t.register_ns = c.register_ns;
        EXPECT_EQ(check(t), TimingStatus::ok);
        EXPECT_EQ(stages_of(t), c.expected) << "clock " << c.clock_ns << ", add " << c.add_ns;
    }
}

// The stages that work takes, by taking a clock's room off it until nothing is left.
int counted(int work_ns, const Timing& t) {
    int stages = 0;
    for (; work_ns > 0; ++stages) work_ns -= t.clock_ns - t.register_ns;
    return stages;
}

TEST(Timing, StagesAreTheClocksThatTheWorkTakes) {
    Timing t;
    for (t.clock_ns = 100; t.clock_ns <= 320; t.clock_ns += 10) {
        for (t.register_ns = 0; t.register_ns <= 40; t.register_ns += 5) {
            for (t.add_ns = 1; t.add_ns <= 150; ++t.add_ns) {
                t.multiply_ns = 2 * t.add_ns + 100;
                const int add = counted(t.add_ns, t), two = counted(2 * t.add_ns, t);
                int bits = 0;
                while ((bits + 1) * t.add_ns <= t.clock_ns - t.register_ns) ++bits;
                const Stages expected{counted(t.multiply_ns, t), two, add, two,
                                      bits < 1 ? 1 : bits};
                ASSERT_EQ(stages_of(t), expected) << t.clock_ns << ' ' << t.register_ns << ' '
                                                  << t.add_ns;
            }
        }
    }
}

// Every range at both ends and one beyond.
TEST(Timing, Ranges) {
    struct Case {
        int Timing::*value;
        int min, max;
        TimingStatus status;
    };
    for (const Case& c : {
             Case{&Timing::clock_ns, 100, INT32_MAX, TimingStatus::part_too_slow},
             Case{&Timing::multiply_ns, 1, 400, TimingStatus::part_too_slow},
             Case{&Timing::add_ns, 1, 150, TimingStatus::part_too_slow},
             Case{&Timing::register_ns, 0, 40, TimingStatus::part_too_slow},
             Case{&Timing::noise_bits, 1, INT32_MAX, TimingStatus::noise_bits},
         }) {
        Timing t;
        for (const int legal : {c.min, c.max}) {
            t.*c.value = legal;
            EXPECT_EQ(check(t), TimingStatus::ok) << legal;
        }
        t.*c.value = c.min - 1;
        EXPECT_EQ(check(t), c.status) << c.min - 1;
        if (c.max == INT32_MAX) continue;
        t.*c.value = c.max + 1;
        EXPECT_EQ(check(t), c.status) << c.max + 1;
    }
    for (int banks = -1; banks <= 5; ++banks) {
        Timing t;
        t.light_banks = banks;
        EXPECT_EQ(check(t) == TimingStatus::ok, banks == 1 || banks == 4) << banks;
    }
}

}  // namespace
}  // namespace umbra78::hw
