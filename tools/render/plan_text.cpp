#include "tools/render/plan_text.hpp"

#include <array>

namespace umbra78::tools {
namespace {

using shadow::Omission;
using shadow::FramePlan;
using shadow::Reason;
using shadow::FrameStage;

struct Names {
    std::string_view key, name;
};

constexpr std::array<Names, shadow::omission_count> omissions{{
    {"divide", "the divide by W"},
    {"w_row", "row W of the matrices"},
    {"constant_product", "the fourth product"},
    {"light_shading", "shading in the light's view"},
    {"background_pixels", "background pixels"},
    {"noise", "the noise"},
    {"light_map", "the light's view"},
    {"post_process", "the post-process"},
    {"dequantize", "edge dequantizing"},
    {"low_pass", "the low-pass"},
    {"composite", "the composite"},
    {"light_drawing", "drawing the light's view"},
    {"outside_surfaces", "surfaces outside a view"},
    {"empty_lines", "empty scan lines"},
    {"lit_lines", "filtering lit scan lines"},
    {"same_light_map", "the light map, kept"},
    {"same_depth", "the observer's Z, kept"},
    {"same_observer", "the observer's view, kept"},
    {"same_mask", "the mask, kept"},
    {"same_picture", "filters and picture, kept"},
}};

constexpr std::array<Names, shadow::stage_count> stages{{
    {"light", "light's view"},
    {"observer", "observer's view"},
    {"post_process", "post-process"},
    {"join", "darkness of an area"},
    {"dequantize", "edge dequantizing"},
    {"low_pass", "low-pass"},
    {"composite", "composite"},
}};

}  // namespace

std::string_view key_of(Omission o) { return omissions[static_cast<std::size_t>(o)].key; }
std::string_view name_of(Omission o, bool has_map) {
    if (has_map) return omissions[static_cast<std::size_t>(o)].name;
    switch (o) {
        case Omission::light_shading: return "shading of the shadow";
        case Omission::light_map: return "the shadow";
        case Omission::post_process: return "the masks";
        case Omission::light_drawing: return "drawing the shadow";
        case Omission::same_light_map: return "the shadow, kept";
        default: return name_of(o, true);
    }
}
std::string_view key_of(FrameStage s) { return stages[static_cast<std::size_t>(s)].key; }
std::string_view name_of(FrameStage s, bool has_map) {
    if (!has_map && s == FrameStage::light) return "shadow, flat";
    if (!has_map && s == FrameStage::post_process) return "masks";
    return stages[static_cast<std::size_t>(s)].name;
}

std::string_view explain(Reason reason) {
    switch (reason) {
        case Reason::affine: return "no view is in perspective: W is 1";
        case Reason::partly_affine: return "W is 1 in the view that is not in perspective";
        case Reason::depth_alone: return "the light map holds only Z";
        case Reason::shadow_drawn: return "on a ground the shadow is drawn, and no pixel is tested";
        case Reason::no_map_kept: return "the method keeps no depth map";
        case Reason::no_shadow_in_view:
            return "every surface's shadow on the ground lies outside the picture";
        case Reason::nothing_there: return "nothing was drawn there, so nothing is in shadow";
        case Reason::dither_off: return "dither is none";
        case Reason::dither_rounds_to_zero: return "dither is so small that every word is 0";
        case Reason::no_caster: return "every surface lies outside the light's view";
        case Reason::nothing_visible: return "every surface lies outside the observer's view";
        case Reason::outside_light: return "nothing visible lies in the light's volume";
        case Reason::nothing_shadowed: return "without the post-process the mask is all lit";
        case Reason::no_passes: return "it is set to 0 passes";
        case Reason::graded: return "it follows edges, and the method's darkness is graded";
        case Reason::invisible_shadow: return "density is 0";
        case Reason::shadow_in_shading: return "the correct form's shadow is in the shading";
        case Reason::same_view: return "the light sees what the observer sees: its map is a copy";
        case Reason::outside_view: return "nothing of them can lie in the view";
        case Reason::no_shadow_near: return "no shadow is near, so a filter would change nothing";
        case Reason::unchanged: return "nothing that it is made from has changed";
        case Reason::perspective: return "both views are in perspective: W varies";
        case Reason::may_shadow: return "a shadow may fall on something visible";
        case Reason::tested_when_drawn: return "the correct form tests points as they are drawn";
        case Reason::masked_when_drawn: return "on a ground the masks are drawn with the picture";
        case Reason::asked_for: return "a setting asks for it";
        case Reason::changed: return "something that it is made from has changed";
        case Reason::no_frame_before: return "there is no frame before it";
        case Reason::other_map: return "the light's map keeps other depths than the nearest";
        case Reason::other_view: return "light and observer see different things";
        case Reason::none_outside: return "every surface may lie in both views";
        case Reason::not_held: return "the surfaces are a stream, not known beforehand";
        case Reason::none: return "the plan leaves out nothing";
    }
    return "";
}

std::vector<std::string> kept(const FramePlan& plan) {
    std::vector<std::string> keys;
    for (std::size_t k = static_cast<std::size_t>(Omission::same_light_map);
         k < shadow::omission_count; ++k)
        if (plan.leaves_out(static_cast<Omission>(k))) keys.emplace_back(omissions[k].key);
    return keys;
}

std::string grouped(std::uint64_t n) {
    std::string text = std::to_string(n);
    for (std::size_t at = text.size(); at > 3; at -= 3) text.insert(at - 3, 1, ' ');
    return text;
}

}  // namespace umbra78::tools
