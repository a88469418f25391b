// Frames for the clocked post-process: random stalls, and an oracle for its cycles that never
// ticks: a recurrence over points and stages.
#pragma once

#include "shadow/clocked/post_process.hpp"
#include "tests/shadow/random_frames.hpp"

#include <algorithm>
#include <cstdint>
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
template <class Machine, class Depth>
std::vector<std::int64_t> foretell(const Machine& machine, const std::vector<Depth>& depth,
                                   std::uint32_t background,
                                   const std::vector<hw::StageMask>& holds,
                                   std::uint64_t& cycles) {
    std::vector<int> stays;
    for (int k = 0; k < machine.chain().stages(); ++k) stays.push_back(machine.chain().stay(k));
    CycleOracle oracle(stays, machine.plan().read_cycles, machine.plan().slot_cycles, holds);
    std::vector<std::int64_t> writes;
    for (const Depth code : depth)
        if (const std::int64_t t = oracle.pixel(code != background); t >= 0) writes.push_back(t);
    cycles = oracle.cycles();
    return writes;
}

}  // namespace umbra78::shadow::test
