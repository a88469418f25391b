#include "shadow/frame/plan.hpp"

#include "shadow/frame/culling.hpp"
#include "shadow/frame/reuse.hpp"

namespace umbra78::shadow {
namespace {

using enum Reason;

constexpr Decision left_out(Reason why) { return {true, why}; }
constexpr Decision needed(Reason why) { return {false, why}; }

// The unit leaves out per matrix; a plan says whether there is any it can be left out for.
void plan_unit(const FrameMatrices& m, FramePlan& plan) {
    const int affine_matrices = m.world_to_observer.affine + m.world_to_light.affine;
    const Decision d = affine_matrices == 2   ? left_out(affine)
                       : affine_matrices == 1 ? left_out(partly_affine)
                                              : needed(perspective);
    for (const Omission o : {Omission::divide, Omission::w_row, Omission::constant_product})
        plan.at(o) = d;
}

void plan_test(const FrameInputs& now, const Reach& reach, FramePlan& plan) {
    const Settings& s = now.settings;
    const std::uint64_t all = now.scene.patches.size();
    const bool correct = s.form == Form::correct;
    plan.at(Omission::light_shading) = left_out(depth_alone);
    plan.at(Omission::background_pixels) =
        correct ? needed(tested_when_drawn) : left_out(nothing_there);
    plan.at(Omission::noise) = s.dither.shape == hw::DitherShape::none ? left_out(dither_off)
                               : hw::silent(s.dither, s.machine) ? left_out(dither_rounds_to_zero)
                                                                 : needed(asked_for);
    const bool no_map = reach.outside_light == all;
    plan.at(Omission::light_map) = no_map ? left_out(no_caster) : needed(may_shadow);
    plan.at(Omission::post_process) = reach.outside_observer == all ? left_out(nothing_visible)
                                      : no_map                      ? left_out(no_caster)
                                      : !reach.into_light           ? left_out(outside_light)
                                                                    : needed(may_shadow);
}

void plan_filters(const Settings& s, FramePlan& plan) {
    const bool lit = plan.leaves_out(Omission::post_process);
    const auto filter = [&](int passes) {
        return passes == 0 ? left_out(no_passes) : lit ? left_out(nothing_shadowed)
                                                       : needed(asked_for);
    };
    plan.at(Omission::dequantize) = filter(s.dequantize_passes);
    plan.at(Omission::low_pass) = filter(s.low_pass_passes);
    plan.at(Omission::composite) = s.form == Form::correct ? left_out(shadow_in_shading)
                                   : s.density_q8 == 0     ? left_out(invisible_shadow)
                                   : lit                   ? left_out(nothing_shadowed)
                                                           : needed(asked_for);
}

void plan_standing(const FrameInputs& now, const FrameInputs* before, FramePlan& plan) {
    const Reuse still = before != nullptr ? find_reuse(*before, now) : Reuse{};
    const auto decide = [&](Omission o, bool same) {
        plan.at(o) = same ? left_out(stands_still)
                          : needed(before != nullptr ? has_moved : no_frame_before);
    };
    decide(Omission::same_light_map, still.light_map);
    decide(Omission::same_depth, still.depth);
    // The correct form goes through all its points again; their Z is no help.
    if (now.settings.form == Form::correct && !plan.leaves_out(Omission::post_process) &&
        !still.observer)
        plan.at(Omission::same_depth) = needed(tested_when_drawn);
    decide(Omission::same_observer, still.observer);
    decide(Omission::same_mask, still.mask);
    decide(Omission::same_picture, still.picture);
}

}  // namespace

FramePlan make_plan(const FrameInputs& now, const FrameInputs* before) {
    FramePlan plan;
    const Reach reach = cull(now);
    plan.outside = {reach.outside_light, reach.outside_observer};
    plan_unit(now.matrices, plan);
    plan_test(now, reach, plan);
    plan_filters(now.settings, plan);
    plan_standing(now, before, plan);
    return plan;
}

}  // namespace umbra78::shadow
