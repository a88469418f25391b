// From samples to a sink: what a drawing's sinks are, and the samples' Z codes and counts.
#pragma once

#include "raster/draw_counts.hpp"
#include "raster/draw_setup.hpp"
#include "raster/facet.hpp"
#include "raster/footprint.hpp"

#include <concepts>
#include <cstdint>
#include <type_traits>

namespace umbra78::raster {

// What is done with samples.
//   shades        a constant: whether sample() is given the block's shading, or nullptr
//   hidden(f)     whether every sample with this footprint would change nothing
//   expect(f)     if there: samples with this footprint will come
//   keeps(x, y, code)  if there: whether a sample of the pixel may change anything
//   begin_patch(k)     if there: the samples that follow are of this patch
//   makes_levels  a constant, if there: false where a block's levels are not made beforehand
//   sample(...)   one sample, its Z code and the shading of its block or facet
template <class T>
concept Sink = requires(T& sink, const T& unchanged, const Footprint& footprint,
                        const Sample& sample, std::uint32_t code, const BlockShading* shading,
                        const FacetShading* of_facet) {
    typename std::bool_constant<T::shades>;
    { unchanged.hidden(footprint) } -> std::same_as<bool>;
    { sink.sample(sample, code, shading) } -> std::same_as<void>;
    { sink.sample(sample, code, of_facet) } -> std::same_as<void>;
};

namespace detail {

// Hands what a drawing samples to its sink, with its Z code, and counts it.
template <class SampleSink>
struct Emitter {
    const DrawSetup& setup;
    SampleSink& sink;
    DrawCounts& counts;
    DepthCoder coder{setup.spec};

    // `offset` moves the sample away, and not beyond the far plane; it is not negative.
    [[gnu::always_inline]] bool code_of(std::int64_t z, std::int64_t offset,
                                        std::uint32_t& code) const {
        if (!coder(z, code)) return false;
        if (offset > 0) code = coder.moved(z + offset);
        ++counts.samples;
        return true;
    }
    template <class Shading>
    void operator()(const Sample& s, const Shading* shading, std::int64_t offset = 0) const {
        std::uint32_t code = 0;
        if (!setup.band.has(s.py)) return;
        if (code_of(s.z, offset, code)) sink.sample(s, code, shading);
    }
};

template <class SampleSink>
const Material* material_of(std::uint16_t material, const DrawSetup& setup) {
    if (!SampleSink::shades) return nullptr;
    fixed::require(material < setup.materials.size(),
                   "draw: a surface names a material that is not there");
    return &setup.materials[material];
}

}  // namespace detail

}  // namespace umbra78::raster
