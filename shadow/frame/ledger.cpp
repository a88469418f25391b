#include "shadow/frame/ledger.hpp"

#include "raster/drawing_cost.hpp"

#include <algorithm>

namespace umbra78::shadow {
namespace {

// Counts what it is given; hides and keeps nothing.
struct CountingSink {
    static constexpr bool shades = false;
    bool hidden(const raster::Footprint&) const { return false; }
    void sample(const raster::Sample&, std::uint32_t, const raster::BlockShading*) {}
};

// Operations of the filters; the counts are those of hw/MACHINE.md, section 16.
constexpr hw::Operations chain_step(int passes) {
    // Followed by four reads; 1-2-1 averages of X and Y; of every second step sixteen crossings,
    // each a product, a quotient of 16 bits and two cells read and written.
    const auto p = static_cast<std::uint64_t>(passes);
    return {6 + 6 * p + 8 * 6, 8, 8, 8, 8 * 16, 4 + 8 * 4};
}
constexpr hw::Operations coverage_pixel{3, 1, 1, 0, 0, 2};
constexpr hw::Operations low_pass_pixel{12, 0, 0, 0, 0, 10};
constexpr hw::Operations composite_pixel{2, 2, 2, 1, 10, 3};

PhaseLedger phase(const hw::Operations& o, const Settings& s) {
    if (s.arithmetic == Arithmetic::ap120b)
        return {o, hw::ap120b_cycles(o, s.array_memory == hw::ap120b::MemorySpeed::fast ? 1 : 2)};
    return {o, hw::unit_cycles(o, s.machine)};
}

PhaseLedger drawing(const Scene& scene, const Settings& s, const FrameMatrices& matrices,
                    const hw::MatrixWords& matrix, raster::DrawMemory& memory, bool shades,
                    raster::DrawCounts& counts) {
    CountingSink sink;
    const raster::DrawSetup setup{s.machine, matrix, matrices.object, s.sampling,
                                  scene.materials, {}};
    counts = raster::draw(scene.patches, {}, setup, memory, sink);
    return phase(raster::drawing_operations(counts, s.machine, matrix.affine, s.sampling, shades,
                                            max_shininess(scene)),
                 s);
}

void name_stages(PostProcessLedger& l, const PostProcessPipeline& plan) {
    hw::StageList chain;
    plan.transform.add_stages(chain);
    const int divide = chain.stages();
    if (plan.divides) plan.divide.add_stages(chain);
    const int lookup = chain.stages();
    add_lookup_stages(chain, plan.lookup);
    const int write = chain.stages();
    chain.add("write");
    l.rows[0] = {Unit::reader, "read", plan.read_cycles};
    for (int k = 0; k < chain.stages(); ++k)
        l.rows[std::size_t(k) + 1] = {k < divide   ? Unit::transform
                                      : k < lookup ? Unit::divider
                                      : k < write  ? Unit::lookup
                                                   : Unit::writer,
                                      chain.name(k), chain.stay(k)};
    l.count = chain.stages() + 1;
}

// The correct form sends each generated point through the same stages, at the slots' pace.
Schedule correct_form_schedule(std::uint64_t samples, const PostProcessPipeline& plan) {
    Schedule s;
    s.visible = s.pixels = samples;
    if (samples > 0)
        s.last_issue = (samples - 1) * static_cast<std::uint64_t>(
                                           std::max(plan.slot_cycles, plan.read_cycles));
    return s;
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
    return on_array ? array.longest().name : post_process.bottleneck().stage;
}

std::uint64_t FrameLedger::filters(bool overlap) const {
    return cycles(dequantize, overlap) + cycles(low_pass, overlap) + cycles(composite, overlap);
}

std::uint64_t FrameLedger::total(bool overlap) const {
    return cycles(light, overlap) + cycles(observer, overlap) + transformation(overlap) +
           filters(overlap);
}

template <class Depth>
FrameLedger frame_ledger(const Scene& scene, const Settings& s, const FrameMatrices& matrices,
                         const FrameBuffers<Depth>& frame, const FrameCounts& counts) {
    const hw::MachineSpec& m = s.machine;
    const std::uint64_t pixels = std::uint64_t{1} << (2 * m.xy_bits);
    FrameLedger l;
    l.light = drawing(scene, s, matrices, matrices.world_to_light, *frame.draw, false,
                      l.light_counts);
    l.observer = drawing(scene, s, matrices, matrices.world_to_observer, *frame.draw, true,
                         l.observer_counts);
    l.on_array = s.arithmetic == Arithmetic::ap120b;
    const PostProcessPipeline plan(s, matrices.observer_to_light);
    const Schedule plain =
        s.form == Form::correct
            ? correct_form_schedule(l.observer_counts.samples, plan)
            : schedule<Depth>(frame.observer.depth, m.background(), plan.read_cycles,
                              plan.slot_cycles);
    if (l.on_array) {
        l.array = array_cost(counts.post_process, s, s.array_memory,
                             matrices.observer_to_light.affine);
    } else {
        l.post_process = closed_form(plain, plan);
    }
    const auto none = static_cast<Depth>(m.background());
    l.visible = pixels - static_cast<std::uint64_t>(std::count(
                             frame.observer.depth.begin(), frame.observer.depth.end(), none));
    if (s.dequantize_passes > 0)
        l.dequantize = phase(counts.chain_steps * chain_step(s.dequantize_passes) +
                                 pixels * coverage_pixel, s);
    l.low_pass = phase(static_cast<std::uint64_t>(s.low_pass_passes) * pixels * low_pass_pixel, s);
    l.composite = phase(pixels * composite_pixel, s);
    return l;
}

#define UMBRA78_LEDGER(Depth)                                                            \
    template PostProcessLedger ledger_of(const ClockedPostProcess<Depth>&);              \
    template FrameLedger frame_ledger(const Scene&, const Settings&, const FrameMatrices&, \
                                      const FrameBuffers<Depth>&, const FrameCounts&);
UMBRA78_LEDGER(hw::Depth16)
UMBRA78_LEDGER(hw::Depth32)
#undef UMBRA78_LEDGER

}  // namespace umbra78::shadow
