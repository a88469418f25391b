#include "shadow/frame/ledger.hpp"

#include "raster/drawing_cost.hpp"
#include "shadow/frame/bias_cost.hpp"
#include "shadow/frame/drawing.hpp"
#include "shadow/frame/filter_cost.hpp"
#include "shadow/frame/sector_cost.hpp"
#include "shadow/lines.hpp"

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

// Both parts of the surfaces, so that what lies outside is known by itself. `drawn`: what the
// drawing of the frame counted; of a stream, it is all that there is to count. `known`: both counts
// are there.
PhaseLedger drawing(const FrameInputs& in, const hw::MatrixWords& matrix,
                    const raster::DrawCounts& drawn, raster::DrawMemory& memory, bool shades,
                    const raster::Casters& casters, bool known, raster::DrawCounts& counts,
                    raster::DrawCounts& inside) {
    const auto operations = [&] {
        hw::Operations o = drawing_operations(in, matrix, counts,
                                              shades ? kept_of_observer(in) : Keeps::depth);
        if (!shades) o += map_operations(in, counts);
        return phase(o, in);
    };
    if (known) return operations();
    if (in.scene.streamed) {
        inside = counts = drawn;
        return operations();
    }
    CountingSink sink;
    raster::DrawSetup setup{in.settings.machine,     matrix,
                            in.matrices.object,      in.settings.sampling,
                            in.scene.materials,      {},
                            in.settings.surface,     in.settings.dice_levels,
                            dice_tolerance(in),      in.settings.facing};
    if (!shades) setup.facing = light_facing(in);
    setup.casters = casters;
    inside = counts = {};
    const auto add = [&](const raster::Surfaces& part) {
        setup.drawn = raster::Drawn::inside;
        inside += raster::draw(part, {}, setup, memory, sink);
        setup.drawn = raster::Drawn::outside;
        counts += raster::draw(part, {}, setup, memory, sink);
    };
    if (shades)
        add(in.scene.surfaces());
    else
        for_casters(in, add);
    counts += inside;
    return operations();
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
    return cycles(join, overlap) + cycles(dequantize, overlap) + cycles(low_pass, overlap) +
           cycles(composite, overlap);
}

std::uint64_t FrameLedger::total(bool overlap) const {
    return cycles(light, overlap) + cycles(observer, overlap) + transformation(overlap) +
           filters(overlap);
}

std::uint64_t total(std::span<const FrameLedger> by_light, bool overlap) {
    std::uint64_t sum = 0;
    for (const FrameLedger& l : by_light)
        sum += l.total(overlap) - FrameLedger::cycles(l.observer, overlap);
    return by_light.empty() ? 0 : sum + FrameLedger::cycles(by_light[0].observer, overlap);
}

hw::Operations drawing_operations(const FrameInputs& in, const hw::MatrixWords& view,
                                  const raster::DrawCounts& counts, Keeps keeps) {
    raster::SampleCost sample = sample_cost(in.scene, in.settings.shading);
    sample.keeps_normals = keeps == Keeps::shades_and_normals;
    return raster::drawing_operations(counts, in.settings.machine, view.affine,
                                      in.settings.sampling, keeps != Keeps::depth, sample);
}

Keeps kept_of_observer(const FrameInputs& in) {
    return keeps_normals(in) ? Keeps::shades_and_normals : Keeps::shades;
}

hw::Operations map_operations(const FrameInputs& in, const raster::DrawCounts& counts) {
    const Settings& s = in.settings;
    hw::Operations o{};
    if (map_layers(s) == 0) return o;
    if (s.bias_slope_q8 > 0) o += raster::slope_operations(counts);
    if (map_layers(s) > 1)
        o += counts.samples * cost::second_sample +
             (std::uint64_t{1} << (2 * s.machine.xy_bits)) * cost::midpoint_texel;
    return o;
}

bool has_pass(const FrameInputs& in, std::size_t light) {
    const Source source = in.scene.source_of(light);
    return !source.sectored || light == source.first_light ||
           in.settings.sector_test == SectorTest::every;
}

hw::Operations test_operations(const FrameInputs& in, std::size_t light) {
    hw::Operations o{};
    const cost::ReceiverCost receiver =
        cost::receiver_cost(in.settings.receiver, in.settings.slope_source);
    o += receiver.pixel;
    if (raster::has_eye(in.scene.lights[light])) o += receiver.in_perspective;
    if (in.scene.source_of(light).sectored) o += cost::sector_pixel;
    return o;
}

namespace {

FilteredLines lines_near_shadow(std::span<const std::uint8_t> mask, const Settings& s) {
    LineSet lines = lines_with_shadow(mask, s.machine.size_px());
    FilteredLines n{.dequantize = lines.count()};
    for (int pass = 0; pass < s.low_pass_passes; ++pass) {
        lines = lines.with_neighbours();
        n.low_pass += lines.count();
    }
    n.composite = lines.count();
    return n;
}

// Of filters that go through so many lines.
void add_filters(const FrameInputs& in, std::uint64_t chain_steps, const FilteredLines& lines,
                 PhaseLedger& of_dequantize, PhaseLedger& of_low_pass, PhaseLedger& of_composite) {
    const Settings& s = in.settings;
    const auto size = static_cast<std::uint64_t>(s.machine.size_px());
    if (s.dequantize_passes > 0 && method_of(in).darkness == Darkness::binary)
        of_dequantize = phase(chain_steps * cost::chain_step(s.dequantize_passes) +
                                  lines.dequantize * size * cost::coverage_pixel,
                              in);
    of_low_pass = phase(lines.low_pass * size * cost::low_pass_pixel, in);
    of_composite =
        phase(lines.composite * size * in.scene.channels * cost::composite_pixel, in);
}

template <class Depth>
void add_source(const FrameInputs& in, const Source& source, const FrameBuffers<Depth>& frame,
                const LightCounts& counts, FrameLedger& l) {
    const Settings& s = in.settings;
    const auto size = static_cast<std::uint64_t>(s.machine.size_px());
    const auto passes = static_cast<std::uint64_t>(s.low_pass_passes);
    if (source.is_graded())
        l.join = phase(size * size * (source.ramp_px > 0 ? cost::ramp_pixel(source.ramp_px)
                                                         : cost::join_pixel(source.lights)),
                       in);
    const std::uint64_t dequantized = source.is_graded() ? 0 : size;
    add_filters(in, counts.chain_steps, {dequantized, passes * size, size}, l.dequantize,
                l.low_pass, l.composite);
    l.lines.filtered = lines_near_shadow(frame.lights[source.first_light].joined, s);
    if (source.is_graded()) l.lines.filtered.dequantize = 0;
    add_filters(in, counts.chain_steps, l.lines.filtered, l.dequantize_near, l.low_pass_near,
                l.composite_near);
}

}  // namespace

template <class Depth>
FrameLedger frame_ledger(const FrameInputs& in, const FrameBuffers<Depth>& frame,
                         const FrameCounts& counts, std::size_t light,
                         const KnownCounts& known) {
    fixed::require(light < in.scene.light_count, "a ledger is of a light of the frame");
    const Settings& s = in.settings;
    const std::uint64_t pixels = std::uint64_t{1} << (2 * s.machine.xy_bits);
    const Method& method = method_of(in);
    FrameLedger l;
    l.has_map = method.has_map();
    l.on_ground = method.on_ground();
    if (known.light != nullptr) {
        l.light_counts = known.light->light_counts;
        l.light_inside = known.light->light_inside;
    }
    if (known.observer != nullptr) {
        l.observer_counts = known.observer->observer_counts;
        l.observer_inside = known.observer->observer_inside;
    }
    if (method.draws_light())
        l.light = drawing(in, in.matrices.lights[light].world_to_light, counts.lights[light].map,
                          *frame.draw, false, casters_of(in, light), known.light != nullptr,
                          l.light_counts, l.light_inside);
    l.observer = drawing(in, in.matrices.world_to_observer, counts.observer, *frame.draw, true, {},
                         known.observer != nullptr, l.observer_counts, l.observer_inside);
    const auto none = static_cast<Depth>(s.machine.background());
    l.visible = pixels - static_cast<std::uint64_t>(std::count(
                             frame.observer.depth.begin(), frame.observer.depth.end(), none));
    if (method.scene_cost != nullptr) method.scene_cost(in, light, l);
    method.stages<Depth>().frame_cost(in, light, frame, counts, l);
    l.lines.visible = lines_with_visible<Depth>(frame.observer.depth, s.machine.size_px(), none)
                          .count();
    for (std::size_t k = 0; k < in.scene.sources_used(); ++k)
        if (const Source source = in.scene.source(k); source.first_light == light)
            add_source(in, source, frame, counts.lights[light], l);
    return l;
}

#define UMBRA78_LEDGER(Depth)                                                             \
    template PostProcessLedger ledger_of(const ClockedPostProcess<Depth>&);               \
    template FrameLedger frame_ledger(const FrameInputs&, const FrameBuffers<Depth>&,     \
                                      const FrameCounts&, std::size_t, const KnownCounts&);
UMBRA78_LEDGER(hw::Depth16)
UMBRA78_LEDGER(hw::Depth32)
#undef UMBRA78_LEDGER

}  // namespace umbra78::shadow
