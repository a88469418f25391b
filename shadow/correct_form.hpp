// The correct form: each generated point is tested before it is shaded.
//
// The point goes to the light with its own x and y, not its pixel's, and a point in shadow gets
// the ambient light alone: no highlight stands in shadow (Williams 1978, p. 272). Every generated
// point is transformed, hidden or not, so the cost grows with the area of all surfaces drawn; it
// is why the paper prefers the post-process. Nearer replaces; a tie goes to the smaller intensity,
// then to the smaller direct share, then to the smaller mask.
#pragma once

#include "raster/sinks.hpp"
#include "shadow/compare.hpp"
#include "shadow/post_process.hpp"

#include <cstdint>
#include <span>

namespace umbra78::shadow {

template <class Depth>
class CorrectSink {
public:
    static constexpr bool shades = true;

    CorrectSink(hw::FrameStore<Depth>& store, const LightMap<Depth>& map,
                const hw::TransformUnit& unit, const ShadowTest& settings,
                std::span<std::uint8_t> mask)
        : CorrectSink(store, map, unit, settings, mask, needed_work(settings).noise) {}
    CorrectSink(hw::FrameStore<Depth>& store, const LightMap<Depth>& map,
                const hw::TransformUnit& unit, const ShadowTest& settings,
                std::span<std::uint8_t> mask, bool noise)
        : store_(store), map_(map), unit_(unit), settings_(settings), mask_(mask),
          draws_noise_(hw::built(hw::Feature::dither) && noise) {
        check_machine(settings.machine);
        fixed::require(settings.receiver == Receiver::point,
                       "correct form: a point that is drawn has no neighbours for a plane");
        check_observer<Depth>(store, settings.machine);
        fixed::require(store.shades(),
                       "correct form: the observer's store has no intensities or direct shares");
        check_light(map.store, settings.machine);
        check_mask(mask, settings.machine);
    }

    // Nothing is left out: the machine transforms every point it generates.
    bool hidden(const raster::Footprint&) const { return false; }

    template <class Shading>
    void sample(const raster::Sample& s, std::uint32_t code, const Shading* shading) {
        const std::size_t a = store_.address(s.px, s.py);
        if (code > store_.depth[a]) return;
        const bool shadow = in_shadow(map_, unit_(words(s, code)), noise(s));
        const raster::Shade shade = shading->shade(s, shadow);
        const std::uint8_t mask = shadow ? mask_shadow : mask_lit;
        if (code == store_.depth[a]) {
            const raster::Shade stored{store_.intensity[a], store_.direct[a]};
            if (shade > stored || (shade == stored && mask >= mask_[a])) return;
        }
        store_.depth[a] = static_cast<Depth>(code);
        store_.intensity[a] = shade.intensity;
        store_.direct[a] = shade.direct;
        mask_[a] = mask;
    }

private:
    // The point's own place in input words, rounded half up; index registration is half a pixel
    // to the left and above, as in the post-process.
    hw::Words words(const raster::Sample& s, std::uint32_t code) const {
        const hw::MachineSpec& m = settings_.machine;
        const std::int32_t off =
            settings_.registration == Registration::index ? 1 << (raster::raster_fraction - 1) : 0;
        const auto word = [&](std::int32_t v) {
            return static_cast<std::int32_t>(
                fixed::scale_shift(v - off, raster::raster_fraction - m.input_fraction(),
                                   fixed::Rounding::half_up));
        };
        return {word(s.x), word(s.y), pixel_words(s.px, s.py, code, settings_).z};
    }
    hw::DitherWords noise(const raster::Sample& s) const {
        if (!draws_noise_) return {0, 0};
        return hw::NoiseSource(drawn_dither(settings_), settings_.machine, s.px, s.py).next();
    }

    hw::FrameStore<Depth>& store_;
    const LightMap<Depth>& map_;
    const hw::TransformUnit& unit_;
    const ShadowTest& settings_;
    std::span<std::uint8_t> mask_;
    bool draws_noise_;
};

}  // namespace umbra78::shadow
