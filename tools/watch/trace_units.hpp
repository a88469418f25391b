// The words of each unit of the post-process, for a pixel's trace.
//
// Each function is called after the cycle that it reports, with the point's registers as they are
// then.
#pragma once

#include "tools/watch/trace_log.hpp"
#include "tools/watch/watched_frame.hpp"

#include <cstdint>
#include <vector>

namespace umbra78::tools {

// What all of these functions read.
struct TracedPoint {
    const shadow::Settings& settings;
    const shadow::PostProcessPipeline& plan;
    const shadow::PointRegisters& flight;

    const hw::MachineSpec& spec() const { return settings.machine; }
    const hw::MatrixWords& matrix() const { return plan.transform.matrix(); }
};

inline constexpr const char* row_names[] = {"X", "Y", "Z", "W"};

// --- trace_inputs.cpp: what enters the post-process

void trace_matrix(TraceLog&, const shadow::Settings&, const hw::MatrixWords&);
// `read` has the cycles in which the reader read the pixel. Throws std::logic_error if the words
// made from these bytes differ from the machine's.
void trace_noise(TraceLog&, const TracedPoint&, const std::vector<std::uint64_t>& read,
                 std::uint64_t released);
void trace_words(TraceLog&, const TracedPoint&, std::uint64_t released);

// --- trace_transform.cpp: steps 0 .. latency - 1 of the unit

class TransformTrace {
public:
    void step(TraceLog&, const TracedPoint&, int step, std::uint64_t cycle);

private:
    void products(TraceLog&, const TracedPoint&, int turn);
    void sums(TraceLog&, const TracedPoint&, int turn) const;
    void accumulators(TraceLog&, const TracedPoint&, int turn) const;
    void results(TraceLog&, const TracedPoint&, int turn) const;

    std::vector<std::array<std::int64_t, 4>> sums_;  // by multiply cycle, and row
};

// --- trace_divider.cpp: steps of the divider

void trace_divide(TraceLog&, const TracedPoint&, int step, std::uint64_t cycle);

// --- trace_lookup.cpp: a function a stage; `step` counts the stage's own cycles

void trace_place(TraceLog&, const TracedPoint&);
void trace_fetch(TraceLog&, const TracedPoint&, int step);
void trace_interpolate(TraceLog&, const TracedPoint&, int step);
void trace_sum(TraceLog&, const TracedPoint&, int step);
void trace_compare(TraceLog&, const TracedPoint&, int step);
void trace_write(TraceLog&, const TracedPoint&, std::uint8_t mask);

// --- trace_filters.cpp: after the post-process, from the frame's buffers

// Throws std::logic_error if a buffer differs from what the formula gives.
void trace_filters(TraceLog&, const WatchedFrame&, const RenderJob&, int x, int y);

}  // namespace umbra78::tools
