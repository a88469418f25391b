// The picture from what was drawn and the filtered masks, and the copying of planes, line by line.
#pragma once

#include "shadow/filters/composite.hpp"
#include "shadow/frame/buffers.hpp"
#include "shadow/frame/methods.hpp"
#include "shadow/frame/plan.hpp"
#include "shadow/lines.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace umbra78::shadow {

inline void copy(std::span<const std::uint8_t> from, std::span<std::uint8_t> to) {
    std::copy(from.begin(), from.end(), to.begin());
}

// The lines of a plane that are in the set, from one plane to the other.
inline void copy_lines(std::span<const std::uint8_t> from, const LineSet& lines,
                       std::span<std::uint8_t> to, const Executor& executor) {
    const auto n = static_cast<std::size_t>(lines.size());
    for_bands(executor, lines.size(), [&](hw::Band band, std::size_t) {
        for (int y = band.first; y < band.end; ++y)
            if (const std::size_t a = static_cast<std::size_t>(y) * n; lines.has(y))
                copy(from.subspan(a, n), to.subspan(a, n));
    });
}

// Darkens a channel of `picture` by a source's shadow on the lines in the set, into the channel's
// plane of the frame's picture, within a band; the other lines are those of `picture`.
template <class Depth>
void darken(const FrameInputs& in, std::size_t channel, std::size_t source,
            std::span<const std::uint8_t> picture, const LineSet& lines, const hw::Band& band,
            FrameBuffers<Depth>& frame) {
    const bool whole = in.settings.composite == Composite::whole;
    const std::span<const std::uint8_t> share = whole ? picture : frame.direct(channel, source);
    const std::span<const std::uint8_t> darkness =
        frame.lights[in.scene.source(source).first_light].filtered;
    const std::span<std::uint8_t> out = frame.picture_of(channel);
    // A shadow that is in the shading already darkens nothing more.
    const int density = method_of(in).in_shading ? 0 : in.settings.density_q8;
    const auto n = static_cast<std::size_t>(lines.size());
    for (int y = band.first; y < band.end; ++y) {
        const auto line = [&](auto plane) {
            return plane.subspan(static_cast<std::size_t>(y) * n, n);
        };
        if (lines.has(y)) {
            composite(line(picture), line(share), line(darkness), density, line(out));
        } else if (picture.data() != out.data()) {
            copy(line(picture), line(out));
        }
    }
}

// A channel of the picture within a band, darkened by all sources.
template <class Depth>
void composite_all(const FrameInputs& in, const FramePlan& plan, std::size_t channel,
                   const std::array<LineSet, max_sources>& lines, const hw::Band& band,
                   FrameBuffers<Depth>& frame) {
    std::span<const std::uint8_t> picture = frame.intensity(channel);
    const std::span<std::uint8_t> out = frame.picture_of(channel);
    for (std::size_t s = 0; s < in.scene.sources_used(); ++s) {
        if (plan.leaves_out(Omission::composite, in.scene.source(s).first_light)) continue;
        darken(in, channel, s, picture, lines[s], band, frame);
        picture = out;
    }
    if (picture.data() == out.data()) return;
    const std::size_t first = frame.observer.address(0, band.first);
    const std::size_t count = frame.observer.address(0, band.end) - first;
    copy(picture.subspan(first, count), out.subspan(first, count));
}

}  // namespace umbra78::shadow
