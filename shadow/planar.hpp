// The planar shadow's two sinks (Blinn 1988; hw/MACHINE.md, section 26). The ground is drawn first;
// then what casts, flat, into the masks; then what stands before the ground.
//
//   CoverageSink   a sample darkens its pixel wherever the store holds something, once and for all
//   BeforeSink     as PictureSink; a sample that replaces the stored record lights its pixel again
//
// So a mask is dark where the visible record is the ground's and a shadow covers it, whatever the
// order of the samples in each.
#pragma once

#include "hw/frame_store.hpp"
#include "raster/sinks.hpp"
#include "shadow/post_process.hpp"

#include <cstdint>
#include <span>

namespace umbra78::shadow {

template <class Depth>
class CoverageSink {
public:
    static constexpr bool shades = false, by_pixel = true;

    // `store` holds the ground alone.
    CoverageSink(const hw::FrameStore<Depth>& store, const hw::MachineSpec& spec,
                 std::span<std::uint8_t> mask)
        : store_(store), none_(static_cast<Depth>(spec.background())), mask_(mask) {
        check_mask(mask, spec);
    }

    bool hidden(const raster::Footprint& f) const {
        for (int y = f.y0; y <= f.y1; ++y) {
            const std::size_t row = store_.address(0, y);
            for (int x = f.x0; x <= f.x1; ++x) {
                const std::size_t a = row + static_cast<std::size_t>(x);
                if (mask_[a] == mask_lit && store_.depth[a] != none_) return false;
            }
        }
        return true;
    }
    void sample(const raster::Sample& s, std::uint32_t, const void*) {
        const std::size_t a = store_.address(s.px, s.py);
        if (store_.depth[a] != none_) mask_[a] = mask_shadow;
    }

private:
    const hw::FrameStore<Depth>& store_;
    Depth none_;
    std::span<std::uint8_t> mask_;
};

// `light_up(address)` sets every light's mask there to mask_lit.
template <class Depth, class LightUp>
class BeforeSink {
public:
    static constexpr bool shades = true, by_pixel = true;

    BeforeSink(hw::FrameStore<Depth>& store, LightUp light_up)
        : store_(store), picture_(store), light_up_(light_up) {}

    bool hidden(const raster::Footprint& f) const { return picture_.hidden(f); }
    template <class Shading>
    void sample(const raster::Sample& s, std::uint32_t code, const Shading* shading) {
        if (picture_.replaces(s, code, shading)) light_up_(store_.address(s.px, s.py));
    }

private:
    hw::FrameStore<Depth>& store_;
    raster::PictureSink<Depth> picture_;
    LightUp light_up_;
};

}  // namespace umbra78::shadow
