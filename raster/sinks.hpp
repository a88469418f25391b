// The sinks that keep samples in a frame store: DepthSink Z alone (the light's view), PictureSink
// Z, and for each channel the intensity and the direct shares (the observer's). hw/MACHINE.md,
// sections 8 and 23.
//
// A nearer sample replaces what is stored; at equal Z the smaller (intensity, direct shares) does.
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

// The part of a pixel's record that shading makes. A store without intensities or direct shares
// traps.
template <class Depth>
class ShadePlanes {
public:
    explicit ShadePlanes(const hw::FrameStore<Depth>& store)
        : intensity_(store.intensity), direct_(store.direct), pixels_(store.depth.size()) {
        fixed::require(store.shades(), "picture: the store has no intensities or direct shares");
        channels_ = intensity_.size() / pixels_;
        sources_ = direct_.size() / intensity_.size();
        fixed::require(channels_ <= max_channels && sources_ <= max_sources,
                       "picture: the store has more planes than a sample has shades");
    }

    Shades at(std::size_t address) const {
        Shades shades{};
        for (std::size_t k = 0; k < channels_; ++k) {
            shades[k].intensity = intensity_[k * pixels_ + address];
            for (std::size_t l = 0; l < sources_; ++l)
                shades[k].direct[l] = direct_[(k * sources_ + l) * pixels_ + address];
        }
        return shades;
    }
    void put(std::size_t address, const Shades& shades) const {
        for (std::size_t k = 0; k < channels_; ++k) {
            intensity_[k * pixels_ + address] = shades[k].intensity;
            for (std::size_t l = 0; l < sources_; ++l)
                direct_[(k * sources_ + l) * pixels_ + address] = shades[k].direct[l];
        }
    }

private:
    std::span<std::uint8_t> intensity_, direct_;
    std::size_t pixels_, channels_ = 1, sources_ = 1;
};

template <class Depth>
class PictureSink {
public:
    static constexpr bool shades = true;

    PictureSink(hw::FrameStore<Depth>& store) : store_(store), planes_(store) {}

    bool hidden(const Footprint& f) const { return all_nearer(store_, f); }
    template <class Shading>
    void sample(const Sample& s, std::uint32_t code, const Shading* shading) {
        replaces(s, code, shading);
    }
    // The same, and whether the sample's record is now the stored one.
    template <class Shading>
    bool replaces(const Sample& s, std::uint32_t code, const Shading* shading) {
        const std::size_t a = store_.address(s.px, s.py);
        if (code > store_.depth[a]) return false;
        const Shades shade = shading->shade(s, 0);
        if (code == store_.depth[a] && shade >= planes_.at(a)) return false;
        store_.depth[a] = static_cast<Depth>(code);
        planes_.put(a, shade);
        return true;
    }

private:
    hw::FrameStore<Depth>& store_;
    ShadePlanes<Depth> planes_;
};

}  // namespace umbra78::raster
