// The cycle ledger of a frame: what each unit does in each phase, and what the frame takes.
//
//   light's view, observer's view   operations of the drawing (raster/drawing_cost.hpp)
//   transformation                  what the method takes (shadow/frame/methods.hpp): the clocked
//                                   post-process stage by stage; on the AP-120B its routines, one
//                                   after the other; or operations
//   filters                         operations of dequantizing, low-pass and composite
//
// The functional machine knows its cycles without being ticked. Where no clock is held, a stage
// works its stay for every visible pixel and is empty otherwise, and the frame takes its closed
// form. A ledger of a clocked run also has the stalls, and which stage caused them. Tests hold the
// two equal.
#pragma once

#include "hw/operations.hpp"
#include "raster/drawing_cost.hpp"
#include "shadow/ap120b/cost.hpp"
#include "shadow/clocked/post_process.hpp"
#include "shadow/frame/methods.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace umbra78::shadow {

// A stage's cycles: work, blocked, held and idle add up to the total.
struct StageLedger {
    PostProcessUnit unit{};
    std::string_view stage;
    int stay = 1;  // cycles a point
    std::uint64_t work = 0, blocked = 0, held = 0, idle = 0;
    int blamed = -1;  // the row that blocked it most; -1: none did
};

struct PostProcessLedger {
    std::array<StageLedger, hw::max_stages + 1> rows{};  // the reader first
    int count = 0;
    std::uint64_t total = 0;  // cycles, the stages side by side
    std::uint64_t visible = 0;
    int slot_cycles = 1, latency = 0;

    // Cycles without a pipeline: a point starts when the one before it is done.
    std::uint64_t without_overlap() const;
    const StageLedger& bottleneck() const;  // the stage that works most
};

// Of a frame in which no clock is held, without ticking.
PostProcessLedger closed_form(const Schedule&, const PostProcessPipeline&);
// Of a clocked frame that is done.
template <class Depth>
PostProcessLedger ledger_of(const ClockedPostProcess<Depth>& machine);

// Every shaded sample is costed with the max exponent of a highlight in the scene.
inline raster::SampleCost sample_cost(const Scene& scene, raster::ShadingRule rule) {
    std::int32_t max = 0;
    for (const raster::Material& m : scene.materials)
        max = m.shininess > max ? m.shininess : max;
    return {max, scene.sources_used(), scene.channels, rule};
}

// A phase that is costed in operations.
struct PhaseLedger {
    hw::Operations operations;
    hw::UnitCycles units;
};

// The lines of a frame that the plan's finer omissions leave: known when it is done.
struct FrameLines {
    std::uint64_t visible = 0;  // with something visible
    FilteredLines filtered;     // with a shadow near enough, whether they were filtered or not
};

// Of the frame as one of its lights has it: the observer's view is drawn once, whatever the lights.
// The phases after the transformation are a source's and stand at its first light.
struct FrameLedger {
    PhaseLedger light, observer, join, dequantize, low_pass, composite;
    PhaseLedger dequantize_near, low_pass_near, composite_near;  // on lines.filtered alone
    // The transformation: one of these three, whichever the method fills.
    PostProcessLedger post_process;
    bool on_array = false;
    bool has_map = true;
    bool on_ground = false;  // then `light` is the shadow's own drawing, and no pixel is tested
    ArrayCost array;       // if on_array
    PhaseLedger test;      // of a method that is costed in operations
    PhaseLedger scene;     // once for a scene and apart from the frame; in no total
    // With no block left out as hidden: of all surfaces, and of those that may lie in the view.
    raster::DrawCounts light_counts, observer_counts, light_inside, observer_inside;
    std::uint64_t visible = 0;
    FrameLines lines;

    // The phase's cycles: its units side by side, or one after the other.
    static std::uint64_t cycles(const PhaseLedger& p, bool overlap) {
        return overlap ? p.units.side_by_side() : p.units.one_after_the_other();
    }
    std::uint64_t transformation(bool overlap) const {
        if (on_array) return array.cycles();  // one routine at a time
        return cycles(test, overlap) +
               (overlap ? post_process.total : post_process.without_overlap());
    }
    std::string_view bottleneck() const;  // of the transformation
    std::uint64_t filters(bool overlap) const;
    std::uint64_t total(bool overlap) const;
};

// What of a view's samples is kept beside Z.
enum class Keeps : std::uint8_t { depth, shades, shades_and_normals };

// Operations of drawing a view with these counts.
hw::Operations drawing_operations(const FrameInputs&, const hw::MatrixWords& view,
                                  const raster::DrawCounts&, Keeps);
// What the observer's view keeps.
Keeps kept_of_observer(const FrameInputs&);

// What map_depth and bias_slope add to the drawing of a light's view with these counts.
hw::Operations map_operations(const FrameInputs&, const raster::DrawCounts&);

// Whether the post-process goes over the frame for this light: not for a further sector whose
// pixels the first one's pass sorts out.
bool has_pass(const FrameInputs&, std::size_t light);
// What such a pass takes of each visible pixel beside the pipeline.
hw::Operations test_operations(const FrameInputs&, std::size_t light);

// Ledgers in which the counts of the observer's view, or of this light's, are this frame's too:
// of another of its lights, or of a frame whose view find_reuse() would keep.
struct KnownCounts {
    const FrameLedger *observer = nullptr, *light = nullptr;
};

// Of a frame that is done. Draws the light's view and the observer's once more, to count, with
// nothing hidden and nothing stored: cycles must not depend on the order of the patches. A stream
// is drawn with nothing hidden, and its counts are taken as they are.
template <class Depth>
FrameLedger frame_ledger(const FrameInputs&, const FrameBuffers<Depth>&, const FrameCounts&,
                         std::size_t light = 0, const KnownCounts& = {});

// The whole frame's cycles from the ledgers of all its lights.
std::uint64_t total(std::span<const FrameLedger> by_light, bool overlap);

}  // namespace umbra78::shadow
