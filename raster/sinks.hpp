// What becomes of samples: the light's view keeps Z alone, the observer's Z and intensity.
//
// Nearer replaces; a tie goes to the smaller intensity. The smallest (Z, intensity) wins whatever
// the order of the samples, which is what lets blocks be skipped, reordered or shared out.
#pragma once

#include "hw/frame_store.hpp"
#include "raster/sampling.hpp"
#include "raster/shading.hpp"

#include <cstdint>

namespace umbra78::raster {

// Is every stored depth in the window nearer than `code`?
template <class Depth>
bool all_nearer(const hw::FrameStore<Depth>& store, int x0, int y0, int x1, int y1,
                std::uint32_t code) {
    for (int y = y0; y <= y1; ++y) {
        const Depth* row = store.depth.data() + store.address(0, y);
        bool nearer = true;
        for (int x = x0; x <= x1; ++x) nearer &= row[x] < code;
        if (!nearer) return false;
    }
    return true;
}

template <class Depth>
struct DepthSink {
    static constexpr bool shades = false;
    hw::FrameStore<Depth>& store;

    bool hidden(int x0, int y0, int x1, int y1, std::uint32_t code) const {
        return all_nearer(store, x0, y0, x1, y1, code);
    }
    void sample(const Sample& s, std::uint32_t code, const BlockShading*) {
        Depth& z = store.depth[store.address(s.px, s.py)];
        if (code < z) z = static_cast<Depth>(code);
    }
};

template <class Depth>
struct PictureSink {
    static constexpr bool shades = true;
    hw::FrameStore<Depth>& store;

    bool hidden(int x0, int y0, int x1, int y1, std::uint32_t code) const {
        return all_nearer(store, x0, y0, x1, y1, code);
    }
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
