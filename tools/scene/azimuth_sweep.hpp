// A sweep: an azimuth that goes from A to B over a sequence of frames, in equal steps.
//
// A and B are decimals in degrees, -360 .. 360, read into Q15.16 words like every angle. Frame k of
// n, k = 1 .. n, has the word A + half_even((B - A)(k - 1)/(n - 1)); a single frame has A. The word
// is given to the scene as an override, in its exact decimals.
#pragma once

#include "tools/io/first_error.hpp"

#include <cstdint>
#include <string>

namespace umbra78::tools {

struct AzimuthSweep {
    std::string view;  // "light" or "observer"
    std::int64_t from_q16 = 0, to_q16 = 0;

    std::string at(int frame, int frames) const;           // "-98.75"
    std::string override_at(int frame, int frames) const;  // "light.azimuth=-98.75"
};

// "A:B", as --light or --observer takes it. A range reads as 0:0 if it is wrong.
AzimuthSweep read_sweep(const std::string& view, const std::string& text, FirstError&);
// The same for the program; throws SceneError. Defined in scene_file.cpp.
AzimuthSweep read_sweep(const std::string& view, const std::string& text);

}  // namespace umbra78::tools
