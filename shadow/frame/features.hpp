// Which stage a frame asks for that this build leaves out (hw/features.hpp).
#pragma once

#include "hw/features.hpp"
#include "shadow/frame/inputs.hpp"

#include <string_view>

namespace umbra78::shadow {

// The name of the first such feature; "" if all that is asked for is built. The remedy is to build
// with it: -DUMBRA78_FEATURES="...;name".
inline std::string_view missing_feature(const Scene& scene, const Settings& s) {
    using enum hw::Feature;
    const auto eye = [](const raster::View& v) {
        return v.projection == raster::Projection::perspective;
    };
    bool eyes = eye(scene.observer);
    for (std::size_t l = 0; l < scene.light_count; ++l) eyes = eyes || eye(scene.lights[l]);
    bool ramps = false;
    for (std::size_t k = 0; k < scene.sources_used(); ++k)
        ramps = ramps || scene.source(k).ramp_px > 0;
    const bool diced = s.surface == raster::PatchForm::diced || is_rival(s.form);
    const struct {
        hw::Feature feature;
        bool asked_for;
    } all[] = {{perspective, eyes},
               {triangles, diced || !scene.mesh.facets.empty()},
               {dicing, diced},
               {leaf_sampling, s.sampling == raster::Sampling::leaf},
               {bilinear, s.lookup == Lookup::bilinear},
               {windows, has_window(s.lookup)},
               {dither, s.dither.shape != hw::DitherShape::none},
               {correct_form, s.form == Form::correct},
               {ground, is_on_ground(s.form)},
               {rivals, is_rival(s.form) || s.form == Form::irregular_map},
               {ap120b, s.arithmetic == Arithmetic::ap120b},
               {filters, s.dequantize_passes > 0 || s.low_pass_passes > 0},
               {z32, s.machine.z_bits > 16},
               {lights, scene.light_count > 1 || scene.channels > 1 || ramps},
               {surface_bias, s.map_depth != MapDepth::first || s.bias_slope_q8 > 0 ||
                                 s.receiver != Receiver::point}};
    for (const auto& [feature, asked_for] : all)
        if (asked_for && !hw::built(feature)) return hw::name_of(feature);
    return "";
}

}  // namespace umbra78::shadow
