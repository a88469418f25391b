// The times of the machine's parts, and the numbers of pipeline stages that follow from them.
//
//   stages = ceil(work_ns / (clock_ns - register_ns))
//
// The times in nanoseconds are those of the parts. A stage lasts one clock, of which its register
// takes some, so a step that takes longer than the rest is cut into more stages. Bits never depend
// on any of this. Sources and assumptions are in shadow/frame/profiles.cpp and in hw/MACHINE.md,
// section 16. `check` says which value is out of range.
#pragma once

#include "hw/memory/dram_timing.hpp"

#include <cstdint>

namespace umbra78::hw {

// One divider for three quotients, a quotient bit a clock; or three dividers, cut into stages.
enum class Divider : std::uint8_t { serial, pipelined };

struct Timing {
    int clock_ns = 200;
    int multiply_ns = 160;  // a 16 x 16-bit product
    int add_ns = 60;        // accumulator-wide, with look-ahead carry
    int register_ns = 20;   // set-up and delay of a stage's register
    Divider divider = Divider::serial;
    int noise_bits = 192;   // bits that the noise register advances in a clock
    int light_banks = 1;    // light-map words read in one clock: 1, or 2 x 2 interleaved banks
    DramTiming dram{};      // of the frame stores' chips: for the replay, not for the stages

    // Stages for work of `work_ns` nanoseconds.
    constexpr int stages(int work_ns) const {
        const int room = clock_ns - register_ns;
        return (work_ns + room - 1) / room;
    }
    constexpr int multiply_stages() const { return stages(multiply_ns); }
    constexpr int sum_stages() const { return stages(2 * add_ns); }  // four products, two levels
    constexpr int accumulate_stages() const { return stages(add_ns); }
    constexpr int round_stages() const { return stages(2 * add_ns); }  // shifter, then increment
    // Quotient bits of a pipelined divider's stage: a subtraction each.
    constexpr int divide_bits_a_stage() const {
        const int n = (clock_ns - register_ns) / add_ns;
        return n < 1 ? 1 : n;
    }
};

enum class TimingStatus : std::uint8_t { ok, part_too_slow, noise_bits, light_banks };

// Slower parts would need more stages than a chain has (hw/clocked/handshake.hpp).
constexpr TimingStatus check(const Timing& t) {
    if (t.clock_ns < 100 || t.register_ns < 0 || t.register_ns > 40 || t.multiply_ns < 1 ||
        t.multiply_ns > 400 || t.add_ns < 1 || t.add_ns > 150)
        return TimingStatus::part_too_slow;
    if (t.noise_bits < 1) return TimingStatus::noise_bits;
    if (t.light_banks != 1 && t.light_banks != 4) return TimingStatus::light_banks;
    return TimingStatus::ok;
}

// The legal parts that need the most stages in every step.
inline constexpr Timing slowest_legal{.clock_ns = 100, .multiply_ns = 400, .add_ns = 150,
                                      .register_ns = 40};
static_assert(check(slowest_legal) == TimingStatus::ok, "the slowest legal parts are legal");

static_assert(Timing{}.multiply_stages() == 1 && Timing{}.sum_stages() == 1 &&
                  Timing{}.accumulate_stages() == 1 && Timing{}.round_stages() == 1 &&
                  Timing{}.divide_bits_a_stage() == 3,
              "1978's parts fit a clock of 200 ns, one stage each");

}  // namespace umbra78::hw
