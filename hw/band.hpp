// A band: scan lines of a frame that follow one another, as one worker gets them.
//
// Lines share nothing in the machine's stages but what they only read, so that a frame may be
// divided into bands in any way without changing a bit.
#pragma once

#include <limits>

namespace umbra78::hw {

struct Band {
    static constexpr int no_end = std::numeric_limits<int>::max();
    int first = 0, end = no_end;  // the last line is end - 1

    constexpr bool has(int y) const { return y >= first && y < end; }
    // Whether it holds one of the lines y0 to y1.
    constexpr bool meets(int y0, int y1) const { return y1 >= first && y0 < end; }
    // Whether it is not limited.
    constexpr bool all() const { return first == 0 && end == no_end; }
    // Of a frame of so many lines.
    constexpr Band within(int lines) const { return {first, end < lines ? end : lines}; }
};

}  // namespace umbra78::hw
