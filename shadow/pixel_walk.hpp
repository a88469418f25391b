// The walk of the post-process over the observer's frame: which pixels it visits, in which order,
// and the noise that each of them gets.
//
// Pixels go row by row from the top. The noise is clocked at every pixel, visible or not, so that a
// pixel's noise depends on its place alone.
#pragma once

#include "hw/band.hpp"
#include "shadow/lines.hpp"
#include "shadow/post_process.hpp"

#include <cstddef>
#include <cstdint>

namespace umbra78::shadow {

struct WalkedPixel {
    int x, y;
    std::size_t address;
    std::uint32_t code;
    bool visible;
    hw::DitherWords dither;
    hw::TapBytes taps;
};

// Calls `line(y)` for a scan line that is left out because nothing in it is visible, and
// `pixel(WalkedPixel)` for every pixel of the others, within a band of the frame. `noisy_taps`: a
// pixel's taps that read noise.
template <class Depth, class Line, class Pixel>
void walk_pixels(const hw::FrameStore<const Depth>& observer, const ShadowTest& test,
                 const PostProcessWork& work, int noisy_taps, hw::Band band, Line&& line,
                 Pixel&& pixel) {
    const hw::MachineSpec& spec = test.machine;
    const bool draws_noise = hw::built(hw::Feature::dither) && work.noise;
    const int size = spec.size_px();
    band = band.within(size);
    for (int y = band.first; y < band.end; ++y) {
        const std::span codes = observer.depth.subspan(observer.address(0, y),
                                                       static_cast<std::size_t>(size));
        if (!work.empty_lines && !has_visible<Depth>(codes, spec.background())) {
            line(y);
            continue;
        }
        hw::NoiseSource noise(drawn_dither(test), spec, 0, y);
        hw::TapNoise tap_noise(test.dither.seed, noisy_taps, spec, 0, y);
        for (int x = 0; x < size; ++x) {
            const hw::DitherWords d = draws_noise ? noise.next() : hw::DitherWords{0, 0};
            const hw::TapBytes taps = noisy_taps > 0 ? tap_noise.next() : hw::TapBytes{};
            const std::size_t address = observer.address(x, y);
            const std::uint32_t code = observer.depth[address];
            pixel(WalkedPixel{x, y, address, code, code != spec.background(), d, taps});
        }
    }
}

}  // namespace umbra78::shadow
