// Where a model or a solid stands in the world: turned, then moved (hw/MACHINE.md, section 20).
//
//   world word = place + half_even(rotation . local / 2^(fraction + 14))
//
// The sum is exact, so a coordinate is rounded once. Rotation words are Q2.30.
#pragma once

#include "fixed/wide_int.hpp"
#include "raster/scene.hpp"
#include "raster/vector.hpp"

namespace umbra78::raster {

// Q15.16 degrees, right-handed: first about the x axis, then about y, then about z.
struct Turn {
    std::int32_t x = 0, y = 0, z = 0;
};

using Rotation = std::array<Axis, 3>;  // rows
// Each entry is made of sine and cosine words, every product and sum rounded half even; exact for
// multiples of 90 degrees.
Rotation rotation_of(const Turn&);

using Wide = fixed::WideInt<3>;

struct Placing {
    World place{};
    Rotation rotation = rotation_of({});
};

// rotation . local, exact: 30 more fraction bits. |local| < 2^150.
Vector<Wide> rotated(const Rotation&, const Vector<Wide>& local);

// The world words of a local point of `fraction` fraction bits, fraction >= 1. Those of a point
// outside the world do not fit a World; they fit 64 bits where |local| < 2^(fraction + 40).
WideVector placed(const Placing&, const Vector<Wide>& local, int fraction);

// Whether words lie in the world, -32767 .. 32767, and so in a World.
bool in_world(const WideVector&);
World world_of(const WideVector&);

}  // namespace umbra78::raster
