#include "shadow/frame/buffers.hpp"

#include <new>

namespace umbra78::shadow {
namespace {

// Carves aligned pieces off one span; with no memory it only adds up.
class Carver {
public:
    explicit Carver(std::byte* base) : base_(base) {}

    template <class T>
    std::span<T> take(std::size_t count) {
        static_assert(alignof(T) <= frame_alignment);
        used_ = (used_ + frame_alignment - 1) / frame_alignment * frame_alignment;
        T* at = base_ == nullptr ? nullptr : reinterpret_cast<T*>(base_ + used_);
        used_ += count * sizeof(T);
        return {at, at == nullptr ? 0 : count};
    }
    std::size_t used() const { return used_; }

private:
    std::byte* base_;
    std::size_t used_ = 0;
};

template <class Depth>
FrameBuffers<Depth> lay_out(Carver& carver, const hw::MachineSpec& spec, std::size_t patches,
                            std::size_t lights, int map_layers) {
    const std::size_t pixels = std::size_t{1} << (2 * spec.xy_bits);
    FrameBuffers<Depth> f;
    f.observer = {spec.xy_bits, carver.take<Depth>(pixels), carver.take<std::uint8_t>(pixels),
                  carver.take<std::uint8_t>(pixels)};
    for (LightBuffers<Depth>& light : std::span(f.lights).first(lights)) {
        light.map = {spec.xy_bits, carver.take<Depth>(pixels)};
        light.second = {spec.xy_bits, carver.take<Depth>(map_layers > 1 ? pixels : 0)};
        light.mask = carver.take<std::uint8_t>(pixels);
        light.edges = carver.take<std::uint8_t>(pixels);
        light.filtered = carver.take<std::uint8_t>(pixels);
    }
    f.picture = carver.take<std::uint8_t>(pixels);
    f.edge_memory = {carver.take<std::uint32_t>(edge_visited_words(spec.xy_bits)),
                     carver.take<std::int16_t>(edge_coverage_words(spec.xy_bits))};
    f.order = carver.take<std::uint32_t>(patches);
    f.nearest = carver.take<std::int64_t>(patches);
    f.draw = carver.take<raster::DrawMemory>(1).data();
    f.rows = carver.take<RowMemory>(hw::built(hw::Feature::rows) ? 1 : 0).data();
    return f;
}

}  // namespace

template <class Depth>
std::size_t frame_bytes(const hw::MachineSpec& spec, std::size_t patches, std::size_t lights,
                        int map_layers) {
    Carver carver(nullptr);
    lay_out<Depth>(carver, spec, patches, lights, map_layers);
    return carver.used();
}

template <class Depth>
FrameBuffers<Depth> carve(std::span<std::byte> memory, const hw::MachineSpec& spec,
                          std::size_t patches, std::size_t lights, int map_layers) {
    fixed::require(hw::check(spec) == hw::SpecStatus::ok, "frame carved for widths out of range");
    fixed::require(lights <= max_lights, "frame carved for more than max_lights lights");
    fixed::require(reinterpret_cast<std::uintptr_t>(memory.data()) % frame_alignment == 0,
                   "frame memory not aligned to 64 bytes");
    fixed::require(frame_bytes<Depth>(spec, patches, lights, map_layers) <= memory.size(),
                   "frame memory smaller than frame_bytes");
    Carver carver(memory.data());
    FrameBuffers<Depth> f = lay_out<Depth>(carver, spec, patches, lights, map_layers);
    new (f.draw) raster::DrawMemory;
    if (hw::built(hw::Feature::rows)) new (f.rows) RowMemory;
    return f;
}

#define UMBRA78_BUFFERS(Depth)                                                               \
    template std::size_t frame_bytes<Depth>(const hw::MachineSpec&, std::size_t, std::size_t, \
                                            int);                                            \
    template FrameBuffers<Depth> carve(std::span<std::byte>, const hw::MachineSpec&,         \
                                       std::size_t, std::size_t, int);
UMBRA78_BUFFERS(hw::Depth16)
UMBRA78_BUFFERS(hw::Depth32)
#undef UMBRA78_BUFFERS

}  // namespace umbra78::shadow
