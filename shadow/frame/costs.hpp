// What a frame costs the fixed-point machine under a plan, and what each omission saves.
//
//   cost(plan)  = sum over stages of points x cycles a point, words x cycles a word
//   saved by o  = cost(the omissions before o) - cost(those and o),   in the order of the enum
//
// so that the savings add up to cost(FramePlan{}) - cost(plan). Cycles a point are the units' own
// closed forms (hw::transform_cycles, hw::serial_divide_cycles, the stays of the clocked stages)
// without the time to fill a pipeline. Drawing and filters are the ledger's operations
// (shadow/frame/ledger.hpp), one unit's cycles after the other's.
// Units: cycles in which a unit is busy. Where units work side by side, a frame gets shorter only
// by what its busiest unit saves.
#pragma once

#include "shadow/frame/ledger.hpp"
#include "shadow/frame/plan.hpp"

#include <array>
#include <cstdint>
#include <span>

namespace umbra78::shadow {

enum class FrameStage : std::uint8_t {
    light,
    observer,
    post_process,
    join,  // a source's darkness from its lights' masks; nothing where it is its one mask
    dequantize,
    low_pass,
    composite
};
inline constexpr std::size_t stage_count = 7;

struct StageCycles {
    std::uint64_t transform = 0, divide = 0, noise = 0, store = 0;
    hw::UnitCycles operations;  // of drawing and filters
    std::uint64_t total() const {
        return transform + divide + noise + store + operations.one_after_the_other();
    }
    StageCycles& operator+=(const StageCycles& o);
};

using FrameCycles = std::array<StageCycles, stage_count>;  // by FrameStage

// What a frame turned out to be: a ledger for each of its lights.
struct DrawnFrame {
    const FrameInputs& inputs;
    std::span<const FrameLedger> ledgers;

    DrawnFrame(const FrameInputs& of, std::span<const FrameLedger> by_light)
        : inputs(of), ledgers(by_light) {}
    // Of one light.
    DrawnFrame(const FrameInputs& of, const FrameLedger& ledger)
        : inputs(of), ledgers(&ledger, 1) {}
};

// Traps for a method that has no such costs (Method::no_plan_cost), and without a light's ledger.
FrameCycles cycles_of(const FramePlan& plan, const DrawnFrame& drawn);
std::uint64_t total(const FrameCycles& cycles);

// The transform, lookup and compare of the post-process and of the correct form.
StageCycles post_process_cycles(const DrawnFrame& drawn, const FramePlan& plan, std::size_t light);
// Of a method whose ledger has it as operations.
StageCycles counted_cycles(const DrawnFrame& drawn, const FramePlan& plan, std::size_t light);

struct Saving {
    std::uint64_t cycles = 0;
    bool after_drawing = false;  // it is known only after the drawing
};
Saving saving(Omission omission, const FramePlan& plan, const DrawnFrame& drawn);

}  // namespace umbra78::shadow
