// The clocked post-process as a value change dump, for a waveform viewer such as GTKWave.
//
//   umbra78.clock, cycle      the clock rises where a cycle begins and falls in its middle
//   umbra78.reader.*          state, px, py, code; go: a point leaves it at the end of the cycle
//   umbra78.s<k>_<name>.*     state, valid, ready, point, px, py, and the unit's words
//
// The values at time cycle x clock_ns are those of that cycle: the point that a stage has, and the
// words that the cycle makes, which the registers hold from the next clock edge on. Cycles are
// numbered as by `umbra78 trace`. A point moves from a stage to the next at the end of a cycle in
// which the one is valid and the other ready. In a bubble (a cycle without a point) words keep
// their last value.
//
// state: 0 nothing, 1 work, 2 blocked, 3 held; the reader's: 0 done, 1 read, 2 waits for its
// slot, 3 blocked, 4 held. point counts from 1 in the order of the scan. Words are two's
// complement in their widths.
#pragma once

#include "tools/io/files.hpp"
#include "tools/render/render_job.hpp"

#include "shadow/clocked/post_process.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace umbra78::tools {

struct VcdOptions {
    std::uint64_t cycles = 4096;  // max number written; fewer if the frame ends before
    // The first cycle. None: the one in which the first visible pixel leaves the reader.
    std::optional<std::uint64_t> from;
    int clock_ns = 200;
    // Which clocks are held in a cycle; empty: none.
    std::function<hw::StageMask(std::uint64_t cycle)> holds;
};

// Ticks the machine from its present cycle.
template <class Depth>
std::string vcd_of(shadow::ClockedPostProcess<Depth>& machine, const VcdOptions& options = {});
template <class Depth>
void write_vcd(const Path&, shadow::ClockedPostProcess<Depth>& machine,
               const VcdOptions& options = {}, FileSet* set = nullptr);

// The same for a new machine over a rendered frame, with the frame's clock.
void write_vcd(const Path&, const RenderJob&, VcdOptions options = {}, FileSet* set = nullptr);

}  // namespace umbra78::tools
