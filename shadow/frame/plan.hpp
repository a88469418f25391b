// The plan of a frame: which work the frame does not need, and why.
//
// A frame is defined by doing everything: every row and product of the transform unit, every pixel,
// every filter. For a given scene much of that changes nothing. A plan is made from the scene, the
// settings, the loaded matrices and, if there is one, the frame before. It says what is left out.
// Leaving work out never changes a bit of any buffer: what would change bits is a setting of the
// machine and not an omission. The one exception is asked for (FrameInputs::shows_maps): a map
// that nothing reads is left empty.
//
// FramePlan{} leaves out nothing; the tests draw frames both ways and compare all buffers. The
// cycles that an omission saves are in shadow/frame/costs.hpp, its names in tools/render.
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
    // Parts of what is done all the same:
    light_drawing,      // of a light's map that is a copy of the observer's Z
    outside_surfaces,   // patches and facets outside a view, in its drawing
    empty_lines,        // scan lines with nothing visible, in the post-process
    lit_lines,          // scan lines with no shadow near, in filters and composite
    // Where the frame before left the same in the buffers:
    same_light_map,
    same_depth,        // the observer's Z; the intensities are drawn anew
    same_observer,     // Z and intensity; in the correct form the mask, too
    same_mask,
    same_picture,      // and the filtered masks
};
inline constexpr std::size_t omission_count = 20;

// What an omission is decided for: the frame, each light, or each source.
enum class Scope : std::uint8_t { frame, light, source };
constexpr Scope scope_of(Omission o) {
    using enum Omission;
    switch (o) {
        case light_shading:
        case light_map:
        case post_process:
        case light_drawing:
        case same_light_map:
        case same_mask: return Scope::light;
        case dequantize:
        case low_pass:
        case composite:
        case lit_lines: return Scope::source;
        default: return Scope::frame;
    }
}

// Why something is left out, or why it is not.
enum class Reason : std::uint8_t {
    // left out
    affine,               // the matrices' row W is (0, 0, 0, 1)
    partly_affine,        // that of one of the views
    depth_alone,          // the light's view keeps Z alone
    shadow_drawn,         // on a ground the shadow is drawn, and no point is tested
    no_map_kept,          // the method asks polygons or points, and there is no map
    no_shadow_in_view,    // every surface's shadow on the ground lies outside the picture
    nothing_there,        // a background pixel is lit whatever the test says
    dither_off,
    dither_rounds_to_zero,
    no_caster,            // every surface lies outside the light's view
    nothing_visible,      // every surface lies outside the observer's view
    outside_light,        // what the observer may see lies outside the light's volume
    nothing_shadowed,     // the mask is all lit: one of the three above
    no_passes,            // the filter is set to 0 passes
    graded,               // dequantizing follows edges, and this method's darkness has none
    invisible_shadow,     // density 0
    shadow_in_shading,    // the correct form's picture is finished when it is drawn
    same_view,            // the light's matrix has the words of the observer's
    outside_view,         // none of their samples can lie in the view
    no_shadow_near,       // filters and composite leave a lit line as it is
    unchanged,            // nothing that it is made from has changed
    // needed
    perspective,          // W is not constant
    may_shadow,
    tested_when_drawn,    // correct form: there are no pixels to test, only generated points
    masked_when_drawn,    // on a ground: the masks are drawn with the observer's view
    asked_for,            // a setting asks for it
    changed,              // something that it is made from has changed
    no_frame_before,
    other_view,           // the light's matrix has other words than the observer's
    other_map,            // the light's map keeps other depths than the nearest
    none_outside,         // every surface may have samples in both views
    not_held,             // the surfaces come batch by batch, and are not known beforehand
    none,                 // FramePlan{}: nothing is left out
};

struct Decision {
    bool left_out = false;
    Reason reason = Reason::none;
};

// Patches and facets that lie outside a view, so that none of their samples is in it.
struct OutsideSurfaces {
    std::array<std::uint64_t, max_lights> light{};
    std::uint64_t observer = 0;
};

struct FramePlan {
    // By omission and light; what is not of a light is decided under light 0, and what is of a
    // source (filters, composite) under the source's first light.
    std::array<std::array<Decision, max_lights>, omission_count> decisions{};
    OutsideSurfaces outside{};

    bool leaves_out(Omission o, std::size_t light = 0) const { return at(o, light).left_out; }
    // For any light.
    bool leaves_out_any(Omission o) const {
        for (const Decision& d : decisions[static_cast<std::size_t>(o)])
            if (d.left_out) return true;
        return false;
    }
    const Decision& at(Omission o, std::size_t light = 0) const {
        return decisions[static_cast<std::size_t>(o)][light];
    }
    Decision& at(Omission o, std::size_t light = 0) {
        return decisions[static_cast<std::size_t>(o)][light];
    }

    // What the units compute under this plan.
    hw::UnitWork unit_work() const {
        return {!leaves_out(Omission::constant_product), !leaves_out(Omission::w_row),
                !leaves_out(Omission::divide)};
    }
};

// `before`: the inputs of the frame that the buffers hold; null if they hold none.
FramePlan make_plan(const FrameInputs& now, const FrameInputs* before = nullptr);

}  // namespace umbra78::shadow
