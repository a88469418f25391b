// A waterfall: who stands in which stage in which cycle, as text.
//
//   cycle               10
//                       |
//   reader       12~23~3.....>...     a row a stage, a column a cycle
//   multiply     .111222333...>>>
//   sum          ....1..2..3.....
//   ...
//   place        .......1..2=.3..
//   fetch        ........###12.3.     (its clock held for three cycles)
//
// 1 to 9, a to z, A to Z are points in the order in which they enter; '<' one that was there
// before, '>' one that comes after those asked for. '.' is a bubble; '=' a point that is done and
// blocked, '#' one whose clock is held. In the reader's row '.' reads background, '-' is a cycle of
// a longer read, '~' waits for the next slot, and a blank is the end of the scan.
#pragma once

#include "tools/render/render_job.hpp"

#include "shadow/clocked/post_process.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace umbra78::tools {

struct WaterfallOptions {
    int points = 6;  // 1 .. 61
    // The first column. None: the cycle in which the first visible pixel leaves the reader.
    std::optional<std::uint64_t> from;
    int max_cycles = 400;  // shown; more are said to be left out
    int wide = 80;          // columns, before the rows are begun again
    // Which clocks are held in a cycle; none where it is empty.
    std::function<hw::StageMask(std::uint64_t cycle)> holds;
};

// The machine is ticked from where it stands until the points have left it. Behind the picture
// each point's cycles are told, and the closed form's S and L.
template <class Depth>
std::string waterfall(shadow::ClockedPostProcess<Depth>& machine,
                      const WaterfallOptions& options = {});

// The same on a machine of its own over a rendered frame.
std::string waterfall(const RenderJob&, const WaterfallOptions& options = {});

}  // namespace umbra78::tools
