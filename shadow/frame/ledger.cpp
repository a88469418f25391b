#include "shadow/frame/ledger.hpp"

#include "raster/drawing_cost.hpp"
#include "shadow/frame/drawing.hpp"
#include "shadow/frame/filter_cost.hpp"

#include <algorithm>

namespace umbra78::shadow {
namespace {

// Counts what it is given; hides and keeps nothing.
struct CountingSink {
    static constexpr bool shades = false;
    bool hidden(const raster::Footprint&) const { return false; }
    void sample(const raster::Sample&, std::uint32_t, const auto*) {}
};

PhaseLedger phase(const hw::Operations& o, const FrameInputs& in) {
    return {o, method_of(in).units(o, in.settings)};
}

// `drawn`: what the drawing of the frame counted; of a stream, it is all that there is to count.
PhaseLedger drawing(const FrameInputs& in, const hw::MatrixWords& matrix,
                    const raster::DrawCounts& drawn, raster::DrawMemory& memory, bool shades,
                    raster::DrawCounts& counts) {
    if (in.scene.streamed) {
        counts = drawn;
        return phase(drawing_operations(in, matrix, counts, shades), in);
    }
    CountingSink sink;
    const raster::DrawSetup setup{in.settings.machine,     matrix,
                                  in.matrices.object,      in.settings.sampling,
                                  in.scene.materials,      {},
                                  in.settings.surface,     in.settings.dice_levels,
                                  dice_tolerance(in),      in.settings.facing};
    counts = raster::draw(in.scene.surfaces(), {}, setup, memory, sink);
    return phase(drawing_operations(in, matrix, counts, shades), in);
}

void name_stages(PostProcessLedger& l, const PostProcessPipeline& plan) {
    hw::StageList list;
    plan.transform.add_stages(list);
    const int divide = list.stages();
    if (plan.divides) plan.divide.add_stages(list);
    const int lookup = list.stages();
    add_lookup_stages(list, plan.lookup);
    const int write = list.stages();
    list.add("write");
    l.rows[0] = {PostProcessUnit::reader, "read", plan.read_cycles};
    for (int k = 0; k < list.stages(); ++k)
        l.rows[static_cast<std::size_t>(k) + 1] = {k < divide   ? PostProcessUnit::transform
                                                   : k < lookup ? PostProcessUnit::divider
                                                   : k < write  ? PostProcessUnit::lookup
                                                                : PostProcessUnit::writer,
                                                   list.name(k), list.stay(k)};
    l.count = list.stages() + 1;
}

}  // namespace

std::uint64_t PostProcessLedger::without_overlap() const {
    return rows[0].work + visible * static_cast<std::uint64_t>(latency);
}

const StageLedger& PostProcessLedger::bottleneck() const {
    return *std::max_element(rows.begin(), rows.begin() + count,
                             [](const auto& a, const auto& b) { return a.work < b.work; });
}

PostProcessLedger closed_form(const Schedule& s, const PostProcessPipeline& plan) {
    PostProcessLedger l;
    name_stages(l, plan);
    l.total = s.cycles(plan.latency);
    l.visible = s.visible;
    l.slot_cycles = plan.slot_cycles;
    l.latency = plan.latency;
    for (int k = 0; k < l.count; ++k) {
        StageLedger& row = l.rows[std::size_t(k)];
        row.work = static_cast<std::uint64_t>(row.stay) * (k == 0 ? s.pixels : s.visible);
        row.idle = l.total - row.work;
    }
    return l;
}

template <class Depth>
PostProcessLedger ledger_of(const ClockedPostProcess<Depth>& machine) {
    PostProcessLedger l;
    name_stages(l, machine.plan());
    l.total = machine.cycles();
    l.visible = machine.counts().visible;
    l.slot_cycles = machine.plan().slot_cycles;
    l.latency = machine.plan().latency;
    const auto blame = [&](StageLedger& row, auto&& blocked_by) {
        std::uint64_t max = 0;
        for (int by = 0; by < machine.chain().stages(); ++by)
            if (blocked_by(by) > max) max = blocked_by(by), row.blamed = by + 1;
        row.idle = l.total - row.work - row.blocked - row.held;
    };
    const auto& r = machine.reader();
    l.rows[0].work = r.read;
    l.rows[0].blocked = r.blocked;
    l.rows[0].held = r.held;
    blame(l.rows[0], [&](int by) { return machine.reader_blocked_by(by); });
    for (int k = 0; k < machine.chain().stages(); ++k) {
        const hw::StageTime& t = machine.chain().time(k);
        StageLedger& row = l.rows[std::size_t(k) + 1];
        row.work = t.work;
        row.blocked = t.blocked;
        row.held = t.held;
        blame(row, [&](int by) { return machine.chain().blocked_by(k, by); });
    }
    return l;
}

std::string_view FrameLedger::bottleneck() const {
    if (on_array) return array.longest().name;
    return test.units.side_by_side() > 0 ? test.units.busiest() : post_process.bottleneck().stage;
}

std::uint64_t FrameLedger::filters(bool overlap) const {
    return cycles(dequantize, overlap) + cycles(low_pass, overlap) + cycles(composite, overlap);
}

std::uint64_t FrameLedger::total(bool overlap) const {
    return cycles(light, overlap) + cycles(observer, overlap) + transformation(overlap) +
           filters(overlap);
}

hw::Operations drawing_operations(const FrameInputs& in, const hw::MatrixWords& view,
                                  const raster::DrawCounts& counts, bool shades) {
    return raster::drawing_operations(counts, in.settings.machine, view.affine,
                                      in.settings.sampling, shades, max_shininess(in.scene));
}

template <class Depth>
FrameLedger frame_ledger(const FrameInputs& in, const FrameBuffers<Depth>& frame,
                         const FrameCounts& counts) {
    fixed::require(in.scene.light_count == 1, "a ledger is of a frame with one light");
    const Settings& s = in.settings;
    const std::uint64_t pixels = std::uint64_t{1} << (2 * s.machine.xy_bits);
    const Method& method = method_of(in);
    FrameLedger l;
    l.light = drawing(in, in.matrices.lights[0].world_to_light, counts.lights[0].map, *frame.draw,
                      false, l.light_counts);
    l.observer = drawing(in, in.matrices.world_to_observer, counts.observer, *frame.draw, true,
                         l.observer_counts);
    const auto none = static_cast<Depth>(s.machine.background());
    l.visible = pixels - static_cast<std::uint64_t>(std::count(
                             frame.observer.depth.begin(), frame.observer.depth.end(), none));
    if (method.scene_cost != nullptr) method.scene_cost(in, 0, l);
    method.stages<Depth>().frame_cost(in, 0, frame, counts, l);
    if (s.dequantize_passes > 0)
        l.dequantize = phase(counts.lights[0].chain_steps * cost::chain_step(s.dequantize_passes) +
                                 pixels * cost::coverage_pixel,
                             in);
    const auto passes = static_cast<std::uint64_t>(s.low_pass_passes);
    l.low_pass = phase(passes * pixels * cost::low_pass_pixel, in);
    l.composite = phase(pixels * cost::composite_pixel, in);
    return l;
}

#define UMBRA78_LEDGER(Depth)                                                             \
    template PostProcessLedger ledger_of(const ClockedPostProcess<Depth>&);               \
    template FrameLedger frame_ledger(const FrameInputs&, const FrameBuffers<Depth>&,     \
                                      const FrameCounts&);
UMBRA78_LEDGER(hw::Depth16)
UMBRA78_LEDGER(hw::Depth32)
#undef UMBRA78_LEDGER

}  // namespace umbra78::shadow
