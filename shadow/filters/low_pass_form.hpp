// The steps of the low-pass along a line, once for each instruction set (fixed/lane_sets.hpp).
// With m a neighbour's darkness, 0 where it is missing (background, or beyond the frame), and
// n = 1 there
//
//   sum of w (missing ? self : darkness) = sum of w m  +  self  sum of w n
//
// and both sums are those of 1 2 1 across and 1 2 1 down.
#pragma once

#include "hw/frame_store.hpp"
#include "shadow/lines.hpp"

#include <cstdint>
#include <span>
#include <string_view>

namespace umbra78::shadow {

// Part of a line. `self` and `missing` begin with the pixel left of the part.
struct LowPassStrip {
    static constexpr int most = 256;
    std::uint8_t missing[most + 2], self[most + 2];
    std::uint16_t sum[most];     // of darkness, across
    std::uint8_t weight[most];   // of what is missing, across
    bool dark;                   // whether `self` is not 0 throughout; without it there are no sums
};

struct LowPassForm {
    std::string_view name;
    bool (*supported)();  // by this processor
    // Returns whether any of `self` is not 0.
    bool (*read)(const hw::Depth16* depth, const std::uint8_t* mask, hw::Depth16 background,
                 int count, std::uint8_t* missing, std::uint8_t* self);
    void (*across)(LowPassStrip& strip, int count);
    void (*down)(const LowPassStrip& above, const LowPassStrip& here, const LowPassStrip& below,
                 int count, std::uint8_t* out);
};

// `plain` first, the fastest last.
std::span<const LowPassForm> low_pass_forms();

// low_pass by a form.
template <class Depth>
void low_pass(std::span<const std::uint8_t> mask, const hw::ReadOnlyStore<Depth>& observer,
              Depth background, std::span<std::uint8_t> out, const LineSet& lines,
              const LowPassForm& form);

}  // namespace umbra78::shadow
