// Whether the machine draws what exact truth sees: pixels that are missing, extra or misplaced.
//
// A shadow's error is counted only where both see something, so a picture that has lost a surface
// could have none. These counts are the errors of the picture itself. They leave out what lies
// within a pixel of a silhouette, where a pixel's centre may fall to either side:
//   missing    truth sees a surface, the machine draws nothing, and truth sees one in all 8
//              neighbours, or the machine draws in none of them
//   extra      the same with truth and machine exchanged
//   misplaced  both see one, all 9 pixels are of one surface in truth, and the machine's depth is
//              not within the depths of the 9, widened on either side by their range and 4 codes;
//              and one of the 8 neighbours is misplaced, too (the tip of a fold is not)
// The frame's border is taken to continue.
#pragma once

#include "tools/io/buffers.hpp"
#include "tools/truth/metrics.hpp"

#include <cstdint>
#include <vector>

namespace umbra78::tools {

struct Coverage {
    int seen = 0, drawn = 0;  // by truth, by the machine
    int missing = 0, extra = 0, misplaced = 0;
    int beyond_edge = 0;      // drawn, not seen by truth, and not extra: within a pixel of an edge

    bool complete() const { return missing + extra + misplaced == 0; }
};

enum class Covered : std::uint8_t { right, missing, extra, misplaced };

// Of every pixel. `depths` are the observer's codes; their maxval is the background. `view` is the
// machine's, with its near and far.
std::vector<Covered> coverage_image(const Truth&, const Buffer& depths, const TruthView& view);

Coverage coverage(const Truth&, const Buffer& depths, const std::vector<Covered>&);

}  // namespace umbra78::tools
