// The alias-free shadow map in the machine's own words: a row of shadow/frame/methods.cpp
// (shadow/rivals/scan_out.md).
//
// The visible points are transformed as the post-process does it, but no map of texels is asked:
// the light's view is drawn after them and sampled at their places alone. X and Y keep all bits of
// the transform, and only Z is rounded to the machine's code, so that what is left of figure 3's
// moire is Z's. Surfaces are subdivided as for a depth map; nothing is diced for it.
#pragma once

#include "shadow/frame/ledger.hpp"
#include "shadow/frame/methods.hpp"

namespace umbra78::shadow {

// Of method_memory: a code, a place and a list for each pixel.
std::size_t irregular_map_bytes(const FrameInputs&);

template <class Depth>
void cast_irregular_map(const FrameInputs&, const FramePlan&, std::size_t light,
                        FrameBuffers<Depth>&, FrameCounts&);
// The drawing at the places, and what the cast has counted.
template <class Depth>
void cost_of_irregular_map(const FrameInputs& in, std::size_t l, const FrameBuffers<Depth>&,
                           const FrameCounts& counts, FrameLedger& ledger) {
    hw::Operations o = drawing_operations(in, in.matrices.lights[l].world_to_light,
                                          counts.lights[l].map, Keeps::depth);
    o += counts.lights[l].method_frame;
    ledger.test = {o, method_of(in).units(o, in.settings)};
}

template <class Depth>
constexpr MethodStages<Depth> irregular_map_stages{nullptr, cast_irregular_map<Depth>,
                                                   cost_of_irregular_map<Depth>};

}  // namespace umbra78::shadow
