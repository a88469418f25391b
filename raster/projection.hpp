// Projection: a patch's control points to the components of a block, and bounds of what they
// become on the screen.
//
// Orthographic views: a row's accumulator is rounded once, to raster units, so the components are
// X, Y, Z. Perspective makes rational patches: X, Y, Z and W are subdivided as they are (one of
// the ways in Catmull 1974, p. 27) and divided at the leaves' corners. There the four
// accumulators are brought to one common exponent and 44 bits, so X / W is in pixels.
//
// The bounds of a quotient x = X / W over a block (hw/MACHINE.md, section 14) are those of
// (X - c W) / W about a whole pixel c near the block, with
//
//   |x'| <= (|(X - c W)'| + |x - c| |W'|) / W
//   an eighth of |x''| <= (an eighth of (|(X - c W)''| + |x - c| |W''|) + |x'| |W'| / 4) / W
//
// so they stay tight far from the axis. They hold for the exact surface.
#pragma once

#include "raster/block_rule.hpp"
#include "raster/scene.hpp"

#include <array>
#include <cstdint>
#include <span>

namespace umbra78::raster {

using hw::MachineSpec;
using hw::MatrixWords;
using hw::WordFormat;

inline constexpr int object_bits = 16;

// The format of all object words of a scene: 16 bits and the largest fraction that holds every
// control point and vertex, at most 14, so that one_word is at least 1.0.
WordFormat object_format(const Surfaces& surfaces);
// The same for places whose coordinates have this greatest magnitude, a world word.
WordFormat object_format(std::uint32_t largest);

using ObjectWords = std::array<hw::Words, 16>;

// A place, and a patch's control points, in object words, rounded half up.
constexpr hw::Words to_object_words(const World& place, WordFormat format) {
    const auto word = [&](std::int32_t v) {
        return static_cast<std::int32_t>(fixed::scale_shift(
            v, world_fraction - format.fraction, fixed::Rounding::half_up));
    };
    return {word(place.x), word(place.y), word(place.z)};
}
ObjectWords to_object_words(const Patch& patch, WordFormat format);

// A place in a view. Affine: X, Y, Z in raster units, and 1. Perspective: X, Y, Z, W of 44 bits.
using ScreenPlace = std::array<std::int64_t, 4>;
ScreenPlace affine_place(const hw::TransformUnit& unit, const hw::Words& place);
ScreenPlace homogeneous_place(const hw::Words& place, const MatrixWords& m,
                              const MachineSpec& spec, WordFormat format);

// X, Y, Z in raster units.
std::array<Component, 3> affine_components(const ObjectWords& p, const MatrixWords& m,
                                           const MachineSpec& spec, WordFormat format,
                                           hw::UnitWork work = {});

// X, Y, Z, W.
std::array<Component, 4> homogeneous_components(const ObjectWords& p, const MatrixWords& m,
                                                const MachineSpec& spec, WordFormat format);

ScreenBounds affine_bounds(const std::array<Component, 3>& c);

// bounded: before the eye, so X / W has bounds. outside: out of sight. unknown: W is not positive
// throughout the block, and the block is not known to be outside.
enum class Visibility : std::uint8_t { bounded, outside, unknown };

// The bounds of a perspective block, in raster units; `out` is set only if they exist. A block
// that reaches behind the eye is outside if it lies beyond a side of the cube in homogeneous
// terms. So only what crosses the near plane within the frame is split further, and only until
// its blocks are shorter than the near depth.
Visibility projected_bounds(const std::array<Component, 4>& c, const MachineSpec& spec,
                            ScreenBounds& out);

}  // namespace umbra78::raster
