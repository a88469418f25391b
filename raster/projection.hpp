// Projection: a patch's control points to block components, and bounds of what they become.
//
// Orthographic: the unit's accumulators are rounded once, to raster units, and the components are
// X, Y, Z. Perspective makes rational patches, so X, Y, Z and W are subdivided as they are (one
// of the ways in Catmull 1974, p. 27) and divided at the leaves' corners: the four accumulators
// are brought to one common exponent, 44 bits, so that a screen coordinate in pixels is X / W.
//
// The bounds of a quotient x = X / W over a block are those of (X - c W) / W about a whole pixel
// c near it, with |x'| <= (|(X - cW)'| + |x - c| |W'|) / W, so they stay tight far from the axis.
#pragma once

#include "raster/block_rule.hpp"
#include "raster/scene.hpp"

#include <array>
#include <cstdint>

namespace umbra78::raster {

using hw::MachineSpec;
using hw::MatrixWords;
using hw::WordFormat;

using ObjectWords = std::array<hw::Words, 16>;

ObjectWords to_object_words(const Patch& patch, WordFormat format);

std::array<Component, 3> affine_components(const ObjectWords& p, const MatrixWords& m,
                                           const MachineSpec& spec, WordFormat format,
                                           hw::UnitWork work = {});

std::array<Component, 4> homogeneous_components(const ObjectWords& p, const MatrixWords& m,
                                                const MachineSpec& spec, WordFormat format);

ScreenBounds affine_bounds(const std::array<Component, 3>& c);

// Of a block: before the eye; out of sight; or, W not being positive throughout, not yet known.
enum class Sight : std::uint8_t { before, outside, both };

// The bounds of a block before the eye. One that reaches behind it is out of sight if it lies
// beyond a side of the cube in homogeneous terms; so only what crosses the near plane within the
// frame stays to be split, and only until its blocks are shorter than the near depth.
Sight projected_bounds(const std::array<Component, 4>& c, const MachineSpec& spec,
                       ScreenBounds& out);

}  // namespace umbra78::raster
