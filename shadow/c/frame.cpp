// The frame of umbra78.h: its memory, its drawing, its planes.
#include "fixed/fnv.hpp"
#include "shadow/c/handles.hpp"
#include "shadow/frame/frame.hpp"
#include "shadow/frame/ledger.hpp"

#include <algorithm>
#include <cstdint>
#include <new>
#include <string_view>

namespace {

using namespace umbra78;

raster::View fitted(const umbra78_placed_view& of, const raster::Surfaces& surfaces) {
    raster::View view = of.view;
    if (of.fitted) raster::fit_depth(view, raster::depth_range(view, surfaces));
    return view;
}

// Makes the inputs of a frame from the scene and its settings.
umbra78_status load(umbra78_scene& scene) {
    shadow::FrameInputs& in = scene.inputs;
    if (!scene.observer.given || scene.light_count == 0) return UMBRA78_BAD_VIEW;
    in.settings = scene.settings;
    in.scene = {};
    in.scene.patches = scene.patches.all();
    in.scene.materials = scene.materials.all();
    in.scene.mesh = {scene.vertices.all(), {}, scene.facets.all()};
    in.scene.observer = fitted(scene.observer, in.scene.surfaces());
    in.scene.light_count = scene.light_count;
    for (std::size_t l = 0; l < scene.light_count; ++l)
        in.scene.lights[l] = fitted(scene.lights[l], in.scene.surfaces());
    const shadow::FrameStatus status = shadow::load_matrices(in.scene, in.settings, in.matrices);
    static_assert(UMBRA78_NOT_BUILT - 100 + 1 == static_cast<int>(shadow::FrameStatus::not_built));
    static_assert(UMBRA78_TOO_WIDE_FOR_RIVAL - 100 + 1 ==
                  static_cast<int>(shadow::FrameStatus::too_wide_for_rival));
    if (status == shadow::FrameStatus::ok) return UMBRA78_OK;
    return static_cast<umbra78_status>(UMBRA78_NOT_BUILT - 1 + static_cast<int>(status));
}

// The handle, the ledgers, the method's memory and the planes, in one piece of memory.
struct Pieces {
    std::span<umbra78_frame> handle;
    std::span<shadow::FrameLedger> ledgers;
    std::span<std::byte> method, planes;
    std::size_t bytes;
};

template <class Depth>
Pieces carve_frame(const umbra78_scene& scene, shadow::Carver carver) {
    const shadow::FrameInputs& in = scene.inputs;
    const shadow::Method& method = shadow::method_of(in);
    const std::size_t needed = method.memory == nullptr ? 0 : method.memory(in);
    Pieces p{};
    p.handle = carver.take<umbra78_frame>(1);
    if constexpr (hw::built(hw::Feature::ledger))
        p.ledgers = carver.take<shadow::FrameLedger>(scene.light_count);
    p.method = carver.take<std::byte>(std::max(needed, scene.method_bytes));
    p.planes = carver.take<std::byte>(shadow::frame_bytes<Depth>(
        in.settings.machine, in.scene.patches.size(), shadow::FrameShape(in.scene, in.settings)));
    p.bytes = carver.used();
    return p;
}

// The bytes that a method was short of; 0 if it had enough.
std::size_t short_of(const umbra78_scene& scene, const shadow::FrameCounts& counts) {
    std::size_t needed = 0;
    for (std::size_t l = 0; l < scene.light_count; ++l)
        if (const shadow::Capacity& c = counts.lights[l].capacity; !c.enough)
            needed = std::max(needed, static_cast<std::size_t>(c.needed));
    return needed;
}

template <class Depth>
umbra78_status draw(umbra78_scene& scene, std::span<std::byte> memory,
                    shadow::FrameBuffers<Depth> umbra78_frame::*planes, umbra78_frame** made) {
    if (carve_frame<Depth>(scene, shadow::Carver(nullptr)).bytes > memory.size())
        return UMBRA78_MEMORY_TOO_SMALL;
    const Pieces p = carve_frame<Depth>(scene, shadow::Carver(memory));
    const shadow::FrameInputs& in = scene.inputs;
    umbra78_frame& frame = *new (p.handle.data()) umbra78_frame;
    frame.scene = &scene;
    frame.ledgers = p.ledgers.data();
    shadow::FrameBuffers<Depth>& buffers = frame.*planes;
    buffers = shadow::carve<Depth>(p.planes, in.settings.machine, in.scene.patches.size(),
                                   shadow::FrameShape(in.scene, in.settings));
    buffers.method_memory = p.method;
    frame.plan = shadow::make_plan(in, nullptr);
    shadow::draw_frame(in, frame.plan, buffers, frame.counts);
    if (const std::size_t needed = short_of(scene, frame.counts); needed > 0) {
        scene.method_bytes = needed;
        return UMBRA78_MEMORY_TOO_SMALL;
    }
    *made = &frame;
    return UMBRA78_OK;
}

template <class Depth>
std::size_t bytes_of(const umbra78_scene& scene) {
    return carve_frame<Depth>(scene, shadow::Carver(nullptr)).bytes;
}

template <class Word>
umbra78_plane plane_of(std::span<Word> words, int size_px) {
    return {words.empty() ? nullptr : words.data(), 8 * static_cast<int>(sizeof(Word)), size_px};
}

template <class Depth>
umbra78_plane find(const shadow::FrameBuffers<Depth>& frame, std::string_view name,
                   std::size_t light, int size_px) {
    const shadow::LightBuffers<Depth>& of = frame.lights[light];
    if (name == "observer_z") return plane_of(frame.observer.depth, size_px);
    if (name == "light_z") return plane_of(of.map.depth, size_px);
    if (name == "intensity") return plane_of(frame.observer.intensity, size_px);
    if (name == "mask") return plane_of(of.mask, size_px);
    if (name == "edges") return plane_of(of.edges, size_px);
    if (name == "filtered") return plane_of(of.filtered, size_px);
    if (name == "picture") return plane_of(frame.picture, size_px);
    return {nullptr, 0, 0};
}

// A ledger for each light, the first of which has the observer's part.
template <class Depth>
std::uint64_t count(const umbra78_frame& frame, const shadow::FrameBuffers<Depth>& planes) {
    const shadow::FrameInputs& in = frame.scene->inputs;
    shadow::FrameLedger* const all = frame.ledgers;
    for (std::size_t l = 0; l < in.scene.light_count; ++l)
        new (all + l) shadow::FrameLedger(shadow::frame_ledger(
            in, planes, frame.counts, l, {.observer = l == 0 ? nullptr : all}));
    return shadow::total({all, in.scene.light_count}, true);
}

}  // namespace

extern "C" {

umbra78_status umbra78_frame_bytes(umbra78_scene* scene, size_t* bytes) {
    if (scene == nullptr || bytes == nullptr) return UMBRA78_NULL_ARGUMENT;
    *bytes = 0;
    const umbra78_status status = load(*scene);
    if (status != UMBRA78_OK) return status;
    *bytes = scene->settings.machine.z_bits > 16 ? bytes_of<hw::Depth32>(*scene)
                                                 : bytes_of<hw::Depth16>(*scene);
    return UMBRA78_OK;
}

umbra78_status umbra78_render(umbra78_scene* scene, void* memory, size_t bytes,
                              umbra78_frame** frame) {
    if (scene == nullptr || memory == nullptr || frame == nullptr) return UMBRA78_NULL_ARGUMENT;
    *frame = nullptr;
    if (reinterpret_cast<std::uintptr_t>(memory) % UMBRA78_ALIGNMENT != 0)
        return UMBRA78_NOT_ALIGNED;
    const umbra78_status status = load(*scene);
    if (status != UMBRA78_OK) return status;
    const std::span room(static_cast<std::byte*>(memory), bytes);
    if (scene->settings.machine.z_bits > 16)
        return draw(*scene, room, &umbra78_frame::wide, frame);
    return draw(*scene, room, &umbra78_frame::narrow, frame);
}

umbra78_status umbra78_buffer(const umbra78_frame* frame, const char* name, size_t light,
                              umbra78_plane* plane) {
    if (frame == nullptr || name == nullptr || plane == nullptr) return UMBRA78_NULL_ARGUMENT;
    *plane = {nullptr, 0, 0};
    const shadow::FrameInputs& in = frame->scene->inputs;
    if (light >= in.scene.light_count) return UMBRA78_NO_SUCH_PART;
    const int size_px = in.settings.machine.size_px();
    const umbra78_plane found = frame->is_wide() ? find(frame->wide, name, light, size_px)
                                                 : find(frame->narrow, name, light, size_px);
    if (found.words == nullptr) return UMBRA78_NO_SUCH_BUFFER;
    *plane = found;
    return UMBRA78_OK;
}

uint64_t umbra78_hash(const umbra78_plane* plane) {
    fixed::Fnv1a64 hash;
    if (plane == nullptr || plane->words == nullptr) return hash.value();
    const std::size_t pixels =
        static_cast<std::size_t>(plane->size_px) * static_cast<std::size_t>(plane->size_px);
    for (std::size_t at = 0; at < pixels; ++at) {
        if (plane->bits == 8) hash.byte(static_cast<const std::uint8_t*>(plane->words)[at]);
        if (plane->bits == 16) hash.u16be(static_cast<const std::uint16_t*>(plane->words)[at]);
        if (plane->bits == 32) hash.u32be(static_cast<const std::uint32_t*>(plane->words)[at]);
    }
    return hash.value();
}

umbra78_status umbra78_cycles(const umbra78_frame* frame, uint64_t* cycles) {
    if (frame == nullptr || cycles == nullptr) return UMBRA78_NULL_ARGUMENT;
    *cycles = 0;
    if constexpr (!hw::built(hw::Feature::ledger)) {
        return UMBRA78_NOT_BUILT;
    } else {
        *cycles = frame->is_wide() ? count(*frame, frame->wide) : count(*frame, frame->narrow);
        return UMBRA78_OK;
    }
}

}  // extern "C"
