// Frames for the clocked post-process: random stalls, and an oracle for its cycles that never
// ticks: a recurrence over points and stages. The stages are hw/MACHINE.md's, section 16; nothing
// is taken from the machine under test.
#pragma once

#include "shadow/clocked/post_process.hpp"
#include "tests/shadow/random_frames.hpp"
#include "tests/shadow/slow_point.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace umbra78::shadow::test {

// Which clocks are held in which cycle: each stage with a probability of its own, now and then for
// a long while. Cycles past the end are free.
inline std::vector<hw::StageMask> random_holds(Random& random, int stages, std::size_t cycles,
                                               unsigned in_64) {
    std::vector<hw::StageMask> holds(cycles, 0);
    for (int k = 0; k <= stages; ++k) {
        const hw::StageMask bit = hw::StageMask{1} << (k == stages ? 63 : k);
        const std::uint64_t often = in_64 == 0 ? 0 : random.bits() % in_64;
        for (std::size_t t = 0; t < cycles; ++t) {
            if (random.bits() % 64 >= often) continue;
            const std::size_t length = random.bits() % 16 == 0 ? random.bits() % 40 : 1;
            for (std::size_t i = t; i < std::min(t + length, cycles); ++i) holds[i] |= bit;
        }
    }
    return holds;
}

// Section 16's table: the stays of all stages in order, the reader's cycles a pixel, and the
// cycles from one visible pixel to the next.
struct SlowStages {
    std::vector<int> stays;
    int read_cycles = 1, slot_cycles = 1;

    int latency() const { return std::accumulate(stays.begin(), stays.end(), 0); }
};
inline SlowStages slow_stages(const TimedTest& s, bool affine) {
    const hw::MachineSpec& m = s.machine;
    const hw::Timing& t = s.timing;
    const auto ceil = [](int a, int b) { return (a + b - 1) / b; };
    const auto stages = [&](int work_ns) { return ceil(work_ns, t.clock_ns - t.register_ns); };
    SlowStages out;
    const auto add = [&](int count, int stay) {
        for (int k = 0; k < count; ++k) out.stays.push_back(stay);
    };
    const int word_bits = m.xy_bits + std::max(m.z_bits - m.xy_bits, 1);
    const int passes = (m.coefficient_bits > 16 ? 2 : 1) * (word_bits > 16 ? 2 : 1);
    const int rows = affine ? 3 : 4;
    const int rounds = m.multipliers == 1 ? rows * rows : m.multipliers == 4 ? rows : 1;
    add(1, passes * rounds);  // multiply
    add(stages(t.multiply_ns) - 1, 1);
    if (m.multipliers > 1) add(stages(2 * t.add_ns), 1);  // sum
    add(stages(t.add_ns), 1);                             // accumulate
    if (affine || m.divide_order == hw::DivideOrder::round_first) add(stages(2 * t.add_ns), 1);
    const int n_f = m.xy_bits + m.fraction_bits;
    if (!affine && t.divider == hw::Divider::serial) add(1, 2 * (n_f + 4) + m.z_bits + 4);
    if (!affine && t.divider == hw::Divider::pipelined)
        add(2 + ceil(std::max(n_f, m.z_bits) + 2,
                     std::max(1, (t.clock_ns - t.register_ns) / t.add_ns)), 1);
    const bool blends = s.lookup == Lookup::bilinear && m.fraction_bits > 0;
    const bool percentage = s.lookup == Lookup::percentage;
    const bool filters = s.lookup == Lookup::filtered_depth;
    const int side = percentage || filters ? s.taps : blends ? 2 : 1;
    const bool jittered = (percentage || filters) && s.tap_places == TapPlaces::jittered;
    const int fetch = t.light_banks == 4 && !jittered ? ceil(side, 2) * ceil(side, 2) : side * side;
    add(1, 1);                                  // place
    add(1, fetch);
    if (blends) add(1, ceil(6, m.multipliers));  // interpolate
    if (filters) add(1, fetch);                 // sum
    add(1, percentage ? fetch : 1);             // compare
    add(1, 1);                                  // write
    const int bits = 16 * SlowNoise::bytes(s.dither.shape);
    out.read_cycles = bits == 0 ? 1 : ceil(bits, t.noise_bits);
    if (jittered) out.read_cycles = std::max(out.read_cycles, ceil(16 * side * side, t.noise_bits));
    out.slot_cycles = *std::max_element(out.stays.begin(), out.stays.end());
    return out;
}

// When a frame ends, by the rules of valid and ready alone: point by point, stage by stage.
class CycleOracle {
public:
    CycleOracle(std::vector<int> stays, int read_cycles, int slot_cycles,
                const std::vector<hw::StageMask>& holds)
        : stays_(std::move(stays)), read_(static_cast<std::uint64_t>(read_cycles)),
          slot_(static_cast<std::uint64_t>(slot_cycles)), holds_(holds),
          left_(stays_.size(), -1) {}

    // One pixel in scan order; the cycle in which its mask word is written, or -1.
    std::int64_t pixel(bool visible) {
        ++gap_;
        if (!visible) return -1;
        const std::uint64_t wait = first_ ? read_ * gap_ : std::max(slot_, read_ * gap_);
        std::int64_t t = after(issued_, 63, wait);
        while (held(63, t) || held(0, t) || left_[0] > t) ++t;
        issued_ = t;
        first_ = false;
        gap_ = 0;
        for (std::size_t k = 0; k < stays_.size(); ++k) {
            const int stage = static_cast<int>(k);
            t = after(t, stage, static_cast<std::uint64_t>(stays_[k]));
            const bool last = k + 1 == stays_.size();
            while (held(stage, t) || (!last && (held(stage + 1, t) || left_[k + 1] > t))) ++t;
            left_[k] = t;
        }
        return t;
    }
    // Cycles of the frame.
    std::uint64_t cycles() const {
        const std::int64_t scan = gap_ == 0 ? issued_ : after(issued_, 63, read_ * gap_);
        return static_cast<std::uint64_t>(std::max(scan, left_.back()) + 1);
    }

private:
    bool held(int bit, std::int64_t t) const {
        const auto at = static_cast<std::size_t>(t);
        return at < holds_.size() && (holds_[at] >> bit & 1) != 0;
    }
    // The cycle that is the n-th free one of that clock after cycle t.
    std::int64_t after(std::int64_t t, int bit, std::uint64_t n) const {
        while (n > 0)
            if (!held(bit, ++t)) --n;
        return t;
    }

    std::vector<int> stays_;
    std::uint64_t read_, slot_;
    const std::vector<hw::StageMask>& holds_;
    std::vector<std::int64_t> left_;  // the cycle in which the last point left each stage
    std::int64_t issued_ = -1;
    std::uint64_t gap_ = 0;
    bool first_ = true;
};

// Clocks a frame to its end; the cycles in which mask words were written.
template <class Machine>
std::vector<std::int64_t> clock_frame(Machine& machine, const std::vector<hw::StageMask>& holds,
                                      std::uint64_t max_cycles = 100'000'000) {
    std::vector<std::int64_t> writes;
    const int last = machine.chain().stages() - 1;
    while (!machine.done() && machine.cycles() < max_cycles) {
        const std::uint64_t t = machine.cycles(), before = machine.chain().time(last).work;
        machine.tick(t < holds.size() ? holds[t] : 0);
        if (machine.chain().time(last).work != before)
            writes.push_back(static_cast<std::int64_t>(t));
    }
    return writes;
}

// The same by the oracle, and the frame's cycles.
template <class Depth>
std::vector<std::int64_t> predicted_writes(const SlowStages& stages,
                                           const std::vector<Depth>& depth,
                                           std::uint32_t background,
                                           const std::vector<hw::StageMask>& holds,
                                           std::uint64_t& cycles) {
    CycleOracle oracle(stages.stays, stages.read_cycles, stages.slot_cycles, holds);
    std::vector<std::int64_t> writes;
    for (const Depth code : depth)
        if (const std::int64_t t = oracle.pixel(code != background); t >= 0) writes.push_back(t);
    cycles = oracle.cycles();
    return writes;
}

// Section 16's closed form of a frame without holds: T = 1 + I + max(L, p g).
template <class Depth>
std::uint64_t slow_closed_form(const SlowStages& stages, const std::vector<Depth>& depth,
                               std::uint32_t background) {
    const auto p = static_cast<std::uint64_t>(stages.read_cycles);
    const auto slot = static_cast<std::uint64_t>(stages.slot_cycles);
    const auto latency = static_cast<std::uint64_t>(stages.latency());
    std::uint64_t issue = 0, gap = 0;
    bool first = true;
    for (const Depth code : depth) {
        if (code == background) {
            ++gap;
            continue;
        }
        issue += first ? p * (gap + 1) - 1 : std::max(slot, p * (gap + 1));
        first = false;
        gap = 0;
    }
    if (first) return p * gap;
    return 1 + issue + std::max(latency, p * gap);
}

}  // namespace umbra78::shadow::test
