// A frame's buffers, carved from one piece of the caller's memory, and what a frame counts.
//
// Every plane has size_px^2 words, row by row from the top. A frame of 512 x 512 pixels with
// 16-bit Z, one light and the 128 patches of the figures takes 3 380 736 bytes; each further light
// of its own 1 572 864 more (a map, a mask, two filtered masks, a direct share), and so do normals.
#pragma once

#include "hw/frame_store.hpp"
#include "hw/operations.hpp"
#include "raster/draw.hpp"
#include "raster/visible_list.hpp"
#include "shadow/carver.hpp"
#include "shadow/executor.hpp"
#include "shadow/filters/dequantize.hpp"
#include "shadow/frame/inputs.hpp"
#include "shadow/post_process.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace umbra78::shadow {

// The planes that each light has. Darkness is 0 (lit) to 255 (in shadow).
template <class Depth>
struct LightBuffers {
    hw::FrameStore<Depth> map;      // the light's depth map; it has no intensity. Empty if carved
                                    // for a form without one
    hw::FrameStore<Depth> second;   // the second Z while it is drawn; empty if carved for one
    std::span<std::uint8_t> mask;   // the darkness, as the method wrote it; one for all sectors
    // Of a source's first light alone:
    std::span<std::uint8_t> joined;    // the source's darkness; = mask where that is all of it
    std::span<std::uint8_t> edges;     // after dequantizing; = joined where that is off
    std::span<std::uint8_t> filtered;  // after the low-pass; = edges where that is off
};

template <class Depth>
struct FrameBuffers {
    hw::FrameStore<Depth> observer;
    std::array<LightBuffers<Depth>, max_lights> lights;
    std::span<std::uint8_t> picture;  // a plane a channel
    EdgeMemory edge_memory;
    std::span<std::uint32_t> order;      // a word a patch
    std::span<std::int64_t> nearest;     // a word a patch
    raster::DrawMemory* draw = nullptr;  // one a worker
    RowMemory* rows = nullptr;           // one a worker
    // Stores of the workers but the first, for facets: Z, the bytes of intensities and direct
    // shares, normals. Empty unless the shape has them.
    std::span<Depth> worker_depth;
    std::span<std::uint8_t> worker_levels;
    std::span<hw::NormalWord> worker_normals;
    // The caller's threads, which he hands in after carving for as many workers or more.
    Executor executor{};
    std::size_t workers = 1;  // carved for
    // The caller's, where the lights may change from frame to frame and the observer's Z does not.
    raster::VisibleList* visible = nullptr;
    std::span<std::byte> method_memory;  // the caller's, for a method whose row says may_run_out

    std::size_t pixels() const { return observer.depth.size(); }
    // A channel's plane, and in it a source's.
    std::span<std::uint8_t> intensity(std::size_t channel) const {
        return observer.intensity.subspan(channel * pixels(), pixels());
    }
    std::span<std::uint8_t> direct(std::size_t channel, std::size_t source) const {
        const std::size_t sources = observer.direct.size() / observer.intensity.size();
        return observer.direct.subspan((channel * sources + source) * pixels(), pixels());
    }
    std::span<std::uint8_t> picture_of(std::size_t channel) const {
        return picture.subspan(channel * pixels(), pixels());
    }

    // The store of a worker but the first, with the planes that `like` has.
    hw::FrameStore<Depth> store_of(std::size_t worker, const hw::FrameStore<Depth>& like) const {
        const auto planes = [&](auto all, std::size_t of_each, std::size_t used) {
            return all.subspan((worker - 1) * of_each, used);
        };
        const std::size_t levels = observer.intensity.size() + observer.direct.size();
        const std::size_t grey = like.intensity.size();
        return {like.xy_bits, planes(worker_depth, pixels(), pixels()),
                planes(worker_levels, levels, grey),
                planes(worker_levels, levels, grey + like.direct.size()).subspan(grey),
                planes(worker_normals, observer.normal.size(), like.normal.size())};
    }

    // What a pass over the frame reads for light l.
    DepthMaps<Depth> maps(std::size_t l = 0) const {
        return {.observer = observer, .light = lights[l].map};
    }
};

// How many planes of each kind a scene needs: by default those of one light, in grey.
struct FrameShape {
    std::size_t lights = 1, sources = 1, channels = 1;
    std::array<std::uint8_t, max_sources> lights_of{1};
    std::array<bool, max_sources> sectored{}, graded{};
    bool normals = false;  // kept of the observer's view: reads_normals(settings)
    int map_layers = 1;  // Z codes a texel while a map is drawn: shadow::map_layers(settings);
                         // 0: no map
    std::size_t workers = 1;     // 1 to max_workers: the most that FrameBuffers::executor may have
    bool worker_stores = false;  // one for each worker but the first: where there are facets

    FrameShape() = default;
    explicit FrameShape(int layers) : map_layers(layers) {}
    explicit FrameShape(const Scene& scene, int layers = 1);
    FrameShape(const Scene& scene, const Settings& settings);
    constexpr bool operator==(const FrameShape&) const = default;
};

template <class Depth>
std::size_t frame_bytes(const hw::MachineSpec& spec, std::size_t patches,
                        const FrameShape& shape = {});

// `memory` has at least frame_bytes() bytes, aligned to frame_alignment. Traps otherwise, and for
// widths out of range.
template <class Depth>
FrameBuffers<Depth> carve(std::span<std::byte> memory, const hw::MachineSpec& spec,
                          std::size_t patches, const FrameShape& shape = {});

// Whether a method had room for what it keeps, and how many bytes it needs.
struct Capacity {
    bool enough = true;
    std::uint64_t needed = 0;
};

// Scan lines that the filters and the composite went through; the low-pass's of all its passes.
struct FilteredLines {
    std::uint64_t dequantize = 0, low_pass = 0, composite = 0;
    constexpr bool operator==(const FilteredLines&) const = default;
};

struct LightCounts {
    raster::DrawCounts map;
    PostProcessCounts post_process;  // correct form: visible is every generated point
    std::uint64_t chain_steps = 0;   // that dequantizing followed
    FilteredLines filtered_lines;
    Capacity capacity;
    hw::Operations method_once, method_frame;  // of a rival: for a scene and light; for each frame
    std::uint64_t method_entries = 0;          // that a rival adds to the scene (rivals/costs.hpp)
};

struct FrameCounts {
    std::array<LightCounts, max_lights> lights;
    raster::DrawCounts observer;
};

}  // namespace umbra78::shadow
