// Bands of pixels about the edges of truth's shadow. Within them an error may be due to the depth
// map's resolution; outside them it is not.
//
// A band is an image of size * size zeros and ones, row 0 at the top, as in Truth. Radii are in
// observer pixels, reaches in texels, the pixels of the light's depth map.
#pragma once

#include "tools/truth/truth.hpp"

#include <cstdint>
#include <vector>

namespace umbra78::tools {

using Band = std::vector<std::uint8_t>;

// The visible pixels that have a visible pixel of the other answer (lit, in shadow) within
// `radius_px`, centre to centre: with radius 1 one pixel on either side of every edge of truth's
// shadow, with radius 0 none.
Band edge_band(const Truth&, double radius_px);

// One texel of the light mapped back to the observer: the pixels whose answer in truth changes when
// their surface point slides over its surface. It slides by `reach_texels` or by half of that, as
// seen in the light's image, in 8 directions. Near the limb that the light sees, the edge of a
// sphere of radius r, the band is up to sqrt(2 r T) wide (T: the texel's size). A point that slides
// over that limb is at the shadow line and so in the band, unless another surface shadows it
// before and after. The band is then widened by the radius of the mask's filter. `light_view` is
// the depth map's.
Band light_texel_band(const TruthScene&, const TruthLight&, const TruthView& light_view,
                      const Truth&, double filter_radius_px, double reach_texels = 1);

// The same for surfaces of any shape, from the visible pixels alone: the pixels from which a pixel
// of the other answer is at most `reach_texels` away in the light's image and on the same piece of
// surface, and one pixel on either side of every edge. Two pixels count as on one piece if their
// depths in the light's view differ by at most three times what the surface's slope gives over the
// reach (on a sphere, up to its shadow line, it is at most twice). Edges that the observer does not
// see add nothing.
Band seen_texel_band(const TruthView& light_view, const Truth&, double reach_texels = 1);

// The band and every pixel within `radius_px` of it.
Band widened(const Band& band, int size, double radius_px);

}  // namespace umbra78::tools
