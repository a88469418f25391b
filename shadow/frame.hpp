// One frame, from patches and two views to a picture with shadows: the whole pipeline in order.
//
//   light's view (Z) -> observer's view (Z, intensity) -> post-process (mask)
//     -> edge dequantizing -> low-pass -> translucent composite
//   or, in the correct form: light's view -> observer's view, tested point by point
//
// The core allocates nothing: the caller hands in one piece of memory of frame_bytes() (under
// 3 MiB for 512 x 512 with 16-bit Z) and finds every stage's buffer in it afterwards. Stages run
// one at a time as well, so that what stands still between frames need not be drawn again.
#pragma once

#include "hw/ap120b_transform.hpp"
#include "raster/draw.hpp"
#include "shadow/bias.hpp"
#include "shadow/dequantize.hpp"
#include "shadow/post_process.hpp"
#include "shadow/settings.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace umbra78::shadow {

struct Scene {
    std::span<const raster::Patch> patches;
    std::span<const raster::Material> materials;
    raster::View observer, light;  // a perspective "view" is a point light at its eye
};

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

enum class FrameStatus : std::uint8_t {
    ok,
    spec_out_of_range,      // a width outside its range (hw::check), or the AP-120B's
    observer_matrix,        // a coefficient of world -> observer outside the exponent's range
    light_matrix,
    shadow_matrix,
    bias_out_of_range,
};

// The matrices of a frame, rounded to the unit's words.
struct FrameMatrices {
    hw::WordFormat object;
    hw::MatrixWords world_to_observer, world_to_light, observer_to_light;
    std::int64_t bias_quanta_q16;
    hw::ap120b::Matrix array;  // observer to light again, where that is the arithmetic
};
FrameStatus load_matrices(const Scene& scene, const Settings& settings, FrameMatrices& out);

struct FrameCounts {
    raster::DrawCounts light, observer;
    PostProcessCounts post_process;  // correct form: visible is every generated point
    std::uint64_t chain_steps = 0;
};

// The stages, each needing those before it.
template <class Depth>
void draw_light(const Scene& scene, const Settings& settings, const FrameMatrices& matrices,
                FrameBuffers<Depth>& frame, FrameCounts& counts);
template <class Depth>
void draw_observer(const Scene& scene, const Settings& settings, const FrameMatrices& matrices,
                   FrameBuffers<Depth>& frame, FrameCounts& counts);
template <class Depth>
void cast_shadows(const Settings& settings, const FrameMatrices& matrices,
                  FrameBuffers<Depth>& frame, FrameCounts& counts);
template <class Depth>
void filter_and_composite(const Settings& settings, FrameBuffers<Depth>& frame,
                          FrameCounts& counts);

// All of them.
template <class Depth>
FrameStatus render(const Scene& scene, const Settings& settings, FrameBuffers<Depth>& frame,
                   FrameMatrices& matrices, FrameCounts& counts);

}  // namespace umbra78::shadow
