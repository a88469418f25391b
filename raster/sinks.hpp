// The sinks that keep samples in a frame store: DepthSink Z alone (the light's view), PictureSink
// Z, and for each channel the intensity and the direct shares (the observer's). hw/MACHINE.md,
// sections 8 and 23.
// A store that keeps normals gets them with the rest of the record (section 27).
//
// A nearer sample replaces what is stored; at equal Z the smaller (intensity, direct shares,
// normal) does.
// So the store holds the smallest record in whatever order the samples come, and blocks may be
// skipped where they are hidden, reordered or shared out: to copies of a sink that draw different
// lines at the same time (`by_pixel`: a sample reads and writes its own pixel alone), or to sinks
// with stores of their own (`into`), which are merged afterwards (merge.hpp).
#pragma once

#include "hw/features.hpp"
#include "hw/frame_store.hpp"
#include "raster/block_form.hpp"
#include "raster/footprint.hpp"
#include "raster/sampling.hpp"
#include "raster/shading.hpp"

#include <array>
#include <compare>
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

// A store's plane as the forms of a mesh read and write it; none for wider codes.
template <class Depth>
CodePlane code_plane_of(const hw::FrameStore<Depth>& store, const hw::MachineSpec& spec,
                        bool depth_alone) {
    if constexpr (std::is_same_v<Depth, hw::Depth16>) {
        if (spec.depth_rounding == fixed::Rounding::half_up &&
            spec.depth_store == hw::DepthStore::fixed)
            return {store.depth.data(),
                    store.xy_bits,
                    depth_guard(spec),
                    static_cast<std::int32_t>(spec.depth_offset()),
                    static_cast<std::int32_t>(spec.background()),
                    depth_alone};
    }
    return {};
}

// Asks for the memory of a plane's pixels in a footprint, before samples come to them.
template <class Word>
void expect_pixels(const Word* plane, int xy_bits, const Footprint& f) {
    for (int y = f.y0; y <= f.y1; ++y) {
        const Word* row = plane + (static_cast<std::size_t>(y) << xy_bits);
        __builtin_prefetch(row + f.x0, 1);
        __builtin_prefetch(row + f.x1, 1);
    }
}

template <class Depth>
struct DepthSink {
    static constexpr bool shades = false, by_pixel = true;
    hw::FrameStore<Depth>& store;

    DepthSink into(hw::FrameStore<Depth>& other) const { return {other}; }
    hw::FrameStore<Depth> target() const { return {store.xy_bits, store.depth}; }

    bool hidden(const Footprint& f) const { return all_nearer(store, f); }
    void expect(const Footprint& f) const { expect_pixels(store.depth.data(), store.xy_bits, f); }
    CodePlane code_plane(const hw::MachineSpec& spec) const {
        return code_plane_of(store, spec, true);
    }
    void sample(const Sample& s, std::uint32_t code, const void*) {
        Depth& z = store.depth[store.address(s.px, s.py)];
        const std::uint32_t kept = z;  // stored in any case: which is the nearer is hard to predict
        z = static_cast<Depth>(code < kept ? code : kept);
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

    // Whether a leaf's levels, which lie by planes already, come before those at an address: asked
    // where depths are equal.
    [[gnu::noinline]] bool is_less(const LeafLevels& levels, std::size_t leaf,
                                   std::size_t address) const {
        const auto* plane = levels.level;
        for (std::size_t k = 0; k < channels_; ++k) {
            for (std::size_t l = 0; l <= sources_; ++l) {
                const std::uint8_t ours = (*plane++)[leaf];
                const std::uint8_t kept =
                    l == 0 ? intensity_[k * pixels_ + address]
                           : direct_[(k * sources_ + l - 1) * pixels_ + address];
                if (ours != kept) return ours < kept;
            }
        }
        return false;
    }
    void put(std::size_t address, const LeafLevels& levels, std::size_t leaf) const {
        const auto* plane = levels.level;
        if (channels_ == 1 && sources_ == 1) {  // most frames
            intensity_[address] = plane[0][leaf];
            direct_[address] = plane[1][leaf];
            return;
        }
        for (std::size_t k = 0; k < channels_; ++k) {
            intensity_[k * pixels_ + address] = (*plane++)[leaf];
            for (std::size_t l = 0; l < sources_; ++l)
                direct_[(k * sources_ + l) * pixels_ + address] = (*plane++)[leaf];
        }
    }

private:
    std::span<std::uint8_t> intensity_, direct_;
    std::size_t pixels_, channels_ = 1, sources_ = 1;
};

// A normal as the store keeps it.
template <class Depth>
class NormalPlanes {
public:
    using Words = std::array<hw::NormalWord, 3>;

    explicit NormalPlanes(const hw::FrameStore<Depth>& store)
        : normal_(store.normal), pixels_(store.depth.size()) {
        fixed::require(normal_.empty() || normal_.size() == 3 * pixels_,
                       "picture: the store's normals are not three planes");
    }

    bool kept() const { return hw::built(hw::Feature::surface_bias) && !normal_.empty(); }
    static Words words(const UnitVector& n) {
        const auto word = [](std::int32_t k) {
            return static_cast<hw::NormalWord>(k + hw::no_normal);
        };
        return {word(n[0]), word(n[1]), word(n[2])};
    }
    Words at(std::size_t address) const {
        return {normal_[address], normal_[pixels_ + address], normal_[2 * pixels_ + address]};
    }
    void put(std::size_t address, const Words& words) const {
        for (std::size_t k = 0; k < 3; ++k) normal_[k * pixels_ + address] = words[k];
    }

private:
    std::span<hw::NormalWord> normal_;
    std::size_t pixels_;
};

template <class Depth>
class PictureSink {
public:
    static constexpr bool shades = true, by_pixel = true;

    PictureSink(hw::FrameStore<Depth>& store) : store_(store), planes_(store), normals_(store) {}

    PictureSink into(hw::FrameStore<Depth>& other) const { return PictureSink(other); }
    const hw::FrameStore<Depth>& target() const { return store_; }

    bool hidden(const Footprint& f) const { return all_nearer(store_, f); }
    void expect(const Footprint& f) const {
        const std::size_t pixels = store_.depth.size();
        expect_pixels(store_.depth.data(), store_.xy_bits, f);
        for (std::size_t a = 0; a < store_.intensity.size(); a += pixels)
            expect_pixels(store_.intensity.data() + a, store_.xy_bits, f);
        for (std::size_t a = 0; a < store_.direct.size(); a += pixels)
            expect_pixels(store_.direct.data() + a, store_.xy_bits, f);
    }
    bool keeps(int px, int py, std::uint32_t code) const {
        return code <= store_.depth[store_.address(px, py)];
    }
    template <class Shading>
    void sample(const Sample& s, std::uint32_t code, const Shading* shading) {
        if constexpr (requires { shading->kept(); }) {
            if (shading->kept() != nullptr && takes_levels()) {
                take(s.px, s.py, code, *shading->kept(), leaf_number(s));
                return;
            }
        }
        replaces(s, code, shading);
    }
    // The same, and whether the sample's record is now the stored one.
    template <class Shading>
    bool replaces(const Sample& s, std::uint32_t code, const Shading* shading) {
        const std::size_t a = store_.address(s.px, s.py);
        if (code > store_.depth[a]) return false;
        const Shades shade = shading->shade(s, 0);
        if (code == store_.depth[a]) {
            const std::strong_ordering order = shade <=> planes_.at(a);
            if (order > 0 || (order == 0 && !normals_.kept())) return false;
            if (order == 0 && normals_.words(shading->normal(s)) >= normals_.at(a)) return false;
        }
        store_.depth[a] = static_cast<Depth>(code);
        planes_.put(a, shade);
        if (normals_.kept()) normals_.put(a, normals_.words(shading->normal(s)));
        return true;
    }

    // A sample whose levels are made already, where no normals are kept.
    CodePlane code_plane(const hw::MachineSpec& spec) const {
        return code_plane_of(store_, spec, false);
    }
    bool takes_levels() const { return !normals_.kept(); }
    [[gnu::always_inline]] void take(int px, int py, std::uint32_t code, const LeafLevels& levels,
                                     std::size_t leaf) {
        take(store_.address(px, py), code, levels, leaf);
    }
    [[gnu::always_inline]] void take(std::size_t a, std::uint32_t code, const LeafLevels& levels,
                                     std::size_t leaf) {
        Depth& z = store_.depth[a];
        if (code > z || (code == z && !planes_.is_less(levels, leaf, a))) return;
        z = static_cast<Depth>(code);
        planes_.put(a, levels, leaf);
    }

private:
    hw::FrameStore<Depth>& store_;
    ShadePlanes<Depth> planes_;
    NormalPlanes<Depth> normals_;
};

}  // namespace umbra78::raster
