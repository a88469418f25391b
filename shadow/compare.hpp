// Look up and compare: is a point, given in the light's screen words, in shadow?
//
//   nearest    shadow  <=>  code > z(t)
//   bilinear   shadow  <=>  code 2^(2 F) > blend      (exact: no quotient, nothing rounded)
//
// The light map holds the Z code of what the light sees first. The bias is already taken off in
// the matrix, so a point is in shadow when its own code is greater; equal is lit. Texels outside
// the map's edge count as background. The terms are those of shadow/light_place.hpp.
// This is the definition: every other form of the lookup is tested against it, or against a slow
// model of it in the tests.
#pragma once

#include "hw/frame_store.hpp"
#include "shadow/light_place.hpp"
#include "shadow/receiver.hpp"

#include <cstdint>

namespace umbra78::shadow {

template <class Depth>
struct LightMap {
    hw::FrameStore<const Depth> store;
    hw::MachineSpec spec;
    Lookup lookup;
    Background background;

    std::uint32_t texel(std::int64_t x, std::int64_t y) const {
        if (!on_map(spec, x, y)) return spec.background();
        return store.depth[store.address(static_cast<int>(x), static_cast<int>(y))];
    }
    FourCodes four(std::int64_t x, std::int64_t y) const {
        return {texel(x, y), texel(x + 1, y), texel(x, y + 1), texel(x + 1, y + 1)};
    }
};

template <class Depth>
LightMap<Depth> light_map(const hw::FrameStore<const Depth>& store, const ShadowTest& test) {
    return {store, test.machine, test.lookup, test.background};
}

// Twice the centre of a texel, in words of X or Y.
constexpr std::int64_t twice_centre(const hw::MachineSpec& spec, std::int64_t texel) {
    return (2 * (texel - spec.half_px()) + 1) * (std::int64_t{1} << spec.fraction_bits);
}

// `p` from the transform unit, `d` the pixel's dither words (0 where dither is off). `plane` is the
// pixel's, whose depth at the sampled place is compared; null: the pixel's own depth is.
template <class Depth>
bool in_shadow(const LightMap<Depth>& map, const hw::Point& p, const hw::DitherWords& d,
               const ReceiverPlane* plane = nullptr) {
    const hw::MachineSpec& spec = map.spec;
    const LightPlace at = light_place(spec, p, d);
    if (!at.inside) return false;
    const auto at_texel = [&](std::int64_t x, std::int64_t y) {
        return plane == nullptr ? at.code
                                : at.code + plane->change(twice_centre(spec, x),
                                                          twice_centre(spec, y));
    };
    if (!interpolates(spec, map.lookup)) {  // nearest lookup does not use the fractions
        const TexelPlace t = texel_place(spec, false, at.x, at.y);
        return at_texel(t.x, t.y) > map.texel(t.x, t.y);
    }
    const TexelPlace t = texel_place(spec, true, at.x, at.y);
    const FourCodes z = map.four(t.x, t.y);
    if (falls_back(spec, map.background, z)) {
        const std::size_t k = nearest_of_four(spec, t.fx, t.fy);
        return at_texel(t.x + static_cast<int>(k % 2), t.y + static_cast<int>(k / 2)) > z[k];
    }
    const std::int64_t code = plane == nullptr ? at.code
                                               : at.code + plane->change(2 * at.x, 2 * at.y);
    return blend_scale(spec, code) > blend_of(spec, t.fx, t.fy, z).z;
}

}  // namespace umbra78::shadow
