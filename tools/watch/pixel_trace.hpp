// A pixel's way through the post-process: every word, in the order it happens, each with its cycle.
//
// The clocked machine runs over the rendered frame, tick by tick, until the pixel's mask word is
// written; the words are read from its registers. What it cannot show, because the machine does not
// keep it (the noise's bytes, the certificate of a quotient, the filters behind it), is computed
// beside it by the same formulas and held against what the machine has. Formulas and their sections
// are those of hw/MACHINE.md; a cycle is counted from 0 at the frame's first tick.
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
    background,   // nothing was drawn there: it ends in the reader
    no_quotient,  // its divisor is not positive, or a quotient does not fit
    outside,      // of the light's volume
    compared,
};

struct PixelTrace {
    Pixel pixel;
    PixelOutcome outcome;
    std::uint8_t mask;
    std::uint64_t first_cycle, last_cycle;  // first read; mask written, or found to be background
    std::vector<TraceLine> lines;
};

std::string summary(const PixelTrace&);  // "in shadow, cycles 208439 to 208457"

// Of a frame's post-process alone. Throws SceneError for a pixel that is not in it.
PixelTrace trace_post_process(WatchedFrame&, Pixel);

// The same and what follows it, to the picture, of a job that is rendered. Throws SceneError for
// the correct form, too; std::logic_error if clocked and functional machine disagree.
PixelTrace trace_pixel(const RenderJob&, Pixel);

nlohmann::ordered_json to_json(const PixelTrace&);

}  // namespace umbra78::tools
