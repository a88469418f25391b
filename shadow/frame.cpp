#include "shadow/frame.hpp"

#include "shadow/ap120b_post_process.hpp"
#include "shadow/composite.hpp"
#include "shadow/correct_form.hpp"
#include "shadow/low_pass.hpp"

#include <algorithm>
#include <new>

namespace umbra78::shadow {
namespace {

// Carves aligned pieces off one span; with no memory it only adds up.
class Carver {
public:
    explicit Carver(std::byte* base) : base_(base) {}

    template <class T>
    std::span<T> take(std::size_t count) {
        constexpr std::size_t line = 64;
        used_ = (used_ + line - 1) / line * line;
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
FrameBuffers<Depth> lay_out(Carver& carver, const hw::MachineSpec& spec, std::size_t patches) {
    const std::size_t pixels = std::size_t{1} << (2 * spec.xy_bits);
    FrameBuffers<Depth> f;
    f.observer = {spec.xy_bits, carver.take<Depth>(pixels), carver.take<std::uint8_t>(pixels)};
    f.light = {spec.xy_bits, carver.take<Depth>(pixels), {}};
    f.mask = carver.take<std::uint8_t>(pixels);
    f.edges = carver.take<std::uint8_t>(pixels);
    f.filtered = carver.take<std::uint8_t>(pixels);
    f.picture = carver.take<std::uint8_t>(pixels);
    f.edge_memory = {carver.take<std::uint32_t>(edge_visited_words(spec.xy_bits)),
                     carver.take<std::int16_t>(edge_coverage_words(spec.xy_bits))};
    f.order = carver.take<std::uint32_t>(patches);
    f.nearest = carver.take<std::int64_t>(patches);
    f.draw = carver.take<raster::DrawMemory>(1).data();
    f.rows = carver.take<RowMemory>(1).data();
    return f;
}

raster::DrawSetup draw_setup(const Scene& scene, const Settings& settings,
                             const FrameMatrices& matrices, const hw::MatrixWords& matrix) {
    return {settings.machine,
            matrix,
            matrices.object,
            settings.sampling,
            scene.materials,
            {settings.ambient_q8, raster::toward_light(scene.light, matrices.object),
             raster::toward_viewer(scene.observer, matrices.object)}};
}

// The scene's patches by depth; a frame carved for more of them has room to spare.
template <class Depth>
std::span<const std::uint32_t> front_to_back(const Scene& scene, const raster::View& view,
                                             FrameBuffers<Depth>& frame) {
    const std::size_t n = scene.patches.size();
    fixed::require(n <= frame.order.size(), "frame carved for fewer patches than the scene has");
    const std::span order = frame.order.first(n);
    raster::order_front_to_back(scene.patches, view, order, frame.nearest);
    return order;
}

}  // namespace

template <class Depth>
std::size_t frame_bytes(const hw::MachineSpec& spec, std::size_t patches) {
    Carver carver(nullptr);
    lay_out<Depth>(carver, spec, patches);
    return carver.used();
}

template <class Depth>
FrameBuffers<Depth> carve(std::span<std::byte> memory, const hw::MachineSpec& spec,
                          std::size_t patches) {
    Carver carver(memory.data());
    FrameBuffers<Depth> f = lay_out<Depth>(carver, spec, patches);
    fixed::require(carver.used() <= memory.size(), "frame memory smaller than frame_bytes");
    new (f.draw) raster::DrawMemory;
    new (f.rows) RowMemory;
    return f;
}

FrameStatus load_matrices(const Scene& scene, const Settings& settings, FrameMatrices& out) {
    using enum FrameStatus;
    const hw::MachineSpec& spec = settings.machine;
    if (hw::check(spec) != hw::SpecStatus::ok || !array_can(settings)) return spec_out_of_range;
    out.object = raster::object_words(scene.patches);
    const auto load = [&](const raster::View& view, hw::MatrixWords& words) {
        return raster::load_view(view, spec, out.object, words) == hw::LoadStatus::ok;
    };
    if (!load(scene.observer, out.world_to_observer)) return observer_matrix;
    if (!load(scene.light, out.world_to_light)) return light_matrix;
    if (!bias_in_quanta(settings, bias_units(scene.light, spec), out.bias_quanta_q16))
        return bias_out_of_range;
    const hw::RationalMatrix exact = raster::observer_to_light(scene.observer, scene.light, spec,
                                                               out.bias_quanta_q16);
    if (hw::load_matrix(exact, spec, hw::screen_words(spec), out.observer_to_light) !=
        hw::LoadStatus::ok)
        return shadow_matrix;
    if (settings.arithmetic == Arithmetic::ap120b) out.array = array_matrix(exact, settings);
    return ok;
}

template <class Depth>
void draw_light(const Scene& scene, const Settings& settings, const FrameMatrices& matrices,
                FrameBuffers<Depth>& frame, FrameCounts& counts) {
    frame.light.clear(settings.machine);
    const std::span order = front_to_back(scene, scene.light, frame);
    raster::DepthSink<Depth> sink{frame.light};
    counts.light =
        raster::draw(scene.patches, order,
                     draw_setup(scene, settings, matrices, matrices.world_to_light), *frame.draw,
                     sink);
}

template <class Depth>
void draw_observer(const Scene& scene, const Settings& settings, const FrameMatrices& matrices,
                   FrameBuffers<Depth>& frame, FrameCounts& counts) {
    frame.observer.clear(settings.machine);
    const std::span order = front_to_back(scene, scene.observer, frame);
    const raster::DrawSetup setup =
        draw_setup(scene, settings, matrices, matrices.world_to_observer);
    if (settings.form == Form::post_process) {
        raster::PictureSink<Depth> sink{frame.observer};
        counts.observer = raster::draw(scene.patches, order, setup, *frame.draw, sink);
        return;
    }
    std::fill(frame.mask.begin(), frame.mask.end(), mask_lit);
    const hw::TransformUnit unit(settings.machine, matrices.observer_to_light);
    const LightMap<Depth> map{frame.light, settings.machine, settings.lookup,
                              settings.background};
    CorrectSink<Depth> sink(frame.observer, map, unit, settings, frame.mask);
    counts.observer = raster::draw(scene.patches, order, setup, *frame.draw, sink);
}

template <class Depth>
void cast_shadows(const Settings& settings, const FrameMatrices& matrices,
                  FrameBuffers<Depth>& frame, FrameCounts& counts) {
    if (settings.form == Form::correct) {  // done point by point; the mask is there
        counts.post_process.visible = counts.observer.samples;
        counts.post_process.shadowed = static_cast<std::uint64_t>(
            std::count(frame.mask.begin(), frame.mask.end(), mask_shadow));
        return;
    }
    if (settings.arithmetic == Arithmetic::ap120b) {
        counts.post_process =
            array_post_process(frame.observer, frame.light, matrices.array,
                               matrices.observer_to_light.affine, settings, frame.mask);
        return;
    }
    if constexpr (sizeof(Depth) == sizeof(hw::Depth16)) {
        if (rows_cover(settings, matrices.observer_to_light)) {
            counts.post_process =
                post_process_rows(frame.observer, frame.light, matrices.observer_to_light,
                                  settings, *frame.rows, frame.mask);
            return;
        }
    }
    counts.post_process = post_process(frame.observer, frame.light, matrices.observer_to_light,
                                       settings, frame.mask);
}

template <class Depth>
void filter_and_composite(const Settings& settings, FrameBuffers<Depth>& frame,
                          FrameCounts& counts) {
    const auto none = static_cast<Depth>(settings.machine.background());
    std::copy(frame.mask.begin(), frame.mask.end(), frame.edges.begin());
    counts.chain_steps = 0;
    if (settings.dequantize_passes > 0)
        counts.chain_steps =
            dequantize(frame.mask, frame.observer, none, settings.dequantize_passes,
                       frame.edge_memory, frame.edges);
    std::copy(frame.edges.begin(), frame.edges.end(), frame.filtered.begin());
    for (int pass = 0; pass < settings.low_pass_passes; ++pass) {
        // The picture's plane is free until the composite.
        low_pass<Depth>(frame.filtered, frame.observer, none, frame.picture);
        std::copy(frame.picture.begin(), frame.picture.end(), frame.filtered.begin());
    }
    if (settings.form == Form::correct) {  // the shadow is in the shading already
        std::copy(frame.observer.intensity.begin(), frame.observer.intensity.end(),
                  frame.picture.begin());
        return;
    }
    composite(frame.observer.intensity, frame.filtered, settings.density_q8, frame.picture);
}

template <class Depth>
FrameStatus render(const Scene& scene, const Settings& settings, FrameBuffers<Depth>& frame,
                   FrameMatrices& matrices, FrameCounts& counts) {
    const FrameStatus status = load_matrices(scene, settings, matrices);
    if (status != FrameStatus::ok) return status;
    draw_light(scene, settings, matrices, frame, counts);
    draw_observer(scene, settings, matrices, frame, counts);
    cast_shadows(settings, matrices, frame, counts);
    filter_and_composite(settings, frame, counts);
    return status;
}

#define UMBRA78_FRAME(Depth)                                                                      \
    template std::size_t frame_bytes<Depth>(const hw::MachineSpec&, std::size_t);                 \
    template FrameBuffers<Depth> carve(std::span<std::byte>, const hw::MachineSpec&,              \
                                       std::size_t);                                              \
    template void draw_light(const Scene&, const Settings&, const FrameMatrices&,                 \
                             FrameBuffers<Depth>&, FrameCounts&);                                 \
    template void draw_observer(const Scene&, const Settings&, const FrameMatrices&,              \
                                FrameBuffers<Depth>&, FrameCounts&);                              \
    template void cast_shadows(const Settings&, const FrameMatrices&, FrameBuffers<Depth>&,       \
                               FrameCounts&);                                                     \
    template void filter_and_composite(const Settings&, FrameBuffers<Depth>&, FrameCounts&);      \
    template FrameStatus render(const Scene&, const Settings&, FrameBuffers<Depth>&,              \
                                FrameMatrices&, FrameCounts&);
UMBRA78_FRAME(hw::Depth16)
UMBRA78_FRAME(hw::Depth32)
#undef UMBRA78_FRAME

}  // namespace umbra78::shadow
