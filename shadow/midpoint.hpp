// The midpoint map (Woo 1992): half way between the two nearest depths of a texel.
//
//   z1 < z2 the two smallest different codes of the texel's samples, or background
//   map = (z1 + z2) >> 1                                         hw/MACHINE.md, section 24
//
// While it is drawn the map holds z1, and a second plane of as many words z2. Both are the least of
// what came, so the order of the samples changes nothing.
#pragma once

#include "raster/sinks.hpp"

#include <algorithm>
#include <cstdint>
#include <span>

namespace umbra78::shadow {

// Both stores were cleared to the background.
template <class Depth>
struct MidpointSink {
    static constexpr bool shades = false, by_pixel = true;
    hw::FrameStore<Depth>& nearest;
    hw::FrameStore<Depth> second;

    bool hidden(const raster::Footprint& f) const { return raster::all_nearer(second, f); }
    void sample(const raster::Sample& s, std::uint32_t code, const void*) {
        const std::size_t a = nearest.address(s.px, s.py);
        const auto z = static_cast<Depth>(code);
        Depth &z1 = nearest.depth[a], &z2 = second.depth[a];
        if (z < z1) {
            z2 = z1;
            z1 = z;
        } else if (z > z1 && z < z2) {
            z2 = z;
        }
    }
};

// The map becomes that of the midpoints.
template <class Depth>
void take_midpoints(const hw::MachineSpec& spec, std::span<const Depth> second,
                    std::span<Depth> map) {
    std::transform(map.begin(), map.end(), second.begin(), map.begin(), [&](Depth z1, Depth z2) {
        const auto middle = static_cast<std::uint32_t>((std::uint64_t{z1} + z2) >> 1);
        return static_cast<Depth>(middle == spec.background() ? middle : spec.kept(middle));
    });
}

}  // namespace umbra78::shadow
