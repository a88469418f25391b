// One frame, from patches and two views to a picture with shadows: the whole pipeline in order.
//
//   light's view (Z) -> observer's view (Z, intensity) -> post-process (mask)
//     -> edge dequantizing -> low-pass -> translucent composite
//   or, in the correct form: light's view -> observer's view, tested point by point
//
// The core allocates nothing: the caller hands in one piece of memory of frame_bytes() (under
// 3 MiB for 512 x 512 with 16-bit Z) and finds every stage's buffer in it afterwards. What a plan
// leaves out changes none of them; what it keeps must be there from the frame before. Stages run
// one at a time as well.
#pragma once

#include "shadow/filters/dequantize.hpp"
#include "shadow/frame/inputs.hpp"
#include "shadow/frame/plan.hpp"
#include "shadow/post_process.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace umbra78::shadow {

// Buffers of a frame, size_px^2 words each, carved from the caller's memory.
template <class Depth>
struct FrameBuffers {
    hw::FrameStore<Depth> observer, light;
    std::span<std::uint8_t> mask;      // 255 in shadow, as compared
    std::span<std::uint8_t> edges;     // after dequantizing; = mask where that is off
    std::span<std::uint8_t> filtered;  // after the low-pass; = edges where that is off
    std::span<std::uint8_t> picture;
    EdgeMemory edge_memory;
    std::span<std::uint32_t> order;    // a word a patch
    std::span<std::int64_t> nearest;   // a word a patch
    raster::DrawMemory* draw = nullptr;
    RowMemory* rows = nullptr;
};

template <class Depth>
std::size_t frame_bytes(const hw::MachineSpec& spec, std::size_t patches);

// `memory` has frame_bytes() bytes, aligned to 64.
template <class Depth>
FrameBuffers<Depth> carve(std::span<std::byte> memory, const hw::MachineSpec& spec,
                          std::size_t patches);

struct FrameCounts {
    raster::DrawCounts light, observer;
    PostProcessCounts post_process;  // correct form: visible is every generated point
    std::uint64_t chain_steps = 0;
};

// The stages, each needing those before it.
template <class Depth>
void draw_light(const FrameInputs& in, const FramePlan& plan, FrameBuffers<Depth>& frame,
                FrameCounts& counts);
template <class Depth>
void draw_observer(const FrameInputs& in, const FramePlan& plan, FrameBuffers<Depth>& frame,
                   FrameCounts& counts);
template <class Depth>
void cast_shadows(const FrameInputs& in, const FramePlan& plan, FrameBuffers<Depth>& frame,
                  FrameCounts& counts);
template <class Depth>
void filter_and_composite(const FrameInputs& in, const FramePlan& plan, FrameBuffers<Depth>& frame,
                          FrameCounts& counts);

// All of them.
template <class Depth>
void draw_frame(const FrameInputs& in, const FramePlan& plan, FrameBuffers<Depth>& frame,
                FrameCounts& counts);

// Matrices, plan and all stages, whatever the buffers hold.
template <class Depth>
FrameStatus render(const Scene& scene, const Settings& settings, FrameBuffers<Depth>& frame,
                   FrameMatrices& matrices, FrameCounts& counts);

}  // namespace umbra78::shadow
