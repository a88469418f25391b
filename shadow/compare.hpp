// Look up and compare: is a point, given in the light's screen words, in shadow?
//
// The light map holds the Z code of what the light sees first. A point is in shadow when its own
// code, the bias already taken off in the matrix, is greater; equal is lit. Outside the light's
// volume, or without a quotient, it is lit (Williams 1978, p. 272). Dither is added to X and Y
// before the lookup. Bilinear lookup interpolates the map's *Z* between the four nearest texel
// centres (never the result, which the filters do) and compares exactly:
//
//   shadow  <=>  code 2^(2 F) > sum of the four codes times their weights (2^F - fx)(2^F - fy) ...
//
// Texels beyond the map's edge count as background.
#pragma once

#include "hw/frame_store.hpp"
#include "hw/noise_source.hpp"
#include "hw/transform_unit.hpp"
#include "shadow/shadow_test.hpp"

#include <cstdint>

namespace umbra78::shadow {

template <class Depth>
struct LightMap {
    const hw::FrameStore<Depth>& store;
    hw::MachineSpec spec;
    Lookup lookup;
    Background background;

    std::uint32_t texel(std::int64_t x, std::int64_t y) const {
        const int size = spec.size_px();
        if (x < 0 || y < 0 || x >= size || y >= size) return spec.background();
        return store.depth[store.address(static_cast<int>(x), static_cast<int>(y))];
    }
};

// The texel a coordinate falls in, X or Y.
constexpr std::int64_t texel_index(const hw::MachineSpec& spec, std::int64_t v) {
    return (v >> spec.fraction_bits) + spec.half_px();
}

template <class Depth>
bool nearest_shadows(const LightMap<Depth>& map, std::int64_t x, std::int64_t y,
                     std::int64_t code) {
    return code > map.texel(texel_index(map.spec, x), texel_index(map.spec, y));
}

template <class Depth>
bool bilinear_shadows(const LightMap<Depth>& map, std::int64_t x, std::int64_t y,
                      std::int64_t code) {
    const int f = map.spec.fraction_bits;
    if (f == 0) return nearest_shadows(map, x, y, code);  // no fraction, no weights
    const std::int64_t one = std::int64_t{1} << f;
    const std::int64_t cx = x - one / 2, cy = y - one / 2;  // texel centres at whole numbers
    const std::int64_t tx = texel_index(map.spec, cx), ty = texel_index(map.spec, cy);
    const std::int64_t fx = cx & (one - 1), fy = cy & (one - 1);
    const std::uint32_t z00 = map.texel(tx, ty), z10 = map.texel(tx + 1, ty);
    const std::uint32_t z01 = map.texel(tx, ty + 1), z11 = map.texel(tx + 1, ty + 1);
    const std::uint32_t none = map.spec.background();
    if (map.background == Background::fall_back &&
        (z00 == none || z10 == none || z01 == none || z11 == none))
        return nearest_shadows(map, x, y, code);
    const std::int64_t blend = (one - fy) * ((one - fx) * z00 + fx * z10) +
                               fy * ((one - fx) * z01 + fx * z11);
    return code * one * one > blend;
}

// Where a point stands in the light's volume: X and Y dithered, Z as the code to compare.
struct LightPlace {
    bool inside;
    std::int64_t x, y, code;
};

// `p` from the transform unit, `d` the place's dither words (0 where dither is off).
constexpr LightPlace light_place(const hw::MachineSpec& spec, const hw::Point& p,
                                 const hw::DitherWords& d) {
    if (p.status != hw::DivideStatus::ok) return {false, 0, 0, 0};
    const std::int64_t x = p.x + d.x, y = p.y + d.y, code = p.z + spec.depth_offset();
    const std::int64_t edge = std::int64_t{spec.half_px()} << spec.fraction_bits;
    const bool inside = x >= -edge && x < edge && y >= -edge && y < edge && code >= 0 &&
                        code <= spec.deepest_drawn();
    return {inside, x, y, code};
}

template <class Depth>
bool in_shadow(const LightMap<Depth>& map, const hw::Point& p, const hw::DitherWords& d) {
    const LightPlace at = light_place(map.spec, p, d);
    if (!at.inside) return false;
    return map.lookup == Lookup::nearest ? nearest_shadows(map, at.x, at.y, at.code)
                                         : bilinear_shadows(map, at.x, at.y, at.code);
}

}  // namespace umbra78::shadow
