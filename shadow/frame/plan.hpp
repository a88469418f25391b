// A plan before a frame: what this frame does not need, and why.
//
// A frame is defined by doing everything: every row and product of the unit, every pixel, every
// filter. Much of it does nothing for a given scene. A plan, made from scene, settings and loaded
// matrices, and from the frame before it where there was one, says what is left out. Leaving out
// never changes a bit of any buffer: what would is a setting of the machine, not an omission.
//
// FramePlan{} leaves out nothing, so the work is done and seen to do nothing; the tests draw frames
// both ways. The cycles an omission saves are in shadow/frame/plan_cost.hpp, the words in tools/.
#pragma once

#include "shadow/frame/inputs.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace umbra78::shadow {

enum class Omission : std::uint8_t {
    divide,            // by the constant W of affine matrices
    w_row,             // those matrices' row W
    constant_product,  // their fourth products, by the constant 1
    light_shading,     // levels in the light's view
    background_pixels, // transform and lookup of pixels where nothing was drawn
    noise,             // dither words
    light_map,         // drawing the light's view
    post_process,      // transform, lookup and compare
    dequantize,
    low_pass,
    composite,
    // Where the frame before left the same in the buffers:
    same_light_map,
    same_depth,        // the observer's Z; the intensities are drawn anew
    same_observer,     // Z and intensity; in the correct form the mask, too
    same_mask,
    same_picture,      // and the filtered masks
};
inline constexpr std::size_t omission_count = 16;

// Why something is left out, or why it is not.
enum class Reason : std::uint8_t {
    // left out
    affine,               // the matrices' row W is (0, 0, 0, 1)
    partly_affine,        // that of one of the views
    depth_alone,          // the light's view keeps Z alone
    nothing_there,        // a background pixel is lit whatever comes out
    dither_off,
    dither_rounds_to_zero,
    no_caster,            // every patch lies outside the light's view
    nothing_visible,      // every patch lies outside the observer's view
    outside_light,        // what the observer may see lies outside the light's volume
    nothing_shadowed,     // the mask is all lit: one of the three above
    no_passes,
    invisible_shadow,     // density 0
    shadow_in_shading,    // the correct form's picture is finished when it is drawn
    stands_still,
    // needed
    perspective,          // W is not constant
    may_shadow,
    tested_when_drawn,    // correct form: there are no pixels to test, only generated points
    asked_for,            // a setting asks for it
    has_moved,
    no_frame_before,
    none,                 // FramePlan{}: nothing is left out
};

struct Decision {
    bool left_out = false;
    Reason reason = Reason::none;
};

// Patches that the block rule leaves out of a view whole.
struct OutsidePatches {
    std::uint64_t light = 0, observer = 0;
};

struct FramePlan {
    std::array<Decision, omission_count> decisions{};
    OutsidePatches outside{};

    bool leaves_out(Omission o) const { return at(o).left_out; }
    const Decision& at(Omission o) const { return decisions[static_cast<std::size_t>(o)]; }
    Decision& at(Omission o) { return decisions[static_cast<std::size_t>(o)]; }

    // What the units compute under this plan.
    hw::UnitWork unit_work() const {
        return {!leaves_out(Omission::constant_product), !leaves_out(Omission::w_row),
                !leaves_out(Omission::divide)};
    }
};

// `before`: the inputs of the frame that the buffers hold, if they hold one.
FramePlan make_plan(const FrameInputs& now, const FrameInputs* before = nullptr);

}  // namespace umbra78::shadow
