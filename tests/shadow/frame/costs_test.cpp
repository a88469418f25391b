// The cost of a plan: the closed forms, and savings that add up to the difference.
#include "shadow/frame/costs.hpp"

#include "tests/shadow/frame/cost_by_hand.hpp"
#include "tests/shadow/frame/planned_scenes.hpp"
#include "tests/support/effort.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace umbra78::shadow {
namespace {

using test::PlannedFrame;
using test::PlannedScene;

FrameLedger ledger_of(const PlannedFrame& f) {
    return frame_ledger(f.inputs, f.frame.buffers, f.frame.counts);
}

// Scan lines with something in them, and those within `reach` lines of one, counted pixel by pixel.
template <class Plane>
std::uint64_t lines_near(const Plane& plane, int size, int reach, auto&& counts) {
    std::uint64_t n = 0;
    for (int y = 0; y < size; ++y) {
        bool near = false;
        for (int k = std::max(0, y - reach); k <= std::min(size - 1, y + reach); ++k)
            for (int x = 0; x < size; ++x)
                near = near || counts(plane[static_cast<std::size_t>(k * size + x)]);
        n += near;
    }
    return n;
}

// Savings are what the costs differ by, omission by omission, so they add up to the whole; a frame
// in which nothing has moved costs nothing.
TEST(PlanCost, SavingsAddUp) {
    for (PlannedScene& planned : test::planned_scenes()) {
        if (umbra78::test::sanitized) planned.settings.machine.xy_bits = 5;
        for (const bool still : {false, true}) {
            PlannedFrame f(planned);
            if (method_of(f.inputs).plan_cost == nullptr) continue;  // the AP-120B
            const FramePlan plan = make_plan(f.inputs, still ? &f.inputs : nullptr);
            f.draw(make_plan(f.inputs));
            const FrameLedger ledger = ledger_of(f);
            const DrawnFrame drawn{f.inputs, ledger};
            std::uint64_t saved = 0;
            for (std::size_t k = 0; k < omission_count; ++k)
                saved += saving(static_cast<Omission>(k), plan, drawn).cycles;
            const std::uint64_t all = total(cycles_of(FramePlan{}, drawn));
            const std::uint64_t left = total(cycles_of(plan, drawn));
            EXPECT_EQ(saved, all - left) << planned.name;
            EXPECT_TRUE(!still || left == 0) << planned.name;
        }
    }
}

// Figure 6, by hand: 128 patches of 16 points, 128 x 128 pixels, four multipliers, a row a cycle.
TEST(PlanCost, IsTheClosedForm) {
    const PlannedScene planned = test::planned_scene("figure 6");
    PlannedFrame f(planned);
    const FramePlan plan = make_plan(f.inputs);
    f.draw(plan);
    const FrameLedger ledger = ledger_of(f);
    const std::uint64_t seen = ledger.visible, n = 128 * 128;
    ASSERT_EQ(seen, f.frame.counts.lights[0].post_process.visible);
    const DrawnFrame drawn{f.inputs, ledger};
    const FrameCycles c = cycles_of(plan, drawn);
    EXPECT_EQ(c[0].transform, 128u * 16 * 3);
    EXPECT_EQ(c[1].transform, 128u * 16 * 3);
    // Operations of the drawing without the control points, which the transform unit has.
    const test::Busy light = test::drawing_by_hand(ledger.light_counts, true, false, 5, 0);
    const test::Busy observer = test::drawing_by_hand(ledger.observer_counts, true, true, 5, 0);
    EXPECT_EQ(c[0].operations.one_after_the_other(), light.one_after_the_other());
    EXPECT_EQ(c[1].operations.one_after_the_other(), observer.one_after_the_other());
    EXPECT_EQ(c[0].total(), 128u * 16 * 3 + light.one_after_the_other());
    EXPECT_EQ(c[2].transform, seen * 3);
    EXPECT_EQ(c[2].divide, 0u);
    const auto& light_buffers = f.frame.buffers.lights[0];
    const std::uint64_t lines =
        lines_near(f.frame.buffers.observer.depth, 128, 0, [](auto z) { return z != 65535; });
    const auto shadow_lines = [&](int reach) {
        return lines_near(light_buffers.mask, 128, reach, [](auto m) { return m != 0; });
    };
    const std::uint64_t empty = 128 - lines, read = 128 * lines;
    ASSERT_GT(empty, 0u);
    EXPECT_EQ(c[2].noise, read);  // 12 bytes twice are the 192 bits of a cycle
    EXPECT_EQ(c[2].store, seen * 4 + read + n + empty);
    const std::uint64_t steps = f.frame.counts.lights[0].chain_steps;
    const std::array<std::uint64_t, 3> near{128 * shadow_lines(0), 128 * shadow_lines(1),
                                            128 * shadow_lines(2)};
    ASSERT_GT(near[0], 128u * 20);
    ASSERT_LT(near[2], n);
    EXPECT_EQ(f.frame.counts.lights[0].filtered_lines,
              (FilteredLines{near[0] / 128, (near[1] + near[2]) / 128, near[2] / 128}));
    EXPECT_EQ(f.frame.counts.lights[0].filtered_lines, ledger.lines.filtered);
    const std::uint64_t dequantized =
        test::dequantize_by_hand(steps, near[0], 1).one_after_the_other();
    const std::uint64_t low_passed =
        test::low_pass_by_hand(near[1] + near[2], 1).one_after_the_other();
    const std::uint64_t darkened = test::composite_by_hand(near[2]).one_after_the_other();
    EXPECT_EQ(c[4].total(), dequantized);
    EXPECT_EQ(c[5].total(), low_passed);
    EXPECT_EQ(c[6].total(), darkened);
    const std::uint64_t quotient =
        static_cast<std::uint64_t>(hw::serial_divide_cycles(f.inputs.settings.machine));
    const auto saved = [&](Omission o) { return saving(o, plan, drawn).cycles; };
    // The first in the order are counted before background pixels are left out.
    EXPECT_EQ(saved(Omission::divide), (2 * 2048 + n) * quotient);
    EXPECT_EQ(saved(Omission::w_row), 2 * 2048 + n);
    EXPECT_EQ(saved(Omission::constant_product), 0u);  // four multipliers take a row at once
    EXPECT_EQ(saved(Omission::background_pixels), (n - seen) * (3 + 4));
    const test::Busy shaded = test::drawing_by_hand(ledger.light_counts, true, true, 5, 0);
    EXPECT_EQ(saved(Omission::light_shading),
              shaded.one_after_the_other() - light.one_after_the_other());
    EXPECT_EQ(saved(Omission::empty_lines), 2 * (n - read) - empty);  // noise and the read
    EXPECT_EQ(saved(Omission::lit_lines),
              test::dequantize_by_hand(steps, n, 1).one_after_the_other() - dequantized +
                  test::low_pass_by_hand(n, 2).one_after_the_other() - low_passed +
                  test::composite_by_hand(n).one_after_the_other() - darkened);
    for (const Omission needed : {Omission::noise, Omission::light_map, Omission::post_process,
                                  Omission::dequantize, Omission::low_pass, Omission::composite,
                                  Omission::light_drawing, Omission::outside_surfaces,
                                  Omission::same_light_map, Omission::same_picture})
        EXPECT_EQ(saved(needed), 0u);
    for (const Omission late : {Omission::background_pixels, Omission::empty_lines,
                                Omission::lit_lines, Omission::light_drawing})
        EXPECT_TRUE(saving(late, plan, drawn).after_drawing);
    EXPECT_FALSE(saving(Omission::noise, plan, drawn).after_drawing);
}

// A scene whose shadow is left out altogether, each saving by hand.
TEST(PlanCost, SavingsOfASceneWithoutACaster) {
    const PlannedScene planned = test::planned_scene("no caster");
    PlannedFrame f(planned);
    const FramePlan plan = make_plan(f.inputs);
    f.draw(FramePlan{});
    const FrameLedger ledger = ledger_of(f);
    const DrawnFrame drawn{f.inputs, ledger};
    const std::uint64_t seen = ledger.visible, n = 128 * 128;
    const auto saved = [&](Omission o) { return saving(o, plan, drawn).cycles; };
    // All patches are tested for the light's view, and no block is drawn.
    EXPECT_EQ(saved(Omission::light_map), 2048u * 3 + (3u * 128 * (60 + 43)) / 4);
    EXPECT_EQ(saved(Omission::post_process), seen * 3 + seen * 4 + 2 * n + n);
    EXPECT_EQ(saved(Omission::dequantize),
              test::dequantize_by_hand(0, n, 1).one_after_the_other());
    EXPECT_EQ(saved(Omission::low_pass), test::low_pass_by_hand(n, 2).one_after_the_other());
    EXPECT_EQ(saved(Omission::composite), test::composite_by_hand(n).one_after_the_other());
    const FrameCycles left = cycles_of(plan, drawn);
    EXPECT_EQ(total(left), left[1].total()) << "the observer's view alone";
}

// A patch outside costs its 16 points, its corrections, and the bounds that show it.
TEST(PlanCost, SavingsOfSurfacesOutside) {
    const PlannedScene planned = test::planned_scene("outside the light");
    PlannedFrame f(planned);
    const FramePlan plan = make_plan(f.inputs);
    f.draw(plan);
    ASSERT_EQ(f.frame.counts.observer.patches, 128u);
    ASSERT_EQ(f.frame.counts.lights[0].map.patches, 32u);
    const FrameLedger ledger = ledger_of(f);
    EXPECT_EQ(ledger.light_counts.patches, 160u);
    EXPECT_EQ(ledger.light_inside.patches, 32u);
    EXPECT_EQ(ledger.observer_inside.patches, 128u);
    EXPECT_EQ(ledger.light_inside.samples, ledger.light_counts.samples);
    const DrawnFrame drawn{f.inputs, ledger};
    // The observer's view shades: three more components have corrections.
    const std::uint64_t adds = 128 * 3 * (60 + 43) + 32 * (6 * 60 + 3 * 43);
    EXPECT_EQ(saving(Omission::outside_surfaces, plan, drawn).cycles, 160u * 48 + adds / 4);
    EXPECT_FALSE(saving(Omission::outside_surfaces, plan, drawn).after_drawing);
}

// A light that sees what the observer sees: its view is a copy, a read and a write of each pixel.
TEST(PlanCost, SavingsOfALightThatSeesTheSame) {
    const PlannedScene planned = test::planned_scene("same view");
    PlannedFrame f(planned);
    const FramePlan plan = make_plan(f.inputs);
    f.draw(plan);
    const FrameLedger ledger = ledger_of(f);
    const DrawnFrame drawn{f.inputs, ledger};
    const std::uint64_t view = 2048 * 3 + test::drawing_by_hand(ledger.light_counts, true, false, 5,
                                                                0).one_after_the_other();
    EXPECT_EQ(saving(Omission::light_drawing, plan, drawn).cycles, view - 2 * 128 * 128);
    EXPECT_EQ(cycles_of(plan, drawn)[0].total(), 2u * 128 * 128);
}

// Filters of no passes are a copy: a read and a write of each pixel.
TEST(PlanCost, AFilterOfNoPassesIsACopy) {
    const PlannedScene planned = test::planned_scene("figure 3");
    PlannedFrame f(planned);
    const FramePlan plan = make_plan(f.inputs);
    f.draw(plan);
    const FrameLedger ledger = ledger_of(f);
    const DrawnFrame drawn{f.inputs, ledger};
    EXPECT_EQ(saving(Omission::dequantize, plan, drawn).cycles, 2u * 128 * 128);
    EXPECT_EQ(saving(Omission::low_pass, plan, drawn).cycles, 2u * 128 * 128);
}

TEST(PlanCost, OneMultiplierIsSparedTheConstantProducts) {
    PlannedScene planned = test::planned_scene("figure 3");
    planned.settings.machine.multipliers = 1;
    PlannedFrame f(planned);
    const FramePlan plan = make_plan(f.inputs);
    f.draw(plan);
    const FrameLedger ledger = ledger_of(f);
    const DrawnFrame drawn{f.inputs, ledger};
    const std::uint64_t points = 2 * 2048 + 128 * 128;
    EXPECT_EQ(saving(Omission::w_row, plan, drawn).cycles, points * 4);
    EXPECT_EQ(saving(Omission::constant_product, plan, drawn).cycles, points * 3);
}

// The rows of hw/MACHINE.md, section 27, by hand: what a frame with kept normals costs more in the
// observer's view, and in its test in place of the neighbours.
TEST(PlanCost, OfKeptNormals) {
    const auto ledger = [](PlannedScene p, SlopeSource source, raster::ShadingRule rule) {
        p.settings.slope_source = source;
        p.settings.shading = rule;
        PlannedFrame f(p);
        f.draw(make_plan(f.inputs));
        return ledger_of(f);
    };
    for (const char* name : {"kept normals", "kept, unshaded"})
        for (const auto rule : {raster::ShadingRule::phong, raster::ShadingRule::none}) {
            SCOPED_TRACE(name);
            const PlannedScene scene = test::planned_scene(name);
            const FrameLedger with = ledger(scene, SlopeSource::normals, rule);
            const FrameLedger without = ledger(scene, SlopeSource::depths, rule);
            const raster::DrawCounts& counts = with.observer_counts;
            const std::uint64_t facets = counts.facet_samples, leaves = counts.samples - facets;
            ASSERT_GT(facets, 100u);
            ASSERT_GT(leaves, 100u);
            const hw::Operations &a = with.observer.operations, &b = without.observer.operations;
            EXPECT_EQ(a.accesses - b.accesses, 3 * counts.samples);
            if (rule == raster::ShadingRule::phong) {
                EXPECT_EQ(a.adds - b.adds, 11 * leaves + 6 * facets);
                EXPECT_EQ(a.passes - b.passes, 3 * facets);
                EXPECT_EQ(a.quotient_bits, b.quotient_bits) << "no normal is made a unit";
            } else {  // the components of the normals, the blocks' corners and the facets' own
                EXPECT_EQ(a.quotient_bits - b.quotient_bits,
                          75 * (4 * counts.blocks + counts.facets));
                EXPECT_EQ(a.adds - b.adds,
                          22 * leaves + 6 * facets + 4 * 48 * counts.blocks + 12 * counts.facets +
                              3 * (60 * counts.subdivided() + 16 * counts.splits));
            }
            EXPECT_EQ(with.light.operations.adds, without.light.operations.adds);
            const bool plane = scene.settings.receiver == Receiver::plane;
            EXPECT_EQ(with.test.operations.accesses, 3 * with.visible);
            EXPECT_EQ(without.test.operations.accesses, 13 * with.visible);
            EXPECT_EQ(with.test.operations.adds, (plane ? 22 : 25) * with.visible);
            EXPECT_EQ(with.test.operations.quotient_bits, (plane ? 80 : 79) * with.visible);
        }
}

}  // namespace
}  // namespace umbra78::shadow
