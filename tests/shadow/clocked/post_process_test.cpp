// The clocked machine against the functional one: bits equal under any stalls, cycles explained to
// the last one, and a fault in one handshake found.
#include "shadow/clocked/post_process_impl.hpp"

#include "tests/shadow/clocked/clocked_frames.hpp"
#include "tests/shadow/frame/figure_frame.hpp"
#include "tests/support/buffers.hpp"
#include "tests/support/effort.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace umbra78::shadow {
namespace {

using test::OwnedStore;
using test::Random;
using test::describe;
using test::maps_of;

template <class Depth, class Rule = hw::ValidReady>
using Clocked = ClockedPostProcess<Depth, Rule>;

Settings random_machine(Random& random) {
    Settings s = test::random_settings(random, false);
    s.machine.xy_bits = static_cast<int>(random.between(4, 6));
    s.machine.multipliers = test::pick(random, {1, 4, 16});
    s.machine.divide_order = test::pick(random, {hw::DivideOrder::exact,
                                                 hw::DivideOrder::round_first});
    hw::Timing& t = s.timing;
    t.divider = test::pick(random, {hw::Divider::serial, hw::Divider::pipelined});
    t.light_banks = test::pick(random, {1, 4});
    t.noise_bits = test::pick(random, {1, 7, 24, 64, 192, 1024});
    t.clock_ns = test::pick(random, {100, 150, 200, 1000});
    t.multiply_ns = test::pick(random, {1, 160, 400});
    t.add_ns = test::pick(random, {1, 60, 150});
    t.register_ns = test::pick(random, {0, 20, 40});
    EXPECT_TRUE(can_be_built(s));
    return s;
}

// Every cycle of every stage is one of four things, and of the reader one of five.
template <class Depth>
void expect_every_cycle_accounted(const Clocked<Depth>& machine) {
    EXPECT_EQ(machine.account().total(), machine.cycles());
    std::uint64_t blamed = 0;
    for (int k = 0; k < machine.chain().stages(); ++k) {
        const hw::StageTime& t = machine.chain().time(k);
        EXPECT_EQ(t.work, machine.counts().visible *
                              static_cast<std::uint64_t>(machine.chain().stay(k)));
        EXPECT_LE(t.work + t.stalled(), machine.cycles());
        std::uint64_t by = 0;
        for (int j = 0; j < machine.chain().stages(); ++j) by += machine.chain().blocked_by(k, j);
        EXPECT_EQ(by, t.blocked);
        blamed += machine.reader_blocked_by(k);
    }
    EXPECT_EQ(blamed, machine.reader().blocked);
    const auto pixels = static_cast<std::uint64_t>(machine.pixels());
    EXPECT_EQ(machine.reader().read, pixels * std::uint64_t(machine.plan().read_cycles));
}

// A frame of one visible pixel, the first, whose reader is held in the cycles given.
struct Tail {
    std::uint64_t cycles;
    CycleAccount account;
};
Tail run_tail(std::size_t visible, const std::vector<std::uint64_t>& held) {
    const Settings s = figure_settings(3);  // S = 3, L = 10, a pixel a cycle
    Settings small = s;
    small.machine.xy_bits = 4;
    OwnedStore<hw::Depth16> observer(4), light(4);
    observer.store.clear(small.machine);
    light.store.clear(small.machine);
    if (visible < observer.depth.size()) observer.depth[visible] = 1000;
    std::vector<std::uint8_t> mask(256);
    const auto machine = std::make_unique<Clocked<hw::Depth16>>(maps_of(observer, light),
                                                                hw::MatrixWords{}, small, mask);
    while (!machine->done() && machine->cycles() < 10000) {
        const bool hold = std::find(held.begin(), held.end(), machine->cycles()) != held.end();
        machine->tick(hold ? Clocked<hw::Depth16>::reader_bit : 0);
    }
    return {machine->cycles(), machine->account()};
}

// What the reader was held after the last point has left it counts, as far as the point's own way
// does not cover it; what it was held before counts by itself.
TEST(ClockedPostProcess, HeldCyclesAfterTheLastPointAreAccountedFor) {
    struct Case {
        std::size_t visible;
        std::vector<std::uint64_t> held;
        std::uint64_t closed_form, reader_held, after_last;
    };
    for (const Case& c : {
             Case{0, {}, 256, 0, 0},               // 255 background pixels outlast the latency
             Case{0, {0}, 256, 1, 0},              // held before the point is let go
             Case{0, {0, 1, 9}, 256, 2, 1},        // both
             Case{0, {100, 101, 102}, 256, 0, 3},  // held in the tail
             Case{0, {255, 256}, 256, 0, 2},       // in its last cycle, and in the one that adds
             Case{255, {}, 266, 0, 0},             // the last pixel: L = 10 cycles are left
             Case{255, {300}, 266, 0, 0},          // the frame is over
             Case{250, {}, 261, 0, 0},             // 5 background pixels are within the latency
             Case{250, {252, 253}, 261, 0, 0},     // 7 still are
             Case{250, {251, 252, 253, 254, 255}, 261, 0, 0},        // 10: just within
             Case{250, {251, 252, 253, 254, 255, 256}, 261, 0, 1},   // 11: one too many
             Case{250, {3, 252, 253, 254, 255, 256, 257}, 261, 1, 1},
             Case{256, {}, 256, 0, 0},             // nothing visible
             Case{256, {0, 17, 255, 258}, 256, 4, 0},
         }) {
        const Tail t = run_tail(c.visible, c.held);
        SCOPED_TRACE("visible " + std::to_string(c.visible) + ", " +
                     std::to_string(c.held.size()) + " cycles held");
        EXPECT_EQ(t.account.closed_form, c.closed_form);
        EXPECT_EQ(t.account.reader_held, c.reader_held);
        EXPECT_EQ(t.account.reader_blocked, 0u);
        EXPECT_EQ(t.account.after_last, c.after_last);
        EXPECT_EQ(t.cycles, c.closed_form + c.reader_held + c.after_last);
    }
}

struct Trial {
    std::uint64_t points = 0, cycles = 0, stalled = 0, shadowed = 0;
};

// One frame, clocked under the holds, against the functional form and the oracle.
template <class Depth>
void run_trial(Random& random, const Settings& s, const OwnedStore<Depth>& observer,
               const OwnedStore<Depth>& light, const hw::MatrixWords& matrix, unsigned in_64,
               Trial& sum) {
    std::vector<std::uint8_t> expected(observer.depth.size(), 3), mask(expected.size(), 5);
    const PostProcessCounts counts =
        post_process(maps_of(observer, light), matrix, s, expected);
    const auto machine =
        std::make_unique<Clocked<Depth>>(maps_of(observer, light), matrix, s, mask);
    const std::vector<hw::StageMask> holds = test::random_holds(
        random, machine->chain().stages(), observer.depth.size() * 4, in_64);
    const test::SlowStages stages = test::slow_stages(s, matrix.affine);
    ASSERT_EQ(machine->chain().stages(), static_cast<int>(stages.stays.size()));
    for (int k = 0; k < machine->chain().stages(); ++k)
        ASSERT_EQ(machine->chain().stay(k), stages.stays[static_cast<std::size_t>(k)]) << k;
    ASSERT_EQ(machine->plan().read_cycles, stages.read_cycles);
    ASSERT_EQ(machine->plan().slot_cycles, stages.slot_cycles);
    ASSERT_EQ(machine->plan().latency, stages.latency());
    const std::vector<std::int64_t> writes = test::clock_frame(*machine, holds);
    ASSERT_TRUE(machine->done()) << "hangs";
    EXPECT_EQ(machine->counts().visible, counts.visible);
    EXPECT_EQ(machine->counts().shadowed, counts.shadowed);
    if (mask != expected)
        umbra78::test::expect_equal_buffers("mask", s.machine.size_px(), expected, mask);
    std::uint64_t cycles = 0;
    EXPECT_EQ(writes, test::predicted_writes(stages, observer.depth, s.machine.background(),
                                             holds, cycles));
    EXPECT_EQ(machine->cycles(), cycles);
    EXPECT_EQ(machine->account().closed_form,
              test::slow_closed_form(stages, observer.depth, s.machine.background()));
    expect_every_cycle_accounted(*machine);
    sum.points += counts.visible;
    sum.cycles += machine->cycles();
    sum.stalled += machine->cycles() - machine->account().closed_form;
    sum.shadowed += counts.shadowed;
}

// Any widths, roundings, units and clocks; free, now and then held, held most of the time.
TEST(ClockedPostProcess, AnyMachineUnderAnyStalls) {
    Random random;
    Trial sum;
    for (int round = 0; round < umbra78::test::effort(600); ++round) {
        const Settings s = random_machine(random);
        SCOPED_TRACE("round " + std::to_string(round) + " " + describe(s));
        OwnedStore<hw::Depth32> observer(s.machine.xy_bits), light(s.machine.xy_bits);
        test::fill_depth(random, s.machine, observer.depth);
        test::fill_depth(random, s.machine, light.depth);
        const hw::MatrixWords matrix =
            test::random_matrix(random, s.machine, random.bits() % 2 == 0);
        const unsigned in_64 = test::pick(random, {0u, 0u, 4u, 20u, 56u});
        run_trial<hw::Depth32>(random, s, observer, light, matrix, in_64, sum);
        if (HasFailure()) return;
    }
    EXPECT_GT(sum.shadowed, umbra78::test::sanitized ? 1000u : 10000u);
    EXPECT_GT(sum.stalled, sum.cycles / 50) << "too few stalls";
}

// The figures' machine: a million points of noise under random stalls.
TEST(ClockedPostProcess, AMillionPointsUnderRandomStalls) {
    Random random;
    Trial sum;
    const test::FigureScene figures;
    for (int round = 0; sum.points < std::uint64_t(umbra78::test::effort(1'000'000)); ++round) {
        Settings s = figure_settings(round % 2 == 0 ? 3 : 4);
        OwnedStore<hw::Depth16> observer(9), light(9);
        for (hw::Depth16& z : observer.depth) z = static_cast<hw::Depth16>(random.bits());
        for (hw::Depth16& z : light.depth) z = static_cast<hw::Depth16>(random.bits());
        FrameMatrices matrices;
        ASSERT_EQ(load_matrices(figures.scene(), s, matrices), FrameStatus::ok);
        run_trial<hw::Depth16>(random, s, observer, light, matrices.lights[0].observer_to_light,
                               16, sum);
        if (HasFailure()) return;
    }
    std::cout << sum.points << " points in " << sum.cycles << " cycles, " << sum.stalled
              << " of them for stalls\n";
}

// Without holds nothing blocks, and a frame takes its closed form.
TEST(ClockedPostProcess, FiguresTakeTheirClosedForm) {
    const test::FigureScene figures;
    for (const int figure : {3, 4}) {
        const Settings s = figure_settings(figure);
        test::Frame<> frame(figures.scene(), s);
        std::vector<std::uint8_t> mask(frame.buffers.lights[0].mask.size());
        const auto machine = std::make_unique<Clocked<hw::Depth16>>(
            frame.buffers.maps(), frame.matrices.lights[0].observer_to_light, s, mask);
        if (figure == 3)
            machine->run();
        else
            while (!machine->done()) machine->tick();
        umbra78::test::expect_equal_buffers("mask", 512, frame.buffers.lights[0].mask, mask);
        const Schedule plain = schedule<hw::Depth16>(
            frame.buffers.observer.depth, s.machine.background(), machine->plan().read_cycles,
            machine->plan().slot_cycles);
        EXPECT_EQ(machine->cycles(), plain.cycles(machine->plan().latency));
        EXPECT_EQ(machine->reader().blocked, 0u);
        for (int k = 0; k < machine->chain().stages(); ++k)
            EXPECT_EQ(machine->chain().time(k).stalled(), 0u) << k;
        std::cout << "figure " << figure << ": " << machine->cycles() << " cycles, a point every "
                  << machine->plan().slot_cycles << ", " << machine->plan().latency
                  << " on its way\n";
    }
}

// What the reader waited for is the stage that kept it: the first one where its own clock is held,
// a later one where it is that one's.
TEST(ClockedPostProcess, TheReadersWaitsAreBlamedOnTheStageThatKeptIt) {
    for (const int stage : {0, 1, 4, 6}) {
        Settings s = figure_settings(3);
        s.machine.xy_bits = 4;
        OwnedStore<hw::Depth16> observer(4), light(4);
        std::fill(observer.depth.begin(), observer.depth.end(), hw::Depth16{1000});
        light.store.clear(s.machine);
        std::vector<std::uint8_t> mask(256);
        const auto machine = std::make_unique<Clocked<hw::Depth16>>(maps_of(observer, light),
                                                                    hw::MatrixWords{}, s, mask);
        while (!machine->done()) {
            const bool hold = machine->cycles() >= 100 && machine->cycles() < 200;
            machine->tick(hold ? hw::StageMask{1} << stage : 0);
        }
        EXPECT_GT(machine->reader().blocked, 50u) << stage;
        for (int k = 0; k < machine->chain().stages(); ++k)
            EXPECT_EQ(machine->reader_blocked_by(k), k == stage ? machine->reader().blocked : 0u)
                << "held " << stage << ", blamed " << k;
    }
}

// --- planted faults -----------------------------------------------------------------------------

// Stage `Where` moves on although the next stage is full: a point is written over.
template <int Where>
struct IgnoresReady {
    static constexpr bool moves(int stage, bool next_full, bool next_held) {
        return stage == Where ? !next_held : !next_full && !next_held;
    }
};
// Stage `Where` moves into a stage whose clock is held.
template <int Where>
struct IgnoresHold {
    static constexpr bool moves(int stage, bool next_full, bool next_held) {
        return stage == Where ? !next_full : !next_full && !next_held;
    }
};

// Whether the checks above would fail.
template <class Rule>
bool found() {
    Random random;
    Settings s = figure_settings(4);
    s.machine.xy_bits = 5;
    const test::FigureScene figures;
    OwnedStore<hw::Depth16> observer(5), light(5);
    for (hw::Depth16& z : observer.depth) z = static_cast<hw::Depth16>(random.bits());
    for (hw::Depth16& z : light.depth) z = static_cast<hw::Depth16>(random.bits());
    FrameMatrices matrices;
    EXPECT_EQ(load_matrices(figures.scene(), s, matrices), FrameStatus::ok);
    std::vector<std::uint8_t> expected(1024), mask(1024);
    const PostProcessCounts counts =
        post_process(maps_of(observer, light), matrices.lights[0].observer_to_light, s, expected);
    const auto machine = std::make_unique<Clocked<hw::Depth16, Rule>>(
        maps_of(observer, light), matrices.lights[0].observer_to_light, s, mask);
    const auto holds = test::random_holds(random, machine->chain().stages(), 16384, 32);
    const auto writes = test::clock_frame(*machine, holds, 8 * holds.size());
    std::uint64_t cycles = 0;
    const auto predicted = test::predicted_writes(test::slow_stages(s, true), observer.depth,
                                                  s.machine.background(), holds, cycles);
    return !machine->done() || mask != expected || machine->counts().shadowed != counts.shadowed ||
           writes != predicted || machine->cycles() != cycles;
}

TEST(ClockedPostProcess, PlantedFaultsAreFound) {
    EXPECT_FALSE(found<hw::ValidReady>()) << "without a fault there is nothing to be found";
    EXPECT_TRUE(found<IgnoresReady<0>>());
    EXPECT_TRUE(found<IgnoresReady<3>>());
    EXPECT_TRUE(found<IgnoresReady<5>>());
    EXPECT_TRUE(found<IgnoresHold<1>>());
    EXPECT_TRUE(found<IgnoresHold<6>>());
}

}  // namespace
}  // namespace umbra78::shadow
