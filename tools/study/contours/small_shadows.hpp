// What the filters leave of a shadow that is only a few pixels wide.
//
// Shadows of known shape are drawn at pixel centres, filtered by the machine's own filters, and
// what is still at least half dark (127.5 of 255) is counted. No scene and no shadow test is in it.
#pragma once

namespace umbra78::tools::study {

struct Passes {
    int dequantize, low_pass;
};

// A bar is `width_px` wide and 32 pixels long, a spot is a disc of that diameter.
enum class SmallShadow { bar, spot };

// The share of the shape's pixels that are lost, 0 .. 1 (below 0: it grew), over 12 directions of a
// bar and 16 places within a pixel.
double lost_area(SmallShadow, double width_px, Passes);

}  // namespace umbra78::tools::study
