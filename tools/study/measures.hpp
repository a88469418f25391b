// A scene's truth for a study: traced once, shared by all cases that see it the same way.
//
// Like TruthCache, by the same key, and with what bias and gap are measured by: per pixel, the
// surface's slope in the light's space and how far it is behind its caster.
// Safe to call from several threads: the first to ask traces, the others wait.
#pragma once

#include "tools/render_job.hpp"
#include "tools/scene_truth.hpp"
#include "tools/study/study.hpp"

#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <string>

namespace umbra78::tools::study {

struct Traced {
    SceneTruth truth;
    Band band;                    // one light texel mapped back to the observer, no filter
    // By pixel, along the ray to the light in world units: from the surface to the first surface
    // the light sees there. 0 where the pixel is lit in truth or not seen.
    std::vector<double> behind;
    // |zu| + |zv|: how steep the surface is in the light's space, in light-view depth ranges a
    // texel along its X and its Y; 2^z_bits times that is quanta a texel. 0 where the pixel is
    // in shadow or not seen, infinite where the surface is seen edge on.
    std::vector<double> slope;
};

class TruthStore {
public:
    // Null for a scene with free patches, which has no closed form.
    std::shared_ptr<const Traced> of(const LoadedScene&) const;

private:
    using Entry = std::shared_future<std::shared_ptr<const Traced>>;
    mutable std::mutex mutex_;
    mutable std::map<std::string, Entry> entries_;
};

// The frame as far as its mask, nothing filtered.
void draw_mask(RenderJob&);

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
