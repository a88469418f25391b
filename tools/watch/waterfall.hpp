// A waterfall: which point is in which stage in which cycle, as text.
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
// 1 to 9, a to z, A to Z are points (visible pixels on their way) in the order in which they enter.
// '<' is a point that was there before, '>' one that comes after those asked for. '.' is a bubble,
// '=' a point that is done and blocked by the next stage, '#' a point whose clock is held. In the
// reader's row '.' reads background, '-' is a cycle of a longer read, '~' waits for the next slot,
// and a blank is after the end of the scan.
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
    // The first column's cycle. None: that in which the first visible pixel leaves the reader.
    std::optional<std::uint64_t> from;
    int max_cycles = 400;  // columns at most; the text says if points go on after them
    int wide = 80;         // columns before the rows are continued below
    // Which clocks are held in a cycle; empty: none.
    std::function<hw::StageMask(std::uint64_t cycle)> holds;
};

// Ticks the machine from its present cycle until the points have left it. After the picture the
// text has each point's cycles, and the closed form's S and L: longest_stay and sum_of_stays of
// hw/MACHINE.md, section 16.
template <class Depth>
std::string waterfall(shadow::ClockedPostProcess<Depth>& machine,
                      const WaterfallOptions& options = {});

// The same for a new machine over a rendered frame.
std::string waterfall(const RenderJob&, const WaterfallOptions& options = {});

}  // namespace umbra78::tools
