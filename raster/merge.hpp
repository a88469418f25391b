// Two stores become one: for each pixel the smaller record, as if the samples of both had gone into
// the same store (hw/MACHINE.md, section 8).
//
// In: two stores of one size with the same planes. Workers that draw the facets of a mesh each have
// a store of their own; afterwards these are merged, band by band.
#pragma once

#include "hw/band.hpp"
#include "raster/sinks.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace umbra78::raster {

namespace detail {

inline constexpr std::size_t merged_at_once = 64;
using Taken = std::array<std::uint8_t, merged_at_once>;  // 255 where the record is taken

template <class Word>
void take_words(std::span<const Word> from, std::span<Word> into, std::size_t at,
                const Taken& taken, std::size_t count) {
    for (std::size_t k = 0; k < count; ++k)
        into[at + k] = taken[k] != 0 ? from[at + k] : into[at + k];
}

// Whether the record at an address comes first by what follows Z.
template <class Depth>
bool is_less(const hw::FrameStore<Depth>& from, const hw::FrameStore<Depth>& into,
             std::size_t address) {
    if (into.intensity.empty()) return false;
    const ShadePlanes<Depth> a(from), b(into);
    const std::strong_ordering order = a.at(address) <=> b.at(address);
    if (order != 0 || into.normal.empty()) return order < 0;
    return NormalPlanes<Depth>(from).at(address) < NormalPlanes<Depth>(into).at(address);
}

}  // namespace detail

// What `from` has at its background is never read.
template <class Depth>
void merge(const hw::FrameStore<Depth>& from, const hw::FrameStore<Depth>& into, Depth background,
           const hw::Band& band) {
    using detail::merged_at_once;
    const std::size_t pixels = into.depth.size(), end = into.address(0, band.end);
    for (std::size_t at = into.address(0, band.first); at < end; at += merged_at_once) {
        const std::size_t count = std::min(merged_at_once, end - at);
        detail::Taken taken{};
        std::uint8_t any = 0, ties = 0;
        for (std::size_t k = 0; k < count; ++k) {
            const Depth ours = from.depth[at + k], theirs = into.depth[at + k];
            taken[k] = ours < theirs ? 255 : 0;
            any |= taken[k];
            ties |= ours == theirs && ours != background ? 1 : 0;
        }
        for (std::size_t k = 0; ties != 0 && k < count; ++k) {
            const Depth ours = from.depth[at + k];
            if (ours != into.depth[at + k] || ours == background) continue;
            if (detail::is_less(from, into, at + k)) any = taken[k] = 255;
        }
        if (any == 0) continue;
        const auto planes = [&](auto of_from, auto of_into) {
            using Word = typename decltype(of_into)::value_type;
            for (std::size_t p = 0; p < of_into.size(); p += pixels)
                detail::take_words<Word>(of_from.subspan(p, pixels), of_into.subspan(p, pixels),
                                         at, taken, count);
        };
        planes(from.depth, into.depth);
        planes(from.intensity, into.intensity);
        planes(from.direct, into.direct);
        planes(from.normal, into.normal);
    }
}

}  // namespace umbra78::raster
