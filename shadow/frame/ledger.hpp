// The cycle ledger of a frame: what each unit did in each phase, and what the frame takes.
//
//   light's view, observer's view   operations of the drawing (raster/drawing_cost.hpp)
//   transformation                  the clocked post-process, stage by stage; or, where that is the
//                                   arithmetic, the AP-120B's routines, one after the other
//   filters                         operations of dequantizing, low-pass and composite
//
// The functional machine knows its cycles without ticking: where nothing is held, a stage works
// its stay for every visible pixel and is empty else, and the frame takes its closed form. A
// ledger of a clocked run has the stalls too, and who was to blame. Tests hold the two equal.
#pragma once

#include "hw/operations.hpp"
#include "shadow/ap120b/cost.hpp"
#include "shadow/clocked/post_process.hpp"
#include "shadow/frame/frame.hpp"

#include <array>
#include <cstdint>
#include <string_view>

namespace umbra78::shadow {

// A stage's cycles; together they are the total.
struct StageLedger {
    Unit unit{};
    std::string_view stage;
    int stay = 1;  // cycles a point
    std::uint64_t work = 0, blocked = 0, held = 0, idle = 0;
    int blamed = -1;  // the row that blocked it most
};

struct PostProcessLedger {
    std::array<StageLedger, hw::max_stages + 1> rows{};  // the reader first
    int count = 0;
    std::uint64_t total = 0;     // the stages side by side
    std::uint64_t visible = 0;
    int slot_cycles = 1, latency = 0;

    // Each point by itself, the next one only then: no pipeline at all.
    std::uint64_t without_overlap() const;
    const StageLedger& bottleneck() const;  // the stage that works most
};

// Without ticking, where no clock is held.
PostProcessLedger closed_form(const Schedule&, const PostProcessPipeline&);
// Of a clocked frame that is done.
template <class Depth>
PostProcessLedger ledger_of(const ClockedPostProcess<Depth>& machine);

// The greatest exponent of a highlight in the scene, which the shading of samples is costed with.
inline std::int32_t max_shininess(const Scene& scene) {
    std::int32_t max = 0;
    for (const raster::Material& m : scene.materials)
        max = m.shininess > max ? m.shininess : max;
    return max;
}

// A phase drawn or filtered in operations.
struct PhaseLedger {
    hw::Operations operations;
    hw::UnitCycles units;
};

struct FrameLedger {
    PhaseLedger light, observer, dequantize, low_pass, composite;
    PostProcessLedger post_process;  // empty on the AP-120B
    bool on_array = false;
    ArrayCost array;
    raster::DrawCounts light_counts, observer_counts;  // with nothing left out as hidden
    std::uint64_t visible = 0;

    // The phase's cycles: its units side by side, or one after the other.
    static std::uint64_t cycles(const PhaseLedger& p, bool overlap) {
        return overlap ? p.units.side_by_side() : p.units.one_after_the_other();
    }
    std::uint64_t transformation(bool overlap) const {
        if (on_array) return array.cycles();  // a routine at a time
        return overlap ? post_process.total : post_process.without_overlap();
    }
    std::string_view bottleneck() const;  // of the transformation
    std::uint64_t filters(bool overlap) const;
    std::uint64_t total(bool overlap) const;
};

// Draws each view once more, to count, with nothing hidden and nothing stored: cycles must not
// depend on the order of the patches.
template <class Depth>
FrameLedger frame_ledger(const Scene& scene, const Settings& settings,
                         const FrameMatrices& matrices, const FrameBuffers<Depth>& frame,
                         const FrameCounts& counts);

}  // namespace umbra78::shadow
