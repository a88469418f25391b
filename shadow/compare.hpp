// Look up and compare: how dark is a point, given in the light's screen words?
//
//   nearest         shadow  <=>  code > z(t)
//   bilinear        shadow  <=>  code 2^(2 F) > blend      (exact: no quotient, nothing rounded)
//   percentage      darkness = half_up(255 (taps with code > z) / taps)
//   filtered_depth  shadow  <=>  code taps > sum of the taps' z
//
// Shadow is the darkness 255, lit 0; percentage closer filtering (Reeves, Salesin & Cook 1987)
// gives anything between. Filtering depths first, as in the last line, is the wrong way.
// The light map holds the Z code of what the light sees first. The bias is already taken off in
// the matrix, so a point is in shadow when its own code is greater; equal is lit. Texels outside
// the map's edge count as background. The terms are those of shadow/light_place.hpp and window.hpp.
// This is the definition: every other form of the lookup is tested against it, or against a slow
// model of it in the tests.
#pragma once

#include "hw/frame_store.hpp"
#include "fixed/trap.hpp"
#include "shadow/light_place.hpp"
#include "shadow/receiver.hpp"
#include "shadow/window.hpp"

#include <algorithm>
#include <cstdint>

namespace umbra78::shadow {

inline constexpr std::uint8_t mask_lit = 0;
inline constexpr std::uint8_t mask_shadow = 255;

template <class Depth>
struct LightMap {
    hw::FrameStore<const Depth> store;
    hw::MachineSpec spec;
    Lookup lookup;
    Background background;
    Window window{};  // of percentage and filtered_depth lookup
    // Whether the map is the face of a cube (hw/sectors.hpp): places and texels beyond its edge are
    // those at its edge.
    bool is_face = false;

    std::uint32_t texel(std::int64_t x, std::int64_t y) const {
        if (is_face) {
            x = std::clamp<std::int64_t>(x, 0, spec.size_px() - 1);
            y = std::clamp<std::int64_t>(y, 0, spec.size_px() - 1);
        }
        if (!on_map(spec, x, y)) return spec.background();
        return store.depth[store.address(static_cast<int>(x), static_cast<int>(y))];
    }
    FourCodes four(std::int64_t x, std::int64_t y) const {
        return {texel(x, y), texel(x + 1, y), texel(x, y + 1), texel(x + 1, y + 1)};
    }
};

template <class Depth>
LightMap<Depth> light_map(const hw::FrameStore<const Depth>& store, const ShadowTest& test) {
    fixed::require(window_in_range(test), "lookup: a window has 2 to 5 taps a side");
    return {store, test.machine, test.lookup, test.background, window_of(test)};
}

// Twice the centre of a texel, in words of X or Y.
constexpr std::int64_t twice_centre(const hw::MachineSpec& spec, std::int64_t texel) {
    return (2 * (texel - spec.half_px()) + 1) * (std::int64_t{1} << spec.fraction_bits);
}

// Of a point inside the volume, by nearest or bilinear lookup. `plane` is the pixel's, whose depth
// at the sampled place is compared; null: the pixel's own depth is.
template <class Depth>
bool nearest_or_blend(const LightMap<Depth>& map, const LightPlace& at,
                      const ReceiverPlane* plane) {
    const hw::MachineSpec& spec = map.spec;
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

// Of a point inside the volume, by a window of taps.
template <class Depth>
std::uint8_t window_darkness(const LightMap<Depth>& map, const LightPlace& at,
                             const hw::TapBytes& noise) {
    const Window& w = map.window;
    int count = 0;
    std::int64_t sum = 0;
    for (int t = 0; t < w.taps(); ++t) {
        const Texel texel = tap_texel(map.spec, w, t, at, noise);
        const std::uint32_t z = map.texel(texel.x, texel.y);
        count += at.code > z;
        sum += z;
    }
    if (map.lookup == Lookup::percentage) return share_of_dark(count, w);
    return at.code * w.taps() > sum ? mask_shadow : mask_lit;
}

// `p` from the transform unit, `d` the pixel's dither words (0 where dither is off), `noise` its
// taps' bytes, which jittered taps alone read, `plane` the receiver's, which windows do not take.
template <class Depth>
std::uint8_t darkness(const LightMap<Depth>& map, const hw::Point& p, const hw::DitherWords& d,
                      const hw::TapBytes& noise = {}, const ReceiverPlane* plane = nullptr) {
    const LightPlace at =
        map.is_face ? face_place(map.spec, p, d) : light_place(map.spec, p, d);
    if (!at.inside) return mask_lit;
    if constexpr (hw::built(hw::Feature::windows))
        if (has_window(map.lookup)) return window_darkness(map, at, noise);
    return nearest_or_blend(map, at, plane) ? mask_shadow : mask_lit;
}

// The same, of a lookup whose answer is yes or no; traps for percentage lookup.
template <class Depth>
bool in_shadow(const LightMap<Depth>& map, const hw::Point& p, const hw::DitherWords& d,
               const hw::TapBytes& noise = {}, const ReceiverPlane* plane = nullptr) {
    fixed::require(map.lookup != Lookup::percentage,
                   "lookup: percentage closer filtering gives a share, not yes or no");
    return darkness(map, p, d, noise, plane) == mask_shadow;
}

}  // namespace umbra78::shadow
