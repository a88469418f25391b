// What several studies measure of a drawn frame, and the units in which they report it.
#pragma once

#include "tools/io/buffers.hpp"
#include "tools/render/render_job.hpp"
#include "tools/study/study.hpp"
#include "tools/study/truth_cache.hpp"

#include <string>

namespace umbra78::tools::study {

// Draws the frame up to its mask; nothing is filtered.
void draw_mask(RenderJob&);

// The observer's Z minus truth's, in quanta. Counted are pixels that both see and whose surface in
// truth is that of all four neighbours: at a silhouette the machine may mean another surface.
struct DepthError {
    std::int64_t pixels = 0;
    double min = 0, mean = 0, max = 0, rms = 0;
};
DepthError depth_error(const LoadedScene&, const Truth&, const Buffer& observer_z);

// The detachment gap: the distance from its caster at which a shadow begins, in world units along
// the light's ray. It is the distance that best separates the shadowed pixels that are drawn lit
// (nearer to their caster) from those drawn in shadow (farther). Pixels at a shadow's edge, which
// are drawn lit at any distance, do not move it. 0 if no distance separates them.
double detachment_gap(const Traced&, const MachineMask&);

// Sets missing_pixels, extra_pixels and misplaced_pixels: rates are of the pixels that both see.
void set_coverage(Row&, const Coverage&);
// How many rows lack pixels, and how many at most, in a sentence; "" if none does.
std::string words_of_coverage(std::span<const Row>);
inline constexpr ColumnMeaning coverage_columns[] = {
    {"missing_pixels", "pixels that truth sees and the machine does not draw: none of the rates "
                       "counts them"},
    {"extra_pixels", "pixels that the machine draws and truth does not see"},
    {"misplaced_pixels", "pixels at which the machine draws another depth than truth sees"},
};

// Sets false_shadow, false_light, the same two with _outside (the edge band), isolated_pixels,
// and the coverage, which the report must have.
void set_rates(Row&, const ShadowReport&);
inline constexpr ColumnMeaning rate_columns[] = {
    {"false_shadow", "share of the pixels lit in truth that the mask shadows, 0 .. 1"},
    {"false_light", "share of the pixels shadowed in truth that the mask lights, 0 .. 1"},
    {"false_shadow_outside", "the same without the edge band: pixels within a light texel, mapped "
                             "back to the observer, of a shadow's edge in truth"},
    {"false_light_outside", "false_light without the edge band"},
    {"isolated_pixels", "drawn pixels none of whose four neighbours has the same answer"},
};

// Lit 200, in shadow 110, false shadow black, false light white; 235 where nothing is compared.
std::vector<std::uint8_t> error_picture(const SceneTruth&, const MachineMask&);

// How many quanta of the light's Z and how many of its texels a world unit is, at its target.
struct LightUnits {
    double quanta_per_world, texels_per_world;
    double world(double quanta) const { return quanta / quanta_per_world; }
    double texels(double quanta) const { return world(quanta) * texels_per_world; }
};
LightUnits light_units(const LoadedScene&);

// Sets COLUMN_quanta, COLUMN_texels and COLUMN_world; NaN makes empty cells.
void set_in_three_units(Row&, const std::string& column, const LightUnits&, double quanta);

}  // namespace umbra78::tools::study
