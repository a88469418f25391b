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
                 const raster::DrawCounts& counts, Keeps keeps, const FramePlan& plan,
                 const hw::Operations& more) {
    const Settings& s = drawn.inputs.settings;
    StageCycles c = points(control_points * counts.subdivided() + vertices * counts.facets, s,
                           matrix.affine, matrix.affine && plan.unit_work().divide, plan);
    hw::Operations o = drawing_operations(drawn.inputs, matrix, counts, keeps);
    o += more;
    const raster::DrawCounts points_alone{.patches = counts.subdivided(), .facets = counts.facets};
    o.passes -= drawing_operations(drawn.inputs, matrix, points_alone, Keeps::depth).passes;
    c.operations = method_of(drawn.inputs).units(o, s);
    return c;
}

// A light's part of a frame under a plan, added to the frame's.
class LightCosts {
public:
    LightCosts(const FramePlan& plan, const DrawnFrame& drawn, std::size_t light,
               FrameCycles& cycles)
        : plan_(plan), drawn_(drawn), in_(drawn.inputs), ledger_(drawn.ledgers[light]), l_(light),
          cycles_(cycles), pixels_(std::uint64_t{1} << (2 * in_.settings.machine.xy_bits)) {}

    void map() {
        if (leaves_out(Omission::same_light_map) || leaves_out(Omission::light_map) ||
            !method_of(in_).draws_light())
            return;
        // Drawn with the masks.
        if (ledger_.on_ground && (leaves_out(Omission::same_mask) ||
                                 leaves_out(Omission::post_process)))
            return;
        const bool inside = plan_.leaves_out(Omission::outside_surfaces);
        StageCycles copied;
        copied.store = 2 * pixels_;
        const bool shades = ledger_.has_map && !leaves_out(Omission::light_shading);
        const Keeps keeps = shades ? Keeps::shades : Keeps::depth;
        add(FrameStage::light, leaves_out(Omission::light_drawing)
                                   ? copied
                                   : view(drawn_, in_.matrices.lights[l_].world_to_light,
                                          inside ? ledger_.light_inside : ledger_.light_counts,
                                          keeps, plan_,
                                          map_operations(in_, inside ? ledger_.light_inside
                                                                     : ledger_.light_counts)));
    }
    void test() {
        if (leaves_out(Omission::same_mask) || leaves_out(Omission::post_process)) return;
        add(FrameStage::post_process, method_of(in_).plan_cost(drawn_, plan_, l_));
    }
    // Of the source that begins with this light.
    void filters(bool is_graded) {
        if (plan_.leaves_out(Omission::same_picture)) return;
        const Settings& s = in_.settings;
        StageCycles joined;
        joined.operations = ledger_.join.units;
        if (is_graded) add(FrameStage::join, joined);
        filter(FrameStage::dequantize, Omission::dequantize, s.dequantize_passes,
               ledger_.dequantize, ledger_.dequantize_near);
        filter(FrameStage::low_pass, Omission::low_pass, s.low_pass_passes, ledger_.low_pass,
               ledger_.low_pass_near);
        filter(FrameStage::composite, Omission::composite, 1, ledger_.composite,
               ledger_.composite_near);
    }

private:
    bool leaves_out(Omission o) const { return plan_.leaves_out(o, l_); }
    void add(FrameStage stage, const StageCycles& c) {
        cycles_[static_cast<std::size_t>(stage)] += c;
    }
    void filter(FrameStage stage, Omission omission, int passes, const PhaseLedger& all,
                const PhaseLedger& near_shadow) {
        if (leaves_out(omission)) return;
        StageCycles c;
        c.operations = leaves_out(Omission::lit_lines) ? near_shadow.units : all.units;
        if (passes == 0) c.operations = {.store = planes_of_a_copy * pixels_};
        add(stage, c);
    }

    const FramePlan& plan_;
    const DrawnFrame& drawn_;
    const FrameInputs& in_;
    const FrameLedger& ledger_;
    std::size_t l_;
    FrameCycles& cycles_;
    std::uint64_t pixels_;
};

template <std::size_t N>
bool is(Omission a, const Omission (&of)[N]) {
    return std::find(of, of + N, a) != of + N;
}

}  // namespace

StageCycles post_process_cycles(const DrawnFrame& drawn, const FramePlan& plan,
                                std::size_t light) {
    if (!has_pass(drawn.inputs, light)) return {};
    const Settings& s = drawn.inputs.settings;
    const bool affine = drawn.inputs.matrices.lights[light].observer_to_light.affine;
    const bool when_drawn = method_of(drawn.inputs).tests_when_drawn();
    const std::uint64_t pixels = std::uint64_t{1} << (2 * s.machine.xy_bits);
    // A line that is left out takes a cycle, for its bit and the noise's jump over it.
    const auto lines = static_cast<std::uint64_t>(s.machine.size_px());
    const bool whole = when_drawn || !plan.leaves_out(Omission::empty_lines);
    const FrameLedger& ledger = drawn.ledgers[light];
    const std::uint64_t empty = whole ? 0 : lines - ledger.lines.visible;
    const std::uint64_t read = pixels - empty * lines;
    const std::uint64_t tested = when_drawn ? ledger.observer_counts.samples
                                 : plan.leaves_out(Omission::background_pixels) ? ledger.visible
                                                                                : read;
    StageCycles c = points(tested, s, affine, !affine || plan.unit_work().divide, plan);
    c.operations = method_of(drawn.inputs)
                       .units(ledger.visible * test_operations(drawn.inputs, light), s);
    if (!plan.leaves_out(Omission::noise))
        c.noise = (when_drawn ? tested : read) *
                  word(hw::ClockedNoise::cycles_per_pixel(drawn_dither(s), s.timing));
    // Without them there are no taps, so no plan leaves them out.
    c.noise += (when_drawn ? tested : read) * word(tap_noise_cycles(window_of(s), s.timing));
    c.store = tested * word(LookupPipeline(s).fetch_cycles()) +
              (when_drawn ? 0 : read + pixels + empty);
    return c;
}

StageCycles counted_cycles(const DrawnFrame& drawn, const FramePlan&, std::size_t light) {
    StageCycles c;
    c.operations = drawn.ledgers[light].test.units;
    return c;
}

StageCycles& StageCycles::operator+=(const StageCycles& o) {
    transform += o.transform;
    divide += o.divide;
    noise += o.noise;
    store += o.store;
    operations.adders += o.operations.adders;
    operations.multipliers += o.operations.multipliers;
    operations.divider += o.operations.divider;
    operations.store += o.operations.store;
    return *this;
}

FrameCycles cycles_of(const FramePlan& plan, const DrawnFrame& drawn) {
    const FrameInputs& in = drawn.inputs;
    fixed::require(method_of(in).plan_cost != nullptr, "a method without the costs of a plan");
    fixed::require(drawn.ledgers.size() == in.scene.light_count, "costs: a ledger for each light");
    FrameCycles cycles{};
    for (std::size_t l = 0; l < in.scene.light_count; ++l) {
        LightCosts light(plan, drawn, l, cycles);
        light.map();
        light.test();
    }
    for (std::size_t s = 0; s < in.scene.sources_used(); ++s) {
        const Source source = in.scene.source(s);
        LightCosts(plan, drawn, source.first_light, cycles).filters(source.is_graded());
    }
    const FrameLedger& l = drawn.ledgers[0];
    if (!plan.leaves_out(Omission::same_observer))
        cycles[static_cast<std::size_t>(FrameStage::observer)] =
            view(drawn, in.matrices.world_to_observer,
                 plan.leaves_out(Omission::outside_surfaces) ? l.observer_inside
                                                             : l.observer_counts,
                 kept_of_observer(in), plan, {});
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
    if (!plan.leaves_out_any(omission)) return s;
    const auto needed = [](FramePlan& p, std::size_t o) {
        for (Decision& d : p.decisions[o]) d.left_out = false;
    };
    FramePlan with = plan;
    for (std::size_t k = static_cast<std::size_t>(omission) + 1; k < omission_count; ++k)
        needed(with, k);
    FramePlan without = with;
    needed(without, static_cast<std::size_t>(omission));
    s.cycles = total(cycles_of(without, drawn)) - total(cycles_of(with, drawn));
    return s;
}

}  // namespace umbra78::shadow
