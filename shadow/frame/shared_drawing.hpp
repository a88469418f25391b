// A drawing that is shared out among the executor's workers, in one of two ways:
//
//   bands   Each worker draws all patches, as far as they have samples on its own lines of the
//           store. Blocks behind others are left out as in a drawing by one, and only the blocks
//           that cross a band's limit are drawn twice.
//   stores  Each worker draws some of the facets into a store of its own, and these are merged by
//           the smallest record (raster/merge.hpp). Most of a small facet's time goes into its
//           corners, which every band would project anew.
//
// Both give the bits of a drawing by one worker, and the counts but for what is left out as hidden:
// a block that is hidden on one band's lines alone is drawn on the other's, and counted where it is
// drawn. No ledger reads those.
#pragma once

#include "raster/census.hpp"
#include "raster/merge.hpp"
#include "shadow/frame/buffers.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

namespace umbra78::shadow {

// A sample reads and writes its own pixel alone, so that copies may draw different lines.
template <class Sink>
concept BandSink = requires { requires Sink::by_pixel; };
// Keeps the smallest record alone, in a store that may be another.
template <class Sink, class Depth>
concept StoreSink = requires(const Sink& sink, hw::FrameStore<Depth>& other) {
    sink.into(other);
    sink.target();
};

namespace detail {

// Of all bands. A block is counted by one of them, a sample is drawn by one of them; and all go
// through all facets, so that what is counted of these is the same in each.
struct BandCounts {
    std::array<raster::DrawCounts, max_parts> of{};

    raster::DrawCounts sum(std::size_t bands) const {
        raster::DrawCounts all = of[0];
        for (std::size_t p = 1; p < bands; ++p) {
            all.patches += of[p].subdivided();
            all.tested_blocks += of[p].tested_blocks;
            all.splits += of[p].splits;
            all.unresolved += of[p].unresolved;
            all.blocks += of[p].blocks;
            all.samples += of[p].samples;
            all.facet_samples += of[p].facet_samples;
            all.hidden_blocks += of[p].hidden_blocks;
            all.tested_centres += of[p].tested_centres;
        }
        return all;
    }
};

template <class Depth, class Sink>
raster::DrawCounts draw_in_bands(const raster::Surfaces& surfaces,
                                 std::span<const std::uint32_t> order,
                                 const raster::DrawSetup& setup, std::span<const hw::Band> bands,
                                 FrameBuffers<Depth>& frame, const Sink& sink) {
    BandCounts counts;
    frame.executor(bands.size(), [&](std::size_t p, std::size_t worker) {
        raster::DrawSetup own = setup;
        own.band = bands[p];
        Sink copy = sink;
        counts.of[p] = raster::draw(surfaces, order, own, frame.draw[worker], copy);
    });
    return counts.sum(bands.size());
}

template <class Depth>
raster::Census census_of(std::span<const raster::Patch> patches,
                              const raster::DrawSetup& setup, FrameBuffers<Depth>& frame) {
    std::array<raster::Census, max_parts> counted{};
    const std::size_t parts = parts_of(frame.executor, patches.size(), 1);
    frame.executor(parts, [&](std::size_t p, std::size_t worker) {
        const std::size_t from = patches.size() * p / parts, to = patches.size() * (p + 1) / parts;
        counted[p] = raster::take_census(patches.subspan(from, to - from), setup,
                                         frame.draw[worker]);
    });
    for (std::size_t p = 1; p < parts; ++p) counted[0] += counted[p];
    return counted[0];
}

// Two bands a worker, so that who is ready first takes another.
template <class Depth, class Sink>
raster::DrawCounts draw_patches_shared(std::span<const raster::Patch> patches,
                                       std::span<const std::uint32_t> order,
                                       const raster::DrawSetup& setup, FrameBuffers<Depth>& frame,
                                       Sink& sink) {
    const raster::Census census = census_of(patches, setup, frame);
    if (!census.splits_suffice) return raster::draw(patches, order, setup, *frame.draw, sink);
    std::array<hw::Band, max_parts> cut;
    const std::size_t bands = raster::cut_bands(
        census, setup.spec, std::span(cut).first(2 * frame.executor.workers));
    return draw_in_bands(patches, order, setup, std::span(cut).first(bands), frame, sink);
}

// Facets, or patches that are diced to facets: each part into the store of who draws it.
template <class Depth, class Sink>
raster::DrawCounts draw_in_stores(const raster::Surfaces& surfaces, const raster::DrawSetup& setup,
                                  FrameBuffers<Depth>& frame, Sink& sink) {
    const Executor& executor = frame.executor;
    const auto none = static_cast<Depth>(setup.spec.background());
    const hw::FrameStore<Depth> target = sink.target();
    executor(executor.workers - 1, [&](std::size_t p, std::size_t) {
        std::ranges::fill(frame.store_of(p + 1, target).depth, none);
    });
    const std::size_t count = surfaces.count();
    const std::size_t parts = parts_of(executor, count, 8);
    std::array<raster::DrawCounts, max_parts> counts{};
    executor(parts, [&](std::size_t p, std::size_t worker) {
        const auto part = [&](auto all) {
            const std::size_t from = all.size() * p / parts, to = all.size() * (p + 1) / parts;
            return all.subspan(from, to - from);
        };
        raster::Surfaces own(part(surfaces.patches), surfaces.mesh);
        own.mesh.facets = part(surfaces.mesh.facets);
        hw::FrameStore<Depth> store = worker == 0 ? target : frame.store_of(worker, target);
        auto into = sink.into(store);
        counts[p] = raster::draw(own, {}, setup, frame.draw[worker], into);
    });
    for_bands(executor, target.size_px(), [&](hw::Band band, std::size_t) {
        for (std::size_t w = 1; w < executor.workers; ++w)
            raster::merge(frame.store_of(w, target), target, none, band);
    });
    for (std::size_t p = 1; p < parts; ++p) counts[0] += counts[p];
    return counts[0];
}

}  // namespace detail

// `order` is of the patches, or empty.
template <class Depth, BandSink Sink>
raster::DrawCounts draw_shared(const raster::Surfaces& surfaces,
                               std::span<const std::uint32_t> order,
                               const raster::DrawSetup& setup, FrameBuffers<Depth>& frame,
                               Sink& sink) {
    const bool diced = setup.form == raster::PatchForm::diced;
    const raster::Surfaces facets(diced ? surfaces.patches : std::span<const raster::Patch>(),
                                  surfaces.mesh);
    raster::DrawCounts counts;
    if (!diced && !surfaces.patches.empty())
        counts = detail::draw_patches_shared(surfaces.patches, order, setup, frame, sink);
    if (facets.empty()) return counts;
    if constexpr (StoreSink<Sink, Depth>) {
        if (!frame.worker_depth.empty()) {
            counts += detail::draw_in_stores(facets, setup, frame, sink);
            return counts;
        }
    }
    std::array<hw::Band, max_parts> bands;
    const std::size_t parts = frame.executor.workers;
    const int lines = setup.spec.size_px();
    for (std::size_t p = 0; p < parts; ++p)
        bands[p] = {static_cast<int>(p) * lines / static_cast<int>(parts),
                    static_cast<int>(p + 1) * lines / static_cast<int>(parts)};
    counts += detail::draw_in_bands(facets, {}, setup, std::span(bands).first(parts), frame, sink);
    return counts;
}

}  // namespace umbra78::shadow
