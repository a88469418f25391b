#include "shadow/frame/plan.hpp"

#include "shadow/frame/culling.hpp"
#include "shadow/frame/drawing.hpp"
#include "shadow/frame/methods.hpp"
#include "shadow/frame/reuse.hpp"

namespace umbra78::shadow {
namespace {

using enum Reason;

constexpr Decision left_out(Reason why) { return {true, why}; }
constexpr Decision needed(Reason why) { return {false, why}; }

// The unit leaves out what it can for each matrix by itself; the plan says whether there is a
// matrix
// for which it can.
void plan_unit(const FrameInputs& now, FramePlan& plan) {
    const FrameMatrices& m = now.matrices;
    const std::size_t matrices = 1 + now.scene.light_count;
    std::size_t affine_matrices = m.world_to_observer.affine ? 1 : 0;
    for (std::size_t l = 0; l < now.scene.light_count; ++l)
        affine_matrices += m.lights[l].world_to_light.affine ? 1 : 0;
    const Decision d = affine_matrices == matrices ? left_out(affine)
                       : affine_matrices > 0       ? left_out(partly_affine)
                                                   : needed(perspective);
    for (const Omission o : {Omission::divide, Omission::w_row, Omission::constant_product})
        plan.at(o) = d;
}

// Why a method without a map leaves out what only a map needs.
Reason no_map_of(const Method& method) { return method.on_ground() ? shadow_drawn : no_map_kept; }

void plan_pixels(const FrameInputs& now, FramePlan& plan) {
    const Settings& s = now.settings;
    const Method& method = method_of(now);
    for (const Omission o : {Omission::background_pixels, Omission::empty_lines})
        plan.at(o) = !method.has_map()             ? left_out(no_map_of(method))
                     : method.tests_when_drawn() ? needed(tested_when_drawn)
                                                 : left_out(nothing_there);
    if (!method.has_map()) {
        plan.at(Omission::noise) = left_out(no_map_of(method));
        return;
    }
    plan.at(Omission::noise) = s.dither.shape == hw::DitherShape::none ? left_out(dither_off)
                               : hw::silent(s.dither, s.machine) ? left_out(dither_rounds_to_zero)
                                                                 : needed(asked_for);
}

void plan_test(const FrameInputs& now, std::size_t l, FramePlan& plan) {
    const Method& method = method_of(now);
    const bool has_map = method.has_map();
    plan.at(Omission::light_shading, l) = left_out(has_map ? depth_alone : no_map_of(method));
    if (now.scene.streamed) {
        for (const Omission o :
             {Omission::light_map, Omission::light_drawing, Omission::post_process})
            plan.at(o, l) = needed(not_held);
        return;
    }
    const Reach reach = cull(now, l);
    plan.outside.light[l] = reach.outside_light;
    plan.outside.observer = reach.outside_observer;
    const std::uint64_t all = now.scene.surfaces().count();
    if (!method.draws_light()) {
        for (const Omission o : {Omission::light_map, Omission::light_drawing})
            plan.at(o, l) = left_out(no_map_kept);
        plan.at(Omission::post_process, l) =
            reach.outside_observer == all ? left_out(nothing_visible) : needed(may_shadow);
        return;
    }
    const bool no_map = reach.outside_light == all - (has_map ? 0 : 1);  // the ground casts nothing
    const Reason nothing_cast = has_map ? no_caster : no_shadow_in_view;
    const bool unread = has_map && !now.shows_maps && !reach.into_light;
    plan.at(Omission::light_map, l) = no_map   ? left_out(nothing_cast)
                                      : unread ? left_out(outside_light)
                                               : needed(may_shadow);
    // Equal words draw equal Z, whatever the views that they come from.
    const bool same = now.matrices.lights[l].world_to_light == now.matrices.world_to_observer;
    const bool nearest =
        map_layers(now.settings) == 1 && casters_of(now, l).all_alike();
    plan.at(Omission::light_drawing, l) = !has_map   ? needed(masked_when_drawn)
                                          : !same    ? needed(other_view)
                                          : !nearest ? needed(other_map)
                                          : method.tests_when_drawn()
                                              ? needed(tested_when_drawn)
                                              : left_out(same_view);
    plan.at(Omission::post_process, l) = reach.outside_observer == all ? left_out(nothing_visible)
                                         : no_map ? left_out(nothing_cast)
                                         : !reach.into_light           ? left_out(outside_light)
                                                                       : needed(may_shadow);
}

// Of a source, under its first light.
void plan_filters(const FrameInputs& now, const Source& source, FramePlan& plan) {
    const Settings& s = now.settings;
    const Method& method = method_of(now);
    const std::size_t l = source.first_light;
    bool lit = true;
    for (std::size_t k = 0; k < source.lights; ++k)
        lit = lit && plan.leaves_out(Omission::post_process, l + k);
    const auto filter = [&](int passes) {
        return passes == 0 ? left_out(no_passes) : lit ? left_out(nothing_shadowed)
                                                       : needed(asked_for);
    };
    plan.at(Omission::dequantize, l) = filter(s.dequantize_passes);
    if (method.darkness == Darkness::graded || source.is_graded())
        plan.at(Omission::dequantize, l) = left_out(graded);
    plan.at(Omission::low_pass, l) = filter(s.low_pass_passes);
    plan.at(Omission::lit_lines, l) = method.in_shading ? needed(tested_when_drawn)
                                                        : left_out(no_shadow_near);
    plan.at(Omission::composite, l) = method.in_shading   ? left_out(shadow_in_shading)
                                      : s.density_q8 == 0 ? left_out(invisible_shadow)
                                      : lit               ? left_out(nothing_shadowed)
                                                          : needed(asked_for);
}

void plan_reuse(const FrameInputs& now, const FrameInputs* before, FramePlan& plan) {
    Reuse same{};
    if constexpr (hw::built(hw::Feature::reuse)) {
        if (before != nullptr) same = find_reuse(*before, now);
    }
    // A map that nothing read was not drawn.
    if (before != nullptr && !before->shows_maps)
        for (std::size_t l = 0; l < now.scene.light_count; ++l) {
            if (!same.light_map[l] || plan.at(Omission::light_map, l).reason == outside_light)
                continue;
            FramePlan was;
            plan_test(*before, l, was);
            same.light_map[l] = was.at(Omission::light_map, l).reason != outside_light;
        }
    const auto decision = [&](bool kept) {
        return kept ? left_out(unchanged)
                    : needed(before != nullptr ? changed : no_frame_before);
    };
    plan.at(Omission::same_depth) = decision(same.depth);
    plan.at(Omission::same_observer) = decision(same.observer);
    plan.at(Omission::same_picture) = decision(same.picture);
    bool any_test = false;
    for (std::size_t l = 0; l < now.scene.light_count; ++l) {
        plan.at(Omission::same_light_map, l) = decision(same.light_map[l]);
        plan.at(Omission::same_mask, l) = decision(same.mask[l]);
        any_test = any_test || !plan.leaves_out(Omission::post_process, l);
    }
    // A method that makes its masks with the observer's view goes through all of it again, whatever
    // its Z.
    if (method_of(now).tests_when_drawn() && any_test && !same.observer)
        plan.at(Omission::same_depth) =
            needed(method_of(now).in_shading ? tested_when_drawn : masked_when_drawn);
}

}  // namespace

FramePlan make_plan(const FrameInputs& now, const FrameInputs* before) {
    FramePlan plan;
    plan_unit(now, plan);
    plan_pixels(now, plan);
    for (std::size_t l = 0; l < now.scene.light_count; ++l) plan_test(now, l, plan);
    for (std::size_t s = 0; s < now.scene.sources_used(); ++s)
        plan_filters(now, now.scene.source(s), plan);
    bool any_outside = plan.outside.observer > 0;
    for (std::size_t l = 0; l < now.scene.light_count; ++l)
        any_outside = any_outside || plan.outside.light[l] > 0;
    plan.at(Omission::outside_surfaces) = now.scene.streamed ? needed(not_held)
                                          : any_outside     ? left_out(outside_view)
                                                            : needed(none_outside);
    plan_reuse(now, before, plan);
    return plan;
}

}  // namespace umbra78::shadow
