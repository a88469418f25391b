// Valid and ready: a chain of stages, a token in each, clocked by tick().
//
//            +---------+  valid   +---------+  valid   +---------+
//   enter -->| stage 0 |--------->| stage 1 |--------->|   ...   |--> done
//            +---------+<---------+---------+<---------+---------+
//                         ready                 ready
//
// A token works in a stage for the stage's `stay` cycles. At the end of a cycle it moves on if its
// work is done (valid) and the next stage is empty or empties in this very cycle (ready); else it
// waits, and so, in time, does what follows it. A stage whose clock is held in a cycle (`held`, a
// bit a stage: memory that is late, or a test that makes trouble) does nothing in it and takes
// nothing in. Results cannot depend on any of this; cycles are accounted for to the last one.
//
// The chain carries slot numbers alone; what a token holds is its user's, who is called with
// work(stage, cycle of the stay, slot).
#pragma once

#include "fixed/trap.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <string_view>

namespace umbra78::hw {

inline constexpr int max_stages = 63;
using StageMask = std::uint64_t;  // a bit a stage; bit 63 is whoever feeds the chain

// What a stage did with its cycles; whatever is left of the total it was empty.
struct StageTime {
    std::uint64_t work = 0;
    std::uint64_t blocked = 0;  // done, and the next stage not ready
    std::uint64_t held = 0;     // its clock was held with a token in it
    std::uint64_t stalled() const { return blocked + held; }
};

// The handshake itself. A test plants a fault by another rule.
struct ValidReady {
    static constexpr bool moves(int /*stage*/, bool next_full, bool next_held) {
        return !next_full && !next_held;
    }
};

template <class Rule = ValidReady>
class Chain {
public:
    static constexpr std::int8_t none = -1;

    // Adds a stage; returns its number.
    int add(std::string_view name, int stay = 1) {
        fixed::require(count_ < max_stages && stay >= 1, "chain: 63 stages of one cycle or more");
        stage_[index(count_)] = {name, stay, 0, none, none};
        return count_++;
    }

    int stages() const { return count_; }
    std::string_view name(int k) const { return stage_[index(k)].name; }
    int stay(int k) const { return stage_[index(k)].stay; }
    int slot(int k) const { return stage_[index(k)].slot; }           // none: a bubble
    bool valid(int k) const { return slot(k) >= 0 && stage_[index(k)].left == 0; }
    bool ready(int k) const { return (full_ >> k & 1) == 0; }
    bool empty() const { return full_ == 0; }
    const StageTime& time(int k) const { return time_[index(k)]; }
    // Cycles stage k was blocked for want of stage `by`.
    std::uint64_t blocked_by(int k, int by) const { return blame_[index(k)][index(by)]; }
    // The stage that keeps stage k from taking a token: itself at work or held, or one behind it.
    int culprit(int k) const { return culprit_[index(k)]; }

    // Cycles the token was blocked or held since it entered.
    std::uint64_t waited(int slot) const { return waited_[index(slot)]; }

    void enter(std::int8_t slot) {
        waited_[index(slot)] = 0;
        fill(0, slot);
    }

    // One cycle. Returns the slot that left the last stage, or none.
    template <class Work>
    std::int8_t tick(StageMask held, Work&& work) {
        std::int8_t out = none;
        for (StageMask left = full_; left != 0;) {
            const int k = 63 - std::countl_zero(left);
            left &= ~(StageMask{1} << k);
            const std::int8_t gone = run(k, held, work);
            if (gone != none) out = gone;
        }
        return out;
    }

private:
    struct Stage {
        std::string_view name;
        int stay, left;
        std::int8_t slot, blocker;  // the slot in it, and what kept it in the last cycle
    };
    static constexpr std::size_t index(int k) { return static_cast<std::size_t>(k); }

    void fill(int k, std::int8_t slot) {
        stage_[index(k)].slot = slot;
        stage_[index(k)].left = stage_[index(k)].stay;
        full_ |= StageMask{1} << k;
    }

    // From the last stage to the first, so that `full_` says what the next stage is at the cycle's
    // end.
    template <class Work>
    std::int8_t run(int k, StageMask held, Work&& work) {
        Stage& s = stage_[index(k)];
        StageTime& t = time_[index(k)];
        if ((held >> k & 1) != 0) {
            culprit_[index(k)] = static_cast<std::int8_t>(k);
            ++t.held;
            ++waited_[index(s.slot)];
            return none;
        }
        if (s.left > 0) {
            ++t.work;
            work(k, s.stay - s.left, s.slot);
            if (--s.left > 0) {
                culprit_[index(k)] = static_cast<std::int8_t>(k);
                return none;
            }
        } else {  // it was done before and could not go
            ++t.blocked;
            ++blame_[index(k)][index(s.blocker)];
            ++waited_[index(s.slot)];
        }
        return move(k, held);
    }

    std::int8_t move(int k, StageMask held) {
        Stage& s = stage_[index(k)];
        const int next = k + 1;
        const std::int8_t slot = s.slot;
        const bool next_full = (full_ >> next & 1) != 0, next_held = (held >> next & 1) != 0;
        if (next < count_ && !Rule::moves(k, next_full, next_held)) {
            s.blocker = next_full ? culprit_[index(next)] : static_cast<std::int8_t>(next);
            culprit_[index(k)] = s.blocker;
            return none;
        }
        s.slot = none;
        full_ &= ~(StageMask{1} << k);
        if (next == count_) return slot;
        fill(next, slot);
        return none;
    }

    int count_ = 0;
    StageMask full_ = 0;
    std::array<Stage, max_stages> stage_{};
    std::array<StageTime, max_stages> time_{};
    std::array<std::uint64_t, max_stages> waited_{};  // by slot
    std::array<std::int8_t, max_stages> culprit_{};
    std::array<std::array<std::uint64_t, max_stages>, max_stages> blame_{};
};

}  // namespace umbra78::hw
