#include "shadow/plan_cost.hpp"

#include "hw/divider.hpp"

#include <algorithm>

namespace umbra78::shadow {
namespace {

constexpr std::uint64_t control_points = 16;
constexpr std::uint64_t planes_of_a_filter = 3;  // the mask, Z or intensity, and what is written

std::uint64_t word(int v) { return static_cast<std::uint64_t>(v); }

// Points through the unit; those of an affine matrix are divided only where that is put back.
UnitCycles points(std::uint64_t count, const Settings& s, bool affine, bool divides,
                  const Plan& plan) {
    const int unit = hw::transform_cycles(s.machine, affine, plan.unit_work());
    const int a_point =
        s.timing.divider == hw::Divider::serial ? hw::serial_divide_cycles(s.machine) : 1;
    UnitCycles c;
    c.transform = count * word(unit);
    if (divides) c.divide = count * word(a_point);
    return c;
}

UnitCycles view(const DrawnFrame& drawn, const hw::MatrixWords& matrix, const Plan& plan) {
    return points(control_points * drawn.inputs.scene.patches.size(), drawn.inputs.settings,
                  matrix.affine, matrix.affine && plan.unit_work().divide, plan);
}

UnitCycles post_process(const DrawnFrame& drawn, const Plan& plan) {
    const Settings& s = drawn.inputs.settings;
    const bool affine = drawn.inputs.matrices.observer_to_light.affine;
    const std::uint64_t pixels = std::uint64_t{1} << (2 * s.machine.xy_bits);
    const bool correct = s.form == Form::correct;
    const std::uint64_t tested = correct ? drawn.counts.observer.samples
                                 : plan.leaves_out(Omission::background_pixels) ? drawn.visible
                                                                                : pixels;
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

StageCycles cycles_of(const Plan& plan, const DrawnFrame& drawn) {
    const FrameInputs& in = drawn.inputs;
    const std::uint64_t pixels = std::uint64_t{1} << (2 * in.settings.machine.xy_bits);
    StageCycles cycles{};
    const auto add = [&](Stage stage, bool left_out, UnitCycles c) {
        if (!left_out) cycles[static_cast<std::size_t>(stage)] = c;
    };
    const auto add_filter = [&](Stage stage, Omission omission, int passes) {
        UnitCycles c;
        c.store = planes_of_a_filter * pixels * word(std::max(passes, 1));
        add(stage, plan.leaves_out(omission) || plan.leaves_out(Omission::same_picture), c);
    };
    add(Stage::light,
        plan.leaves_out(Omission::same_light_map) || plan.leaves_out(Omission::light_map),
        view(drawn, in.matrices.world_to_light, plan));
    add(Stage::observer, plan.leaves_out(Omission::same_observer),
        view(drawn, in.matrices.world_to_observer, plan));
    add(Stage::post_process,
        plan.leaves_out(Omission::same_mask) || plan.leaves_out(Omission::post_process),
        post_process(drawn, plan));
    add_filter(Stage::dequantize, Omission::dequantize, 1);  // all its passes in one stream
    add_filter(Stage::low_pass, Omission::low_pass, in.settings.low_pass_passes);
    add_filter(Stage::composite, Omission::composite, 1);
    return cycles;
}

std::uint64_t total(const StageCycles& cycles) {
    std::uint64_t sum = 0;
    for (const UnitCycles& c : cycles) sum += c.total();
    return sum;
}

Saving saving(Omission omission, const Plan& plan, const DrawnFrame& drawn) {
    using enum Omission;
    Saving s;
    s.counted = !is(omission, {light_shading, same_depth});
    // The correct form's points are counted as they are drawn; pixels, but for the visible, before.
    s.after_drawing = is(omission, {background_pixels, post_process, same_mask}) ||
                      (drawn.inputs.settings.form == Form::correct &&
                       is(omission, {divide, w_row, constant_product, noise}));
    if (!plan.leaves_out(omission)) return s;
    Plan with = plan;
    for (std::size_t k = static_cast<std::size_t>(omission) + 1; k < omission_count; ++k)
        with.decisions[k].left_out = false;
    Plan without = with;
    without.at(omission).left_out = false;
    s.cycles = total(cycles_of(without, drawn)) - total(cycles_of(with, drawn));
    return s;
}

}  // namespace umbra78::shadow
