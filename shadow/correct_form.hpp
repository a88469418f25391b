// The correct form: each generated point is tested before it is shaded.
//
// The point goes to each light with its own x and y, not its pixel's, and a point in a light's
// shadow gets nothing of that light: no highlight stands in shadow (Williams 1978, p. 272). Every
// generated point is transformed, hidden or not, so the cost grows with the area of all surfaces
// drawn; it is why the paper prefers the post-process. Nearer replaces; a tie goes to the smaller
// intensities and direct shares, then to the smaller masks.
#pragma once

#include "raster/sinks.hpp"
#include "shadow/compare.hpp"
#include "shadow/post_process.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <span>

namespace umbra78::shadow {

// A light as the correct form tests points by it.
template <class Depth>
struct TestedLight {
    LightMap<Depth> map;
    hw::TransformUnit unit;  // observer to light
    std::span<std::uint8_t> mask;
};
// The lights of a frame, each a source.
template <class Depth>
using TestedLights = raster::BySource<std::optional<TestedLight<Depth>>>;

template <class Depth>
class CorrectSink {
public:
    static constexpr bool shades = true, by_pixel = true;

    CorrectSink(hw::FrameStore<Depth>& store, const TestedLights<Depth>& lights,
                const ShadowTest& settings, bool noise)
        : store_(checked(store, lights, settings.machine)), planes_(store), lights_(lights),
          settings_(settings), draws_noise_(hw::built(hw::Feature::dither) && noise) {
        fixed::require(settings.receiver == Receiver::point,
                       "correct form: a point that is drawn has no neighbours for a plane");
    }

    // Nothing is left out: the machine transforms every point it generates.
    bool hidden(const raster::Footprint&) const { return false; }

    template <class Shading>
    void sample(const raster::Sample& s, std::uint32_t code, const Shading* shading) {
        const std::size_t a = store_.address(s.px, s.py);
        if (code > store_.depth[a]) return;
        const hw::Words place = words(s, code);
        const hw::DitherWords d = noise(s);
        const hw::TapBytes taps = tap_noise(s);
        raster::Shadowed shadowed = 0;
        for (std::size_t l = 0; l < lights_.size(); ++l)
            if (lights_[l] && in_shadow(lights_[l]->map, lights_[l]->unit(place), d, taps))
                shadowed |= 1u << l;
        const raster::Shades shade = shading->shade(s, shadowed);
        if (code == store_.depth[a]) {
            const raster::Shades stored = planes_.at(a);
            if (shade > stored || (shade == stored && !smaller(shadowed, a))) return;
        }
        store_.depth[a] = static_cast<Depth>(code);
        planes_.put(a, shade);
        for (std::size_t l = 0; l < lights_.size(); ++l)
            if (lights_[l]) lights_[l]->mask[a] = mask_of(shadowed, l);
    }

private:
    static hw::FrameStore<Depth>& checked(hw::FrameStore<Depth>& store,
                                          const TestedLights<Depth>& lights,
                                          const hw::MachineSpec& machine) {
        check_machine(machine);
        check_observer<Depth>(store, machine);
        for (const std::optional<TestedLight<Depth>>& light : lights) {
            if (!light) continue;
            check_light(light->map.store, machine);
            check_mask(light->mask, machine);
        }
        return store;
    }
    static std::uint8_t mask_of(raster::Shadowed shadowed, std::size_t light) {
        return (shadowed >> light & 1u) != 0 ? mask_shadow : mask_lit;
    }
    // Whether these masks come before those stored, the first light's first.
    bool smaller(raster::Shadowed shadowed, std::size_t a) const {
        for (std::size_t l = 0; l < lights_.size(); ++l)
            if (lights_[l] && mask_of(shadowed, l) != lights_[l]->mask[a])
                return mask_of(shadowed, l) < lights_[l]->mask[a];
        return false;
    }
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

    hw::TapBytes tap_noise(const raster::Sample& s) const {
        const int taps = window_of(settings_).noisy_taps();
        if (taps == 0) return {};
        return hw::TapNoise(settings_.dither.seed, taps, settings_.machine, s.px, s.py).next();
    }

    hw::FrameStore<Depth>& store_;
    raster::ShadePlanes<Depth> planes_;
    const TestedLights<Depth>& lights_;
    const ShadowTest& settings_;
    bool draws_noise_;
};

}  // namespace umbra78::shadow
