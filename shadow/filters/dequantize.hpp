// Edge dequantizing: the mask's stairs, followed as a chain, smoothed, and drawn again as area.
//
// How NYIT's "edge dequantizing filter similar to one advanced by Freeman" worked (Williams 1978,
// p. 273) is not published; this is the project's reading of Freeman's line-structure processing
// (Computing Surveys 6(1), 1974):
//   1. The boundary of the shadow is followed from pixel corner to pixel corner, a unit step at a
//      time in four directions, the shadow on the right hand; shadow pixels that touch only at a
//      corner are kept apart.
//   2. `passes` times, each node becomes (previous + 2 node + next) / 4, exactly: two more
//      fraction bits a pass. A node that touches the background, or the frame's edge, stays: that
//      is a silhouette, not a shadow's edge.
//   3. The area to the right of the smoothed chain is counted in 16 sub-rows of 1/16 pixel steps,
//      and becomes 0..255.
// A streaming filter: one pass holds three nodes, so no chain is ever stored.
#pragma once

#include "hw/frame_store.hpp"
#include "shadow/executor.hpp"
#include "shadow/lines.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace umbra78::shadow {

inline constexpr int max_dequantize_passes = 6;

// Scratch for a 2^xy_bits square: visited edges, a bit each, and signed coverage.
struct EdgeMemory {
    std::span<std::uint32_t> visited;  // size_px^2 / 32 words
    std::span<std::int16_t> coverage;  // (size_px + 2) size_px words
};
constexpr std::size_t edge_visited_words(int xy_bits) {
    return std::size_t{1} << (xy_bits > 2 ? 2 * xy_bits - 5 : 0);
}
constexpr std::size_t edge_coverage_words(int xy_bits) {
    return ((std::size_t{1} << xy_bits) + 2) << xy_bits;
}

// Shadow is mask >= 128. `observer` says what is background, which comes out 0. `mask` and `out`
// have a byte a pixel and may be one span. `passes` is 0 .. max_dequantize_passes; with 0 the mask
// comes out as it is, as 0 and 255. `memory` may be larger than needed. Returns the number of chain
// steps followed.
// `lines` has at least those with a shadow; the others are left as they are in `out`. A chain that
// passes a line runs along a shadow pixel of it, and smoothing moves no node beyond the first and
// the last line of its chain: so a line that is all lit comes out all lit.
// The executor's workers share what is done line by line; the chains are followed by one.
template <class Depth>
std::uint64_t dequantize(std::span<const std::uint8_t> mask,
                         const hw::ReadOnlyStore<Depth>& observer, Depth background, int passes,
                         EdgeMemory memory, std::span<std::uint8_t> out, const LineSet& lines,
                         const Executor& executor = {});
template <class Depth>
std::uint64_t dequantize(std::span<const std::uint8_t> mask,
                         const hw::ReadOnlyStore<Depth>& observer, Depth background, int passes,
                         EdgeMemory memory, std::span<std::uint8_t> out) {
    return dequantize<Depth>(mask, observer, background, passes, memory, out,
                             LineSet::of_frame(observer.xy_bits));
}

}  // namespace umbra78::shadow
