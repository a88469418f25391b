// What a filter of the mask requires: a byte a pixel in and out, and the observer's Z codes.
#pragma once

#include "fixed/trap.hpp"
#include "hw/frame_store.hpp"
#include "shadow/lines.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace umbra78::shadow {

template <class Depth>
void check_filter(std::span<const std::uint8_t> mask, const hw::FrameStore<const Depth>& observer,
                  std::span<const std::uint8_t> out, const LineSet& lines) {
    fixed::require(observer.xy_bits >= 4 && observer.xy_bits <= 12,
                   "filter: a frame has 16 to 4096 pixels a side");
    const std::size_t pixels = std::size_t{1} << (2 * observer.xy_bits);
    fixed::require(observer.depth.size() == pixels,
                   "filter: the observer's store has not one word for each pixel");
    fixed::require(mask.size() == pixels && out.size() == pixels,
                   "filter: the mask or the result has not one byte for each pixel");
    fixed::require(lines.size() == observer.size_px(),
                   "filter: the set of lines is of another frame");
}

}  // namespace umbra78::shadow
