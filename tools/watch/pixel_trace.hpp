// A pixel's way through the post-process: every word as it occurs, with its cycle.
//
// The clocked machine runs over the rendered frame, tick by tick, until the pixel's mask word is
// written; the words are read from its registers. Some words the machine does not keep: the noise's
// bytes, the certificate of a quotient (hw/MACHINE.md, section 5), and the filters' words. They are
// computed by the same formulas and compared with what the machine or the frame has. Cycles are
// counted from 0 at the frame's first tick.
#pragma once

#include "tools/watch/trace_log.hpp"
#include "tools/watch/watched_frame.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace umbra78::tools {

struct Pixel {
    int x, y;
};

enum class PixelOutcome : std::uint8_t {
    background,   // nothing was drawn there: the reader drops it
    no_quotient,  // its divisor is not positive, or a quotient does not fit
    outside,      // it lies outside the light's volume
    compared,
};

struct PixelTrace {
    Pixel pixel;
    PixelOutcome outcome;
    std::uint8_t mask;
    std::uint64_t first_cycle, last_cycle;  // first read; mask written, or background found
    std::vector<TraceLine> lines;
};

std::string summary(const PixelTrace&);  // "in shadow, cycles 208439 to 208457"

// The post-process alone. Throws SceneError if the pixel is not in the frame.
PixelTrace trace_post_process(WatchedFrame&, Pixel);

// The post-process and all that follows, up to the picture, of a job that is rendered. Throws
// SceneError also if the frame's method cannot be watched, and std::logic_error if the clocked and
// the functional machine disagree.
PixelTrace trace_pixel(const RenderJob&, Pixel);

nlohmann::ordered_json to_json(const PixelTrace&);

}  // namespace umbra78::tools
