#include "shadow/frame/plan_cost.hpp"

#include "raster/drawing_cost.hpp"

#include <algorithm>

namespace umbra78::shadow {
namespace {

constexpr std::uint64_t control_points = 16;
constexpr std::uint64_t planes_of_a_copy = 2;  // a filter of no passes still reads and writes

std::uint64_t word(int v) { return static_cast<std::uint64_t>(v); }

// Points through the unit; those of an affine matrix are divided only where that is put back.
UnitCycles points(std::uint64_t count, const Settings& s, bool affine, bool divides,
                  const FramePlan& plan) {
    const int unit = hw::transform_cycles(s.machine, affine, plan.unit_work());
    const int a_point =
        s.timing.divider == hw::Divider::serial ? hw::serial_divide_cycles(s.machine) : 1;
    UnitCycles c;
    c.transform = count * word(unit);
    if (divides) c.divide = count * word(a_point);
    return c;
}

// Control points through the unit, and the operations of all that follows.
UnitCycles view(const DrawnFrame& drawn, const hw::MatrixWords& matrix,
                raster::DrawCounts counts, bool shades, const FramePlan& plan) {
    const Settings& s = drawn.inputs.settings;
    UnitCycles c = points(control_points * counts.patches, s, matrix.affine,
                          matrix.affine && plan.unit_work().divide, plan);
    hw::Operations o = raster::drawing_operations(counts, s.machine, matrix.affine, s.sampling,
                                                  shades, max_shininess(drawn.inputs.scene));
    const raster::DrawCounts points_alone{.patches = counts.patches};
    o.passes -= raster::drawing_operations(points_alone, s.machine, matrix.affine, s.sampling,
                                           false, 0).passes;
    c.operations = hw::unit_cycles(o, s.machine).one_after_the_other();
    return c;
}

UnitCycles post_process(const DrawnFrame& drawn, const FramePlan& plan) {
    const Settings& s = drawn.inputs.settings;
    const bool affine = drawn.inputs.matrices.observer_to_light.affine;
    const std::uint64_t pixels = std::uint64_t{1} << (2 * s.machine.xy_bits);
    const bool correct = s.form == Form::correct;
    const std::uint64_t drawn_pixels =
        plan.leaves_out(Omission::background_pixels) ? drawn.ledger.visible : pixels;
    const std::uint64_t tested = correct ? drawn.ledger.observer_counts.samples : drawn_pixels;
    UnitCycles c = points(tested, s, affine, !affine || plan.unit_work().divide, plan);
    if (!plan.leaves_out(Omission::noise)) {
        const int bits = 16 * hw::uniforms(drawn_dither(s).shape);
        const int cycles = (bits + s.timing.noise_bits - 1) / s.timing.noise_bits;
        c.noise = (correct ? tested : pixels) * word(cycles);
    }
    const int reads = s.lookup == Lookup::bilinear ? 4 / s.timing.light_banks : 1;
    c.store = tested * word(std::max(reads, 1)) + (correct ? 0 : 2 * pixels);
    return c;
}

template <std::size_t N>
bool is(Omission a, const Omission (&of)[N]) {
    return std::find(of, of + N, a) != of + N;
}

}  // namespace

StageCycles cycles_of(const FramePlan& plan, const DrawnFrame& drawn) {
    const FrameInputs& in = drawn.inputs;
    const std::uint64_t pixels = std::uint64_t{1} << (2 * in.settings.machine.xy_bits);
    StageCycles cycles{};
    const auto add = [&](FrameStage stage, bool left_out, UnitCycles c) {
        if (!left_out) cycles[static_cast<std::size_t>(stage)] = c;
    };
    const auto add_filter = [&](FrameStage stage, Omission omission, int passes,
                                const PhaseLedger& phase) {
        UnitCycles c;
        c.operations = passes > 0 ? phase.units.one_after_the_other() : planes_of_a_copy * pixels;
        add(stage, plan.leaves_out(omission) || plan.leaves_out(Omission::same_picture), c);
    };
    add(FrameStage::light,
        plan.leaves_out(Omission::same_light_map) || plan.leaves_out(Omission::light_map),
        view(drawn, in.matrices.world_to_light, drawn.ledger.light_counts,
             !plan.leaves_out(Omission::light_shading), plan));
    add(FrameStage::observer, plan.leaves_out(Omission::same_observer),
        view(drawn, in.matrices.world_to_observer, drawn.ledger.observer_counts, true, plan));
    add(FrameStage::post_process,
        plan.leaves_out(Omission::same_mask) || plan.leaves_out(Omission::post_process),
        post_process(drawn, plan));
    const FrameLedger& l = drawn.ledger;
    add_filter(FrameStage::dequantize, Omission::dequantize, in.settings.dequantize_passes,
               l.dequantize);
    add_filter(FrameStage::low_pass, Omission::low_pass, in.settings.low_pass_passes, l.low_pass);
    add_filter(FrameStage::composite, Omission::composite, 1, l.composite);
    return cycles;
}

std::uint64_t total(const StageCycles& cycles) {
    std::uint64_t sum = 0;
    for (const UnitCycles& c : cycles) sum += c.total();
    return sum;
}

Saving saving(Omission omission, const FramePlan& plan, const DrawnFrame& drawn) {
    using enum Omission;
    Saving s;
    // The correct form's points are counted as they are drawn; pixels, but for the visible, before.
    s.after_drawing = is(omission, {light_shading, background_pixels, post_process, same_mask}) ||
                      (drawn.inputs.settings.form == Form::correct &&
                       is(omission, {divide, w_row, constant_product, noise}));
    if (!plan.leaves_out(omission)) return s;
    FramePlan with = plan;
    for (std::size_t k = static_cast<std::size_t>(omission) + 1; k < omission_count; ++k)
        with.decisions[k].left_out = false;
    FramePlan without = with;
    without.at(omission).left_out = false;
    s.cycles = total(cycles_of(without, drawn)) - total(cycles_of(with, drawn));
    return s;
}

}  // namespace umbra78::shadow
