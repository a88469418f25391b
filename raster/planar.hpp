// The planar shadow (Blinn 1988): the scene projected from a light on one plane, the ground, as the
// observer sees it (hw/MACHINE.md, section 26).
//
//   flat(p) = (rise p - height(p) d, rise) / rise             light at infinity, in direction d
//   flat(p) = (rise p - height(p) e, rise - height) / rise    light at e
//   rows X, Y, W = those of the observer's world to screen, times flat
//   row Z        = the height over the ground, so that the drawing's limits of Z cut off what lies
//                  below it and what lies as high as a lamp
//
// In: views, and surfaces of which one patch is the ground, a parallelogram by its corners 0, 3 and
// 12. Out: an exact matrix of world units, which is rounded once when it is loaded.
// Not emulated: how a host of 1978 would have made it.
#pragma once

#include "raster/scene.hpp"
#include "raster/view.hpp"

#include <cstddef>

namespace umbra78::raster {

// False, and `out` as it was, if the light lies in the plane of the ground.
bool planar_shadow(const View& observer, const View& light, const Surfaces& surfaces,
                   std::size_t ground, const MachineSpec& spec, RationalMatrix& out);

}  // namespace umbra78::raster
