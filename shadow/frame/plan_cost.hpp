// What a frame costs the machine under a plan, in cycles of each unit, and what omissions save.
//
//   cost(plan)  = sum over stages of points x cycles a point, words x cycles a word
//   saved by o  = cost(the omissions before o) - cost(those and o),   in the order of the enum
//
// so that the savings add up to cost(FramePlan{}) - cost(plan). The closed forms are the units' own
// (hw::transform_cycles, hw::serial_divide_cycles) without the time to fill a pipeline; drawing and
// filters are the ledger's operations (shadow/frame/ledger.hpp), each unit's cycles after the
// other's.
// These are cycles that units are busy: where they work side by side, a frame gets shorter only by
// what its busiest unit is spared. The fixed-point machine's, whatever settings.arithmetic says.
#pragma once

#include "shadow/frame/ledger.hpp"

#include <array>
#include <cstdint>

namespace umbra78::shadow {

enum class FrameStage : std::uint8_t {
    light,
    observer,
    post_process,
    dequantize,
    low_pass,
    composite
};
inline constexpr std::size_t stage_count = 6;

struct UnitCycles {
    std::uint64_t transform = 0, divide = 0, noise = 0, store = 0;
    std::uint64_t operations = 0;  // of drawing and filters, on whatever unit
    std::uint64_t total() const { return transform + divide + noise + store + operations; }
};

using StageCycles = std::array<UnitCycles, stage_count>;

// What a frame turned out to be.
struct DrawnFrame {
    const FrameInputs& inputs;
    const FrameLedger& ledger;
};

StageCycles cycles_of(const FramePlan& plan, const DrawnFrame& drawn);
std::uint64_t total(const StageCycles& cycles);

struct Saving {
    std::uint64_t cycles = 0;
    bool after_drawing = false;  // the count is not known before
};
Saving saving(Omission omission, const FramePlan& plan, const DrawnFrame& drawn);

}  // namespace umbra78::shadow
