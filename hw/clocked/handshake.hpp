// A chain of stages with a valid/ready handshake: a token in each stage, clocked by tick().
//
//            +---------+  valid   +---------+  valid   +---------+
//   enter -->| stage 0 |--------->| stage 1 |--------->|   ...   |--> done
//            +---------+<---------+---------+<---------+---------+
//                         ready                 ready
//
// A token works in a stage for the stage's `stay` cycles. At the end of a cycle it moves on if its
// work is done (valid) and the next stage is empty or empties in the same cycle (ready). Otherwise
// it waits, and then the tokens that follow it wait, too. The clock of a stage can be held for a
// cycle (`held`, a bit a stage: memory that is late, or a test that disturbs the chain): the stage
// then does nothing and takes no token. Results do not depend on any of this, and each cycle of
// each stage is counted as work, blocked, held or empty.
//
// The chain carries slot numbers only. Its user keeps what a token holds, and is called with
// work(stage, cycle of the stay, slot).
// In: at most 63 stages of 1 cycle or more (else a broken precondition), and slots 0..63: a token
// in each stage and one that waits to enter.
#pragma once

#include "fixed/trap.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <string_view>
#include <type_traits>

namespace umbra78::hw {

inline constexpr int max_stages = 63;
using StageMask = std::uint64_t;  // a bit a stage; bit 63 is for what feeds the chain

// The stages without tokens and counters: 1.5 KB, where a chain has 36 KB. It is enough to ask
// which stages a machine has; a unit adds its stages to either.
class StageList {
public:
    // Adds a stage; returns its number.
    int add(std::string_view name, int stay = 1) {
        fixed::require(count_ < max_stages && stay >= 1, "chain: 63 stages of one cycle or more");
        stage_[static_cast<std::size_t>(count_)] = {name, stay};
        return count_++;
    }
    int stages() const { return count_; }
    std::string_view name(int k) const { return stage_[static_cast<std::size_t>(k)].name; }
    int stay(int k) const { return stage_[static_cast<std::size_t>(k)].stay; }

private:
    struct Stage {
        std::string_view name;
        int stay;
    };
    std::array<Stage, max_stages> stage_{};
    int count_ = 0;
};

// What a stage did with its cycles; in the rest of the total it was empty.
struct StageTime {
    std::uint64_t work = 0;
    std::uint64_t blocked = 0;  // done, and the next stage not ready
    std::uint64_t held = 0;     // its clock was held while it had a token
    std::uint64_t stalled() const { return blocked + held; }
};

// The handshake's rule. A test plants a fault by another rule.
struct ValidReady {
    static constexpr bool moves(int /*stage*/, bool next_full, bool next_held) {
        return !next_full && !next_held;
    }
};

template <class Rule = ValidReady>
class Chain {
public:
    static constexpr std::int8_t none = -1;  // the slot of an empty stage

    // Adds a stage; returns its number.
    int add(std::string_view name, int stay = 1) {
        const int k = list_.add(name, stay);
        stage_[index(k)].stay = stay;
        return k;
    }

    int stages() const { return list_.stages(); }
    std::string_view name(int k) const { return list_.name(k); }
    int stay(int k) const { return list_.stay(k); }
    int slot(int k) const { return stage_[index(k)].slot; }
    bool valid(int k) const { return slot(k) >= 0 && stage_[index(k)].left == 0; }
    bool ready(int k) const { return (full_ >> k & 1) == 0; }
    bool empty() const { return full_ == 0; }
    const StageTime& time(int k) const { return time_[index(k)]; }
    // Cycles that stage k was blocked because of stage `by`.
    std::uint64_t blocked_by(int k, int by) const { return blame_[index(k)][index(by)]; }
    // The stage that keeps stage k from taking a token: k itself where it works or is held, else
    // a later one.
    int culprit(int k) const { return stage_[index(k)].culprit; }

    // Cycles that the token was blocked or held since it entered.
    std::uint64_t waited(int slot) const { return waited_[index(slot)]; }

    // Puts a token into stage 0, which must be ready.
    void enter(std::int8_t slot) {
        waited_[index(slot)] = 0;
        fill(0, slot, full_);
    }

    // One cycle. Returns the slot that left the last stage, or none.
    template <class Work>
    [[gnu::always_inline]] std::int8_t tick(StageMask held, Work&& work) {
        // In most cycles no clock is held, and then nothing asks for it.
        return held == 0 ? run_all(std::integral_constant<StageMask, 0>{}, work)
                         : run_all(held, work);
    }

private:
    struct Stage {
        int stay = 0, left = 0;                   // cycles of work, and those that are left
        std::int8_t slot = none, blocker = none;  // the token, and what kept it in the last cycle
        std::int8_t culprit = 0;
    };
    static constexpr std::size_t index(int k) { return static_cast<std::size_t>(k); }

    void fill(int k, std::int8_t slot, StageMask& full) {
        stage_[index(k)].slot = slot;
        stage_[index(k)].left = stage_[index(k)].stay;
        full |= StageMask{1} << k;
    }

    // Stages run from the last to the first, so that `full` is what the next stage is at the end
    // of the cycle.
    template <class Held, class Work>
    [[gnu::always_inline]] std::int8_t run_all(Held held, Work&& work) {
        std::int8_t out = none;
        StageMask full = full_;  // in a register while the stages run
        for (StageMask left = full; left != 0;) {
            const int k = 63 - std::countl_zero(left);
            left ^= StageMask{1} << k;
            const std::int8_t gone = run(k, held, full, work);
            if (gone != none) out = gone;
        }
        full_ = full;
        return out;
    }
    template <class Work>
    [[gnu::always_inline]] std::int8_t run(int k, StageMask held, StageMask& full, Work&& work) {
        Stage& s = stage_[index(k)];
        StageTime& t = time_[index(k)];
        if ((held >> k & 1) != 0) {
            s.culprit = static_cast<std::int8_t>(k);
            ++t.held;
            ++waited_[index(s.slot)];
            return none;
        }
        if (s.left > 0) {
            ++t.work;
            work(k, s.stay - s.left, s.slot);
            if (--s.left > 0) {
                s.culprit = static_cast<std::int8_t>(k);
                return none;
            }
        } else {  // the work was done in an earlier cycle, and the token could not leave
            ++t.blocked;
            ++blame_[index(k)][index(s.blocker)];
            ++waited_[index(s.slot)];
        }
        return move(k, held, full);
    }

    [[gnu::always_inline]] std::int8_t move(int k, StageMask held, StageMask& full) {
        Stage& s = stage_[index(k)];
        const int next = k + 1;
        const std::int8_t slot = s.slot;
        const bool next_full = (full >> next & 1) != 0, next_held = (held >> next & 1) != 0;
        if (next < stages() && !Rule::moves(k, next_full, next_held)) {
            s.blocker = next_full ? stage_[index(next)].culprit : static_cast<std::int8_t>(next);
            s.culprit = s.blocker;
            return none;
        }
        s.slot = none;
        full &= ~(StageMask{1} << k);
        if (next == stages()) return slot;
        fill(next, slot, full);
        return none;
    }

    StageList list_;
    StageMask full_ = 0;
    std::array<Stage, max_stages> stage_{};
    std::array<StageTime, max_stages> time_{};
    std::array<std::uint64_t, max_stages + 1> waited_{};  // by slot
    std::array<std::array<std::uint64_t, max_stages>, max_stages> blame_{};
};

}  // namespace umbra78::hw
