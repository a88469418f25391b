// The post-process of a frame's light that shines in all directions (shadow/sectors.hpp).
#pragma once

#include "shadow/frame/drawing.hpp"
#include "shadow/sectors.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace umbra78::shadow {

template <class Depth>
SectorMaps<Depth> sector_maps(const FrameInputs& in, std::size_t first,
                              const FrameBuffers<Depth>& frame) {
    SectorMaps<Depth> maps{.observer = frame.observer, .map = {}, .matrix = {}, .receiver = {}};
    for (std::size_t k = 0; k < hw::sector_count; ++k) {
        maps.map[k] = frame.lights[first + k].map;
        maps.matrix[k] = in.matrices.lights[first + k].observer_to_light;
        maps.receiver[k] = receiver_words(in, first + k);
    }
    return maps;
}

// Of one light of a source with sectors: its own pass or, for the first, the one for all of them.
template <class Depth>
void cast_sectors(const FrameInputs& in, const FramePlan& plan, std::size_t l,
                  FrameBuffers<Depth>& frame, FrameCounts& counts) {
    const std::size_t first = in.scene.source_of(l).first_light;
    const SectorMaps<Depth> maps = sector_maps(in, first, frame);
    const std::span<std::uint8_t> mask = frame.lights[first].mask;
    if (in.settings.sector_test == SectorTest::every) {
        counts.lights[l].post_process = count_bands<PostProcessCounts>(
            frame.executor, in.settings.machine.size_px(), [&](hw::Band band, std::size_t) {
                return sector_pass(maps, static_cast<int>(l - first), in.settings, work_of(plan),
                                   mask, band);
            });
    } else if (l == first) {
        const auto counted = count_bands<SectorCounts>(
            frame.executor, in.settings.machine.size_px(), [&](hw::Band band, std::size_t) {
                return classified_pass(maps, in.settings, work_of(plan), mask, band);
            });
        for (std::size_t k = 0; k < counted.size(); ++k)
            counts.lights[first + k].post_process = counted[k];
    }
}

}  // namespace umbra78::shadow
