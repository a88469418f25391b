// The sinks that keep samples in a frame store: DepthSink Z alone (the light's view), PictureSink
// Z and intensity (the observer's). hw/MACHINE.md, section 8.
//
// A nearer sample replaces what is stored; at equal Z the smaller intensity does. So the store
// holds the smallest (Z, intensity) in whatever order the samples come, and blocks may be skipped
// where they are hidden, reordered or shared out.
#pragma once

#include "hw/frame_store.hpp"
#include "raster/footprint.hpp"
#include "raster/sampling.hpp"
#include "raster/shading.hpp"

#include <cstdint>

namespace umbra78::raster {

// Whether every stored depth in the footprint's pixels is nearer than the footprint.
template <class Depth>
bool all_nearer(const hw::FrameStore<Depth>& store, const Footprint& f) {
    for (int y = f.y0; y <= f.y1; ++y) {
        const Depth* row = store.depth.data() + store.address(0, y);
        bool nearer = true;
        for (int x = f.x0; x <= f.x1; ++x) nearer &= row[x] < f.nearest;
        if (!nearer) return false;
    }
    return true;
}

template <class Depth>
struct DepthSink {
    static constexpr bool shades = false;
    hw::FrameStore<Depth>& store;

    bool hidden(const Footprint& f) const { return all_nearer(store, f); }
    void sample(const Sample& s, std::uint32_t code, const BlockShading*) {
        Depth& z = store.depth[store.address(s.px, s.py)];
        if (code < z) z = static_cast<Depth>(code);
    }
};

template <class Depth>
struct PictureSink {
    static constexpr bool shades = true;
    hw::FrameStore<Depth>& store;

    bool hidden(const Footprint& f) const { return all_nearer(store, f); }
    void sample(const Sample& s, std::uint32_t code, const BlockShading* shading) {
        const std::size_t a = store.address(s.px, s.py);
        if (code > store.depth[a]) return;
        const std::uint8_t level = shading->level(s.leaf_i, s.leaf_j, false);
        if (code == store.depth[a] && level >= store.intensity[a]) return;
        store.depth[a] = static_cast<Depth>(code);
        store.intensity[a] = level;
    }
};

}  // namespace umbra78::raster
