// How much sooner a frame is ready with several workers: `tools/bench --threads N`.
#pragma once

namespace umbra78::tools {

// Prints, for each stage of several frames, the time of one worker over that of N: by the clock on
// the wall, with N threads; and by the processor's time of each part, laid out over N workers that
// each take the next part when they are ready, which other programs on the machine disturb less.
int compare_workers(int threads, int rounds);

}  // namespace umbra78::tools
