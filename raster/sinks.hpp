// The sinks that keep samples in a frame store: DepthSink Z alone (the light's view), PictureSink
// Z, intensity and direct share (the observer's). hw/MACHINE.md, section 8.
//
// A nearer sample replaces what is stored; at equal Z the smaller (intensity, direct share) does.
// So the store holds the smallest record in whatever order the samples come, and blocks may be
// skipped where they are hidden, reordered or shared out.
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
    void sample(const Sample& s, std::uint32_t code, const void*) {
        Depth& z = store.depth[store.address(s.px, s.py)];
        if (code < z) z = static_cast<Depth>(code);
    }
};

// A store without intensities or direct shares traps.
template <class Depth>
class PictureSink {
public:
    static constexpr bool shades = true;

    PictureSink(hw::FrameStore<Depth>& store) : store_(store) {
        fixed::require(store.shades(), "picture: the store has no intensities or direct shares");
    }

    bool hidden(const Footprint& f) const { return all_nearer(store_, f); }
    template <class Shading>
    void sample(const Sample& s, std::uint32_t code, const Shading* shading) {
        const std::size_t a = store_.address(s.px, s.py);
        if (code > store_.depth[a]) return;
        const Shade shade = shading->shade(s, false);
        if (code == store_.depth[a] && shade >= Shade{store_.intensity[a], store_.direct[a]})
            return;
        store_.depth[a] = static_cast<Depth>(code);
        store_.intensity[a] = shade.intensity;
        store_.direct[a] = shade.direct;
    }

private:
    hw::FrameStore<Depth>& store_;
};

}  // namespace umbra78::raster
