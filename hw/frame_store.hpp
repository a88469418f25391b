// The frame store: a Z plane and an intensity plane of 2^xy_bits x 2^xy_bits words.
//
// Row 0 is the top of the picture; word y 2^xy_bits + x holds pixel (x, y). The Z code is
// unsigned, 0 at the near plane; all ones is the background, and what is drawn is clamped to one
// code nearer. Nearer replaces (Catmull 1974, p. 32); a tie in Z goes to the smaller intensity,
// so the result depends on what is drawn and never on the order it is drawn in.
// Not emulated here: access times, refresh and video read-out (hw/memory/dram.hpp replays those).
#pragma once

#include "hw/machine_spec.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace umbra78::hw {

// Z codes of up to 16 bits are two ganged 8-bit planes, as NYIT could have them; wider ones are
// for study.
using Depth16 = std::uint16_t;
using Depth32 = std::uint32_t;

template <class Depth>
struct FrameStore {
    int xy_bits = 0;
    std::span<Depth> depth;             // size_px^2 words
    std::span<std::uint8_t> intensity;  // size_px^2 words, or empty in the light's view

    int size_px() const { return 1 << xy_bits; }
    std::size_t address(int x, int y) const {
        return (static_cast<std::size_t>(y) << xy_bits) + static_cast<std::size_t>(x);
    }

    void clear(const MachineSpec& spec) {
        std::fill(depth.begin(), depth.end(), static_cast<Depth>(spec.background()));
        std::fill(intensity.begin(), intensity.end(), std::uint8_t{0});
    }
};

// Counts of a frame's accesses: the first cycle count of the store is one cycle for each.
struct AccessCount {
    std::uint64_t reads = 0;
    std::uint64_t writes = 0;
    std::uint64_t cycles() const { return reads + writes; }
};

}  // namespace umbra78::hw
