// Bands of pixels about the edges of truth's shadow, where errors are a matter of resolution; what
// is wrong outside them is wrong.
//
// A band is an image of size * size zeros and ones, row 0 at the top, as in Truth.
#pragma once

#include "tools/truth/truth.hpp"

#include <cstdint>
#include <vector>

namespace umbra78::tools {

using Band = std::vector<std::uint8_t>;

// The pixels that have a visible pixel of the other answer within `radius_px`, centre to centre:
// with radius 1 one pixel on either side of every edge of truth's shadow, with radius 0 none.
Band edge_band(const Truth&, double radius_px);

// One light texel mapped back to the observer: the pixels whose answer in truth changes when
// their surface point slides over its surface by `reach_texels`, seen in the light's image, in
// any of 8 directions, or by half of it; near the light's limb it is up to sqrt(2 r T) wide
// (T: the texel's size). A point that slides over its sphere's limb is at the shadow line, hence
// in the band, unless it lies in another surface's shadow before and after. Then widened by the
// radius of the mask's filter, in observer pixels. `light_view` is the depth map's.
Band light_texel_band(const TruthScene&, const TruthLight&,
                                           const TruthView& light_view, const Truth&,
                                           double filter_radius_px, double reach_texels = 1);

// The same from what the observer sees alone, for surfaces of any shape: the pixels from which a
// pixel of the other answer is at most `reach_texels` away in the light's image, on the same piece
// of surface as far as depth tells (no deeper or nearer than thrice the surface's own slope there
// explains, as on a sphere it is at most twice to its shadow line); and one pixel on either side
// of every edge. Edges that the observer does not see widen nothing.
Band seen_texel_band(const TruthView& light_view, const Truth&,
                                          double reach_texels = 1);

// The band and every pixel within `radius_px` of it.
Band widened(const Band& band, int size,
                                  double radius_px);

}  // namespace umbra78::tools
