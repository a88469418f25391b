// The stages of the methods that test against a depth map: rows of shadow/frame/methods.cpp, which
// instantiates those that are built.
#pragma once

#include "shadow/ap120b/post_process.hpp"
#include "shadow/correct_form.hpp"
#include "shadow/frame/bias_cost.hpp"
#include "shadow/frame/costs.hpp"
#include "shadow/frame/drawing.hpp"
#include "shadow/frame/methods.hpp"
#include "shadow/frame/sector_stage.hpp"

#include <algorithm>

namespace umbra78::shadow {

inline hw::UnitCycles fixed_units(const hw::Operations& o, const Settings& s) {
    return hw::unit_cycles(o, s.machine);
}

// --- the post-process ----------------------------------------------------------------------------

template <class Depth>
void cast_post_process(const FrameInputs& in, const FramePlan& plan, std::size_t l,
                       FrameBuffers<Depth>& frame, FrameCounts& counts) {
    if constexpr (hw::built(hw::Feature::lights)) {
        if (in.scene.source_of(l).sectored) return cast_sectors(in, plan, l, frame, counts);
    }
    const std::span<std::uint8_t> mask = frame.lights[l].mask;
    const hw::MatrixWords& matrix = in.matrices.lights[l].observer_to_light;
    const auto test = [&](hw::Band band, std::size_t worker) {
        if constexpr (hw::built(hw::Feature::rows) && sizeof(Depth) == sizeof(hw::Depth16)) {
            if (work_of(plan) == needed_work(in.settings) && rows_cover(in.settings, matrix))
                return post_process_rows(frame.maps(l), matrix, in.settings, frame.rows[worker],
                                         mask, band);
        }
        return post_process(frame.maps(l), matrix, in.settings, work_of(plan), mask,
                            receiver_words(in, l), band);
    };
    counts.lights[l].post_process = count_bands<PostProcessCounts>(
        frame.executor, in.settings.machine.size_px(), test);
}

// The schedule of the observer's visible pixels through the clocked stages.
template <class Depth>
void cost_of_post_process(const FrameInputs& in, std::size_t l, const FrameBuffers<Depth>& frame,
                          const FrameCounts&, FrameLedger& ledger) {
    if (!has_pass(in, l)) return;
    const PostProcessPipeline pipeline(in.settings, in.matrices.lights[l].observer_to_light);
    ledger.test.operations += ledger.visible * test_operations(in, l);
    ledger.test.units = fixed_units(ledger.test.operations, in.settings);
    ledger.post_process = closed_form(
        schedule<Depth>(frame.observer.depth, in.settings.machine.background(),
                        pipeline.read_cycles, pipeline.slot_cycles),
        pipeline);
}

template <class Depth>
constexpr MethodStages<Depth> post_process_stages{nullptr, cast_post_process<Depth>,
                                                  cost_of_post_process<Depth>};

// --- the correct form ----------------------------------------------------------------------------

template <class Depth>
void draw_correct_form(const FrameInputs& in, const FramePlan& plan, FrameBuffers<Depth>& frame,
                       FrameCounts& counts) {
    const Settings& settings = in.settings;
    TestedLights<Depth> lights;
    fixed::require(in.scene.light_count == in.scene.sources_used(),
                   "the correct form has no lights with area");
    for (std::size_t l = 0; l < in.scene.light_count; ++l) {
        if (plan.leaves_out(Omission::post_process, l)) continue;  // its mask is lit already
        LightBuffers<Depth>& light = frame.lights[l];
        lights[l].emplace(TestedLight<Depth>{
            light_map<Depth>(light.map, settings),
            hw::TransformUnit(settings.machine, in.matrices.lights[l].observer_to_light,
                              plan.unit_work()),
            light.mask});
    }
    CorrectSink<Depth> sink(frame.observer, lights, settings, work_of(plan).noise);
    counts.observer = draw_view(in, plan, in.scene.observer, in.matrices.world_to_observer, frame,
                                sink);
}

template <class Depth>
void count_correct_form(const FrameInputs&, const FramePlan&, std::size_t l,
                        FrameBuffers<Depth>& frame, FrameCounts& counts) {
    const std::span<const std::uint8_t> mask = frame.lights[l].mask;
    counts.lights[l].post_process.visible = counts.observer.samples;
    counts.lights[l].post_process.shadowed =
        static_cast<std::uint64_t>(std::count(mask.begin(), mask.end(), mask_shadow));
}

// Each generated point goes through the same stages, at the slots' pace.
template <class Depth>
void cost_of_correct_form(const FrameInputs& in, std::size_t l, const FrameBuffers<Depth>&,
                          const FrameCounts&, FrameLedger& ledger) {
    const PostProcessPipeline pipeline(in.settings, in.matrices.lights[l].observer_to_light);
    const std::uint64_t points = ledger.observer_counts.samples;
    const int pace = std::max(pipeline.slot_cycles, pipeline.read_cycles);
    Schedule s;
    s.visible = s.pixels = points;
    if (points > 0) s.last_issue = (points - 1) * static_cast<std::uint64_t>(pace);
    ledger.post_process = closed_form(s, pipeline);
}

template <class Depth>
constexpr MethodStages<Depth> correct_stages{draw_correct_form<Depth>, count_correct_form<Depth>,
                                             cost_of_correct_form<Depth>};

// --- the AP-120B ---------------------------------------------------------------------------------

inline void load_array(const hw::RationalMatrix& exact, const Settings& settings,
                       LightMatrices& out) {
    out.array = array_matrix(exact, settings);
}

inline hw::UnitCycles array_units(const hw::Operations& o, const Settings& s) {
    return hw::ap120b_cycles(o, s.array_memory == hw::ap120b::MemorySpeed::fast ? 1 : 2);
}

template <class Depth>
void cast_on_array(const FrameInputs& in, const FramePlan&, std::size_t l,
                   FrameBuffers<Depth>& frame, FrameCounts& counts) {
    const LightMatrices& m = in.matrices.lights[l];
    counts.lights[l].post_process = count_bands<PostProcessCounts>(
        frame.executor, in.settings.machine.size_px(), [&](hw::Band band, std::size_t) {
            return array_post_process(frame.maps(l), m.array, m.observer_to_light.affine,
                                      in.settings, frame.lights[l].mask, band);
        });
}

template <class Depth>
void cost_on_array(const FrameInputs& in, std::size_t l, const FrameBuffers<Depth>&,
                   const FrameCounts& counts, FrameLedger& ledger) {
    ledger.on_array = true;
    ledger.array = array_cost(counts.lights[l].post_process, in.settings,
                              in.settings.array_memory,
                              in.matrices.lights[l].observer_to_light.affine);
}

template <class Depth>
constexpr MethodStages<Depth> array_stages{nullptr, cast_on_array<Depth>, cost_on_array<Depth>};

}  // namespace umbra78::shadow
