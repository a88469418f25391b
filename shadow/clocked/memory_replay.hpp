// The memory replay: how long a frame's post-process takes with memory of the time.
//
//   read observer Z -> unit (S clocks a visible pixel) -> light map -> write mask
//   leave(k, i) = max( leave(k-1, i) + service(k, i),  leave(k+1, i-1) )
//
// A second pass over a finished frame, run only when asked for: it sends the very addresses of the
// post-process, in the machine's order, through three stores of dynamic memory
// (hw/memory/dram.hpp), so that dither, interpolation and the light's angle show up as page
// misses. Rules and sources: hw/MACHINE.md, section 17.
// Not emulated: the pipeline within the unit (its latency), queues between the stages, prefetch.
#pragma once

#include "hw/frame_store.hpp"
#include "hw/memory/dram.hpp"
#include "hw/transform_unit.hpp"
#include "shadow/clocked/timed_test.hpp"

#include <cstdint>

namespace umbra78::shadow {

// What the frame waited for, stage by stage, along the longest path through the recurrence.
struct PathTime {
    std::uint64_t read_ns = 0, unit_ns = 0, light_ns = 0, write_ns = 0;
    std::uint64_t total_ns() const { return read_ns + unit_ns + light_ns + write_ns; }
};

struct MemoryLedger {
    hw::DramCounts observer, light, mask;
    std::uint64_t pixels = 0, visible = 0;
    std::uint64_t looked_up = 0;  // visible pixels that read the light map
    std::uint64_t total_ns = 0;   // the frame with this memory,
    std::uint64_t ideal_ns = 0;   // and with one that serves a request in a clock
    PathTime path, ideal_path;   // of total_ns and of ideal_ns
};

// Of the post-process form, whatever settings.form says. The light map's words do not matter: only
// where they lie. `issue_cycles` is S > 0: a visible pixel enters the unit so many clocks after
// the one before it (PostProcessPipeline::slot_cycles, the longest stay of a stage). Widths or
// times out of their ranges, and a store of other widths than the machine, trap.
MemoryLedger replay_memory(const hw::FrameStore<const hw::Depth16>& observer,
                           const hw::MatrixWords& matrix, const TimedTest& settings,
                           std::uint64_t issue_cycles);
MemoryLedger replay_memory(const hw::FrameStore<const hw::Depth32>& observer,
                           const hw::MatrixWords& matrix, const TimedTest& settings,
                           std::uint64_t issue_cycles);

}  // namespace umbra78::shadow
