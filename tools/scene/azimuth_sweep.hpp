// A sweep: an azimuth that goes from A to B over a sequence of frames, in equal steps.
//
// A and B are exact decimals of degrees, read into Q15.16 words like every angle; frame k of n has
// the word A + half_even((B - A)(k - 1)/(n - 1)), and its exact decimal goes the way of --set.
#pragma once

#include <cstdint>
#include <string>

namespace umbra78::tools {

struct AzimuthSweep {
    std::string view;  // "light" or "observer"
    std::int64_t from_q16 = 0, to_q16 = 0;

    std::string at(int frame, int frames) const;           // "-98.75"; frames are counted from 1
    std::string override_at(int frame, int frames) const;  // "light.azimuth=-98.75"
};

// "A:B", as --light or --observer takes it. Throws SceneError.
AzimuthSweep read_sweep(const std::string& view, const std::string& text);

}  // namespace umbra78::tools
