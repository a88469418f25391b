// The cubic arc of 45 degrees from which round surfaces are made (hw/MACHINE.md, section 3).
#pragma once

#include "fixed/sine.hpp"
#include "raster/scene.hpp"
#include "raster/vector.hpp"

namespace umbra78::raster {

// Control point i of the arc from 45 k to 45 (k + 1) degrees, as cosine and sine in Q2.30:
// P0 + handle P0' next to the start, P3 - handle P3' next to the end.
constexpr fixed::SineCosine arc_point(int k, int i) {
    constexpr std::int32_t handle_q30 = 284774038;  // 4/3 tan(45/4 degrees)
    const fixed::SineCosine end = fixed::sine_cosine((i < 2 ? k : k + 1) * (45 << world_fraction));
    const std::int32_t handle = i == 1 ? handle_q30 : i == 2 ? -handle_q30 : 0;
    return {end.sine + axis_product(handle, end.cosine),
            end.cosine - axis_product(handle, end.sine)};
}

}  // namespace umbra78::raster
