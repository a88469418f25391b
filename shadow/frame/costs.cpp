#include "shadow/frame/costs.hpp"

#include "shadow/frame/bias_cost.hpp"

#include <algorithm>

namespace umbra78::shadow {
namespace {

constexpr std::uint64_t control_points = 16, vertices = 3;
constexpr std::uint64_t planes_of_a_copy = 2;  // a filter of no passes still reads and writes

std::uint64_t word(int v) { return static_cast<std::uint64_t>(v); }

// Points through the unit; those of an affine matrix are divided only if the plan divides by 1.
StageCycles points(std::uint64_t count, const Settings& s, bool affine, bool divides,
                   const FramePlan& plan) {
    const int unit = hw::transform_cycles(s.machine, affine, plan.unit_work());
    const int a_point =
        s.timing.divider == hw::Divider::serial ? hw::serial_divide_cycles(s.machine) : 1;
    StageCycles c;
    c.transform = count * word(unit);
    if (divides) c.divide = count * word(a_point);
    return c;
}

// Control points through the unit, the operations of all that follows, and `more`.
StageCycles view(const DrawnFrame& drawn, const hw::MatrixWords& matrix,
                 const raster::DrawCounts& counts, bool shades, const FramePlan& plan,
                 const hw::Operations& more) {
    const Settings& s = drawn.inputs.settings;
    StageCycles c = points(control_points * counts.subdivided() + vertices * counts.facets, s,
                           matrix.affine, matrix.affine && plan.unit_work().divide, plan);
    hw::Operations o = drawing_operations(drawn.inputs, matrix, counts, shades);
    o += more;
    const raster::DrawCounts points_alone{.patches = counts.subdivided(), .facets = counts.facets};
    o.passes -= drawing_operations(drawn.inputs, matrix, points_alone, false).passes;
    c.operations = method_of(drawn.inputs).units(o, s);
    return c;
}

template <std::size_t N>
bool is(Omission a, const Omission (&of)[N]) {
    return std::find(of, of + N, a) != of + N;
}

}  // namespace

StageCycles post_process_cycles(const DrawnFrame& drawn, const FramePlan& plan,
                                std::size_t light) {
    const Settings& s = drawn.inputs.settings;
    const bool affine = drawn.inputs.matrices.lights[light].observer_to_light.affine;
    const bool when_drawn = method_of(drawn.inputs).tests_when_drawn();
    const std::uint64_t pixels = std::uint64_t{1} << (2 * s.machine.xy_bits);
    // A line that is left out takes a cycle, for its bit and the noise's jump over it.
    const auto lines = static_cast<std::uint64_t>(s.machine.size_px());
    const bool whole = when_drawn || !plan.leaves_out(Omission::empty_lines);
    const std::uint64_t empty = whole ? 0 : lines - drawn.ledger.lines.visible;
    const std::uint64_t read = pixels - empty * lines;
    const std::uint64_t tested = when_drawn ? drawn.ledger.observer_counts.samples
                                 : plan.leaves_out(Omission::background_pixels)
                                     ? drawn.ledger.visible
                                     : read;
    StageCycles c = points(tested, s, affine, !affine || plan.unit_work().divide, plan);
    if (s.receiver == Receiver::plane)
        c.operations = method_of(drawn.inputs)
                           .units(drawn.ledger.visible * cost::receiver_plane, s);
    if (!plan.leaves_out(Omission::noise))
        c.noise = (when_drawn ? tested : read) *
                  word(hw::ClockedNoise::cycles_per_pixel(drawn_dither(s), s.timing));
    c.store = tested * word(LookupPipeline(s).fetch_cycles()) +
              (when_drawn ? 0 : read + pixels + empty);
    return c;
}

FrameCycles cycles_of(const FramePlan& plan, const DrawnFrame& drawn) {
    const FrameInputs& in = drawn.inputs;
    const std::uint64_t pixels = std::uint64_t{1} << (2 * in.settings.machine.xy_bits);
    const Method& method = method_of(in);
    fixed::require(method.plan_cost != nullptr, "a method without the costs of a plan");
    FrameCycles cycles{};
    const auto add = [&](FrameStage stage, bool left_out, const StageCycles& c) {
        if (!left_out) cycles[static_cast<std::size_t>(stage)] = c;
    };
    const bool near = plan.leaves_out(Omission::lit_lines);
    const auto add_filter = [&](FrameStage stage, Omission omission, int passes,
                                const PhaseLedger& all, const PhaseLedger& near_shadow) {
        StageCycles c;
        c.operations = near ? near_shadow.units : all.units;
        if (passes == 0) c.operations = {.store = planes_of_a_copy * pixels};
        add(stage, plan.leaves_out(omission) || plan.leaves_out(Omission::same_picture), c);
    };
    const FrameLedger& l = drawn.ledger;
    const bool inside = plan.leaves_out(Omission::outside_surfaces);
    StageCycles copied;
    copied.store = 2 * pixels;
    add(FrameStage::light,
        plan.leaves_out(Omission::same_light_map) || plan.leaves_out(Omission::light_map),
        plan.leaves_out(Omission::light_drawing)
            ? copied
            : view(drawn, in.matrices.lights[0].world_to_light,
                   inside ? l.light_inside : l.light_counts,
                   !plan.leaves_out(Omission::light_shading), plan,
                   map_operations(in, inside ? l.light_inside : l.light_counts)));
    add(FrameStage::observer, plan.leaves_out(Omission::same_observer),
        view(drawn, in.matrices.world_to_observer, inside ? l.observer_inside : l.observer_counts,
             true, plan, {}));
    add(FrameStage::post_process,
        plan.leaves_out(Omission::same_mask) || plan.leaves_out(Omission::post_process),
        method.plan_cost(drawn, plan, 0));
    add_filter(FrameStage::dequantize, Omission::dequantize, in.settings.dequantize_passes,
               l.dequantize, l.dequantize_near);
    add_filter(FrameStage::low_pass, Omission::low_pass, in.settings.low_pass_passes, l.low_pass,
               l.low_pass_near);
    add_filter(FrameStage::composite, Omission::composite, 1, l.composite, l.composite_near);
    return cycles;
}

std::uint64_t total(const FrameCycles& cycles) {
    std::uint64_t sum = 0;
    for (const StageCycles& c : cycles) sum += c.total();
    return sum;
}

Saving saving(Omission omission, const FramePlan& plan, const DrawnFrame& drawn) {
    using enum Omission;
    Saving s;
    // Points that are tested when drawn are counted by the drawing; so are the visible pixels. The
    // pixels of the frame are known before.
    s.after_drawing = is(omission, {light_shading, background_pixels, post_process,
                                    light_drawing, empty_lines, lit_lines, same_mask}) ||
                      (method_of(drawn.inputs).tests_when_drawn() &&
                       is(omission, {divide, w_row, constant_product, noise}));
    if (!plan.leaves_out(omission)) return s;
    FramePlan with = plan;
    for (std::size_t k = static_cast<std::size_t>(omission) + 1; k < omission_count; ++k)
        with.at(static_cast<Omission>(k)).left_out = false;
    FramePlan without = with;
    without.at(omission).left_out = false;
    s.cycles = total(cycles_of(without, drawn)) - total(cycles_of(with, drawn));
    return s;
}

}  // namespace umbra78::shadow
