// What studies measure of a drawn frame, and the units they give it in.
#pragma once

#include "tools/io/buffers.hpp"
#include "tools/render/render_job.hpp"
#include "tools/study/study.hpp"
#include "tools/study/truth_cache.hpp"

#include <string>

namespace umbra78::tools::study {

// The frame as far as its mask, nothing filtered.
void draw_mask(RenderJob&);

// Observer's Z less truth's, in quanta, where both see the same surface and so do the four
// neighbours in truth: at a silhouette another surface may be meant.
struct DepthError {
    std::int64_t pixels = 0;
    double min = 0, mean = 0, max = 0, rms = 0;
};
DepthError depth_error(const LoadedScene&, const Truth&, const Buffer& observer_z);

// The detachment gap: how far behind its caster, in world units along the light's ray, a shadow
// begins. It is the distance that best parts the pixels that are lit falsely (nearer) from those
// that are in shadow rightly; an edge's pixels, lit falsely at any distance, do not move it. 0
// where no distance parts them.
double detachment_gap(const Traced&, const MachineMask&);

// The columns false_shadow, false_light, both with _outside the band, and isolated_pixels.
void set_rates(Row&, const ShadowReport&);

// Quanta and texels of light depth and width a world unit, at the light's target.
struct LightUnits {
    double quanta_per_world, texels_per_world;
    double world(double quanta) const { return quanta / quanta_per_world; }
    double texels(double quanta) const { return world(quanta) * texels_per_world; }
};
LightUnits light_units(const LoadedScene&);

// Sets COLUMN_quanta, COLUMN_texels, COLUMN_world; none of them for NaN.
void set_in_three_units(Row&, const std::string& column, const LightUnits&, double quanta);

}  // namespace umbra78::tools::study
