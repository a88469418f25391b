// What casts a shadow in a light's map, and how deep: by its facing and its slope (hw/MACHINE.md,
// section 24).
//
//   facing    both sides are drawn, or one: a triangle that turns clockwise on the screen (X right,
//             Y down) shows its back
//   slope     2^13 max(|rise_x|, |rise_y|) / |area|, raster units of Z a texel, rounded up
//   offset    slope times the factor, rounded up, at most the limit; it is added to a sample's Z
//
// In: a triangle's corners in raster units, 31-bit words; Q.8 factors. Out: raster units of Z.
#pragma once

#include "fixed/divide.hpp"
#include "hw/features.hpp"
#include "raster/sampling.hpp"

#include <algorithm>
#include <cstdint>

namespace umbra78::raster {

// Which triangles are drawn: all, those whose vertices turn counter-clockwise as they are seen, or
// the others.
enum class Facing : std::uint8_t { both, front, back };

// `area` is twice the signed area, positive for a clockwise turn.
constexpr bool is_drawn(Facing facing, std::int64_t area) {
    return facing == Facing::both || (area != 0 && (facing == Facing::back) == (area > 0));
}

// By how much the depth of a triangle's plane changes within a texel in X or in Y, whichever is
// more, rounded up and at most 2^31 - 1; 0 if the triangle is edge-on, for it then has no samples.
constexpr std::int64_t depth_slope(const Corner& a, const Corner& b, const Corner& c) {
    const std::int64_t area = detail::turn(a, b, c.x, c.y);
    if (area == 0) return 0;
    const std::int64_t bx = std::int64_t{b.x} - a.x, by = std::int64_t{b.y} - a.y;
    const std::int64_t cx = std::int64_t{c.x} - a.x, cy = std::int64_t{c.y} - a.y;
    const std::int64_t bz = std::int64_t{b.z} - a.z, cz = std::int64_t{c.z} - a.z;
    const std::int64_t rise_x = bz * cy - cz * by, rise_y = cz * bx - bz * cx;
    const auto magnitude = [](std::int64_t v) { return v < 0 ? -v : v; };
    return fixed::divide(std::max(magnitude(rise_x), magnitude(rise_y)), magnitude(area),
                         raster_fraction, 32, fixed::Rounding::ceiling)
        .value;
}

// What the light's map changes in a drawing. A view that is none has Casters{}.
struct Casters {
    Facing facing = Facing::both;  // of leaves and facets
    std::int32_t slope_q8 = 0;     // the factor, in texels; not negative
    std::int64_t limit = INT64_MAX;

    // A build without the feature has no others.
    constexpr bool all_alike() const {
        return !hw::built(hw::Feature::surface_bias) ||
               (facing == Facing::both && slope_q8 == 0);
    }
    constexpr std::int64_t offset(std::int64_t slope) const {
        return std::min(limit,
                        fixed::round_shift(slope * slope_q8, 8, fixed::Rounding::ceiling));
    }
};

// The same of a leaf's sample: false if its triangle, or in leaf sampling the leaf, is not drawn.
inline bool cast_by_leaf(const Casters& casters, const Corners& grid, const Sample& s,
                         Sampling sampling, std::int64_t& offset) {
    const Corner c00 = corner_at(grid, s.leaf_i, s.leaf_j);
    const Corner c10 = corner_at(grid, s.leaf_i + 1, s.leaf_j);
    const Corner c01 = corner_at(grid, s.leaf_i, s.leaf_j + 1);
    const Corner c11 = corner_at(grid, s.leaf_i + 1, s.leaf_j + 1);
    const bool whole = sampling == Sampling::leaf;
    std::int64_t slope = 0;
    if (casters.slope_q8 > 0) {
        if (whole || !s.second) slope = depth_slope(c00, c10, c11);
        if (whole || s.second) slope = std::max(slope, depth_slope(c00, c11, c01));
    }
    offset = casters.offset(slope);
    // The sum of both triangles' areas is the product of the diagonals; their values fit 64 bits.
    const std::int64_t area =
        whole ? (std::int64_t{c11.x} - c00.x) * (std::int64_t{c01.y} - c10.y) -
                    (std::int64_t{c01.x} - c10.x) * (std::int64_t{c11.y} - c00.y)
        : s.second ? detail::turn(c00, c11, c01.x, c01.y)
                   : detail::turn(c00, c10, c11.x, c11.y);
    return is_drawn(casters.facing, area);
}

}  // namespace umbra78::raster
