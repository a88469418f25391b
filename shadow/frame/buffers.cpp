#include "shadow/frame/buffers.hpp"

#include <new>

namespace umbra78::shadow {
namespace {

template <class Depth>
FrameBuffers<Depth> lay_out(Carver& carver, const hw::MachineSpec& spec, std::size_t patches,
                            const FrameShape& shape) {
    const std::size_t pixels = std::size_t{1} << (2 * spec.xy_bits);
    const auto planes = [&](std::size_t n) { return carver.take<std::uint8_t>(n * pixels); };
    FrameBuffers<Depth> f;
    f.observer = {spec.xy_bits, carver.take<Depth>(pixels), {}, {}};
    f.observer.intensity = planes(shape.channels);
    f.observer.direct = planes(shape.channels * shape.sources);
    f.observer.normal = carver.take<hw::NormalWord>(shape.normals ? 3 * pixels : 0);
    std::size_t next = 0;
    for (std::size_t s = 0; s < shape.sources; ++s) {
        const std::span of_source = std::span(f.lights).subspan(next, shape.lights_of[s]);
        next += of_source.size();
        for (LightBuffers<Depth>& light : of_source) {
            light.map = {spec.xy_bits, carver.take<Depth>(shape.map_layers > 0 ? pixels : 0)};
            light.second = {spec.xy_bits, carver.take<Depth>(shape.map_layers > 1 ? pixels : 0)};
            const bool has_mask = !shape.sectored[s] || &light == &of_source.front();
            light.mask = has_mask ? planes(1) : of_source.front().mask;
        }
        LightBuffers<Depth>& first = of_source.front();
        first.joined = shape.graded[s] ? planes(1) : first.mask;
        first.edges = planes(1);
        first.filtered = planes(1);
    }
    f.picture = planes(shape.channels);
    f.edge_memory = {carver.take<std::uint32_t>(edge_visited_words(spec.xy_bits)),
                     carver.take<std::int16_t>(edge_coverage_words(spec.xy_bits))};
    f.order = carver.take<std::uint32_t>(patches);
    f.nearest = carver.take<std::int64_t>(patches);
    const std::size_t workers = shape.workers, stores = shape.worker_stores ? workers - 1 : 0;
    f.workers = workers;
    f.draw = carver.take<raster::DrawMemory>(workers).data();
    f.rows = carver.take<RowMemory>(hw::built(hw::Feature::rows) ? workers : 0).data();
    f.worker_depth = carver.take<Depth>(stores * pixels);
    f.worker_levels = planes(stores * shape.channels * (1 + shape.sources));
    f.worker_normals = carver.take<hw::NormalWord>(shape.normals ? stores * 3 * pixels : 0);
    return f;
}

}  // namespace

FrameShape::FrameShape(const Scene& scene, int layers)
    : lights(scene.light_count), sources(scene.sources_used()), channels(scene.channels),
      map_layers(layers) {
    fixed::require(scene.in_order(), "frame carved for too many lights");
    for (std::size_t s = 0; s < sources; ++s) {
        lights_of[s] = static_cast<std::uint8_t>(scene.source(s).lights);
        sectored[s] = scene.source(s).sectored;
        graded[s] = scene.source(s).is_graded();
    }
}

FrameShape::FrameShape(const Scene& scene, const Settings& settings)
    : FrameShape(scene, shadow::map_layers(settings)) {
    normals = reads_normals(settings);
    worker_stores = !scene.mesh.facets.empty() || settings.surface == raster::PatchForm::diced;
}

template <class Depth>
std::size_t frame_bytes(const hw::MachineSpec& spec, std::size_t patches,
                        const FrameShape& shape) {
    Carver carver(static_cast<std::byte*>(nullptr));
    lay_out<Depth>(carver, spec, patches, shape);
    return carver.used();
}

template <class Depth>
FrameBuffers<Depth> carve(std::span<std::byte> memory, const hw::MachineSpec& spec,
                          std::size_t patches, const FrameShape& shape) {
    fixed::require(hw::check(spec) == hw::SpecStatus::ok, "frame carved for widths out of range");
    fixed::require(shape.workers >= 1 && shape.workers <= max_workers,
                   "frame carved for no worker, or for too many");
    fixed::require(reinterpret_cast<std::uintptr_t>(memory.data()) % frame_alignment == 0,
                   "frame memory not aligned to 64 bytes");
    fixed::require(frame_bytes<Depth>(spec, patches, shape) <= memory.size(),
                   "frame memory smaller than frame_bytes");
    Carver carver(memory.data());
    FrameBuffers<Depth> f = lay_out<Depth>(carver, spec, patches, shape);
    for (std::size_t w = 0; w < shape.workers; ++w) {
        new (f.draw + w) raster::DrawMemory;
        if (hw::built(hw::Feature::rows)) new (f.rows + w) RowMemory;
    }
    return f;
}

#define UMBRA78_BUFFERS(Depth)                                                               \
    template std::size_t frame_bytes<Depth>(const hw::MachineSpec&, std::size_t,             \
                                            const FrameShape&);                              \
    template FrameBuffers<Depth> carve(std::span<std::byte>, const hw::MachineSpec&,         \
                                       std::size_t, const FrameShape&);
UMBRA78_BUFFERS(hw::Depth16)
UMBRA78_BUFFERS(hw::Depth32)
#undef UMBRA78_BUFFERS

}  // namespace umbra78::shadow
