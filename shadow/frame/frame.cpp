#include "shadow/frame/frame.hpp"

#include "shadow/ap120b/post_process.hpp"
#include "shadow/correct_form.hpp"
#include "shadow/filters/composite.hpp"
#include "shadow/filters/low_pass.hpp"

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

raster::DrawSetup draw_setup(const FrameInputs& in, const FramePlan& plan,
                             const hw::MatrixWords& matrix) {
    const hw::WordFormat object = in.matrices.object;
    return {in.settings.machine,
            matrix,
            object,
            in.settings.sampling,
            in.scene.materials,
            {in.settings.ambient_q8, raster::toward_eye(in.scene.light, object),
             raster::toward_eye(in.scene.observer, object)},
            plan.unit_work()};
}

// Bytes that no stage leaves anything in: where work is done for nothing.
template <class Depth>
std::span<std::uint8_t> scratch(FrameBuffers<Depth>& frame) {
    const std::span coverage = frame.edge_memory.coverage;
    return {reinterpret_cast<std::uint8_t*>(coverage.data()), frame.mask.size()};
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

// Draws into what the store holds, each sample replacing or not.
template <class Depth, class Sink>
raster::DrawCounts draw_view(const FrameInputs& in, const FramePlan& plan, const raster::View& view,
                             const hw::MatrixWords& matrix, FrameBuffers<Depth>& frame,
                             Sink& sink) {
    const std::span order = front_to_back(in.scene, view, frame);
    return raster::draw(in.scene.patches, order, draw_setup(in, plan, matrix), *frame.draw, sink);
}

// Where Z stands still it is drawn upon once more for the intensities: only what lies at the
// stored depth competes, from the greatest level down, and comes out as it would have.
template <class Depth>
void clear_intensities(const hw::MachineSpec& spec, hw::FrameStore<Depth>& store) {
    for (std::size_t k = 0; k < store.depth.size(); ++k)
        store.intensity[k] = store.depth[k] == spec.background() ? 0 : 255;
}

PostProcessWork work_of(const FramePlan& plan) {
    return {plan.unit_work(), !plan.leaves_out(Omission::background_pixels),
            !plan.leaves_out(Omission::noise)};
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

template <class Depth>
void draw_light(const FrameInputs& in, const FramePlan& plan, FrameBuffers<Depth>& frame,
                FrameCounts& counts) {
    if (plan.leaves_out(Omission::same_light_map)) return;
    counts.light = {};
    frame.light.clear(in.settings.machine);
    if (plan.leaves_out(Omission::light_map)) return;
    const auto into = [&](auto sink) {
        counts.light =
            draw_view(in, plan, in.scene.light, in.matrices.world_to_light, frame, sink);
    };
    if (plan.leaves_out(Omission::light_shading)) {
        into(raster::DepthSink<Depth>{frame.light});
        return;
    }
    hw::FrameStore<Depth> shaded = frame.light;
    shaded.intensity = scratch(frame);
    into(raster::PictureSink<Depth>{shaded});
}

template <class Depth>
void draw_observer(const FrameInputs& in, const FramePlan& plan, FrameBuffers<Depth>& frame,
                   FrameCounts& counts) {
    if (plan.leaves_out(Omission::same_observer)) return;
    const Settings& settings = in.settings;
    const auto into = [&](auto sink) {
        counts.observer =
            draw_view(in, plan, in.scene.observer, in.matrices.world_to_observer, frame, sink);
    };
    const bool correct = settings.form == Form::correct;
    if (correct) std::fill(frame.mask.begin(), frame.mask.end(), mask_lit);
    if (!correct || plan.leaves_out(Omission::post_process)) {
        if (plan.leaves_out(Omission::same_depth)) {
            clear_intensities(settings.machine, frame.observer);
        } else {
            frame.observer.clear(settings.machine);
        }
        into(raster::PictureSink<Depth>{frame.observer});
        return;
    }
    frame.observer.clear(settings.machine);
    const hw::TransformUnit unit(settings.machine, in.matrices.observer_to_light,
                                 plan.unit_work());
    const LightMap<Depth> map{frame.light, settings.machine, settings.lookup,
                              settings.background};
    into(CorrectSink<Depth>(frame.observer, map, unit, settings, frame.mask,
                            work_of(plan).noise));
}

template <class Depth>
void cast_shadows(const FrameInputs& in, const FramePlan& plan, FrameBuffers<Depth>& frame,
                  FrameCounts& counts) {
    if (plan.leaves_out(Omission::same_mask)) return;
    if (plan.leaves_out(Omission::post_process)) {
        counts.post_process = {};
        std::fill(frame.mask.begin(), frame.mask.end(), mask_lit);
        return;
    }
    if (in.settings.form == Form::correct) {  // done point by point; the mask is there
        counts.post_process.visible = counts.observer.samples;
        counts.post_process.shadowed = static_cast<std::uint64_t>(
            std::count(frame.mask.begin(), frame.mask.end(), mask_shadow));
        return;
    }
    const hw::MatrixWords& matrix = in.matrices.observer_to_light;
    if (in.settings.arithmetic == Arithmetic::ap120b) {
        counts.post_process = array_post_process(frame.observer, frame.light, in.matrices.array,
                                                 matrix.affine, in.settings, frame.mask);
        return;
    }
    if constexpr (sizeof(Depth) == sizeof(hw::Depth16)) {
        if (work_of(plan) == needed_work(in.settings) && rows_cover(in.settings, matrix)) {
            counts.post_process = post_process_rows(frame.observer, frame.light, matrix,
                                                    in.settings, *frame.rows, frame.mask);
            return;
        }
    }
    counts.post_process = post_process(frame.observer, frame.light, matrix, in.settings,
                                       work_of(plan), frame.mask);
}

template <class Depth>
void filter_and_composite(const FrameInputs& in, const FramePlan& plan, FrameBuffers<Depth>& frame,
                          FrameCounts& counts) {
    if (plan.leaves_out(Omission::same_picture)) return;
    const Settings& settings = in.settings;
    const auto none = static_cast<Depth>(settings.machine.background());
    const auto copy = [](std::span<const std::uint8_t> from, std::span<std::uint8_t> to) {
        std::copy(from.begin(), from.end(), to.begin());
    };
    copy(frame.mask, frame.edges);
    counts.chain_steps = 0;
    if (!plan.leaves_out(Omission::dequantize))
        counts.chain_steps = dequantize<Depth>(frame.mask, frame.observer, none,
                                               settings.dequantize_passes, frame.edge_memory,
                                               frame.edges);
    copy(frame.edges, frame.filtered);
    if (!plan.leaves_out(Omission::low_pass)) {
        for (int pass = 0; pass < settings.low_pass_passes; ++pass) {
            // The picture's plane is free until the composite.
            low_pass<Depth>(frame.filtered, frame.observer, none, frame.picture);
            copy(frame.picture, frame.filtered);
        }
        if (settings.low_pass_passes == 0)  // a pass whose result nobody takes
            low_pass<Depth>(frame.filtered, frame.observer, none, scratch(frame));
    }
    if (plan.leaves_out(Omission::composite)) {
        copy(frame.observer.intensity, frame.picture);
        return;
    }
    // In the correct form the shadow is in the shading already: nothing more is darkened.
    const int density = settings.form == Form::correct ? 0 : settings.density_q8;
    composite(frame.observer.intensity, frame.filtered, density, frame.picture);
}

template <class Depth>
void draw_frame(const FrameInputs& in, const FramePlan& plan, FrameBuffers<Depth>& frame,
                FrameCounts& counts) {
    draw_light(in, plan, frame, counts);
    draw_observer(in, plan, frame, counts);
    cast_shadows(in, plan, frame, counts);
    filter_and_composite(in, plan, frame, counts);
}

template <class Depth>
FrameStatus render(const Scene& scene, const Settings& settings, FrameBuffers<Depth>& frame,
                   FrameMatrices& matrices, FrameCounts& counts) {
    const FrameStatus status = load_matrices(scene, settings, matrices);
    if (status != FrameStatus::ok) return status;
    const FrameInputs in{scene, settings, matrices};
    draw_frame(in, make_plan(in), frame, counts);
    return status;
}

#define UMBRA78_STAGE(Depth, stage) \
    template void stage(const FrameInputs&, const FramePlan&, FrameBuffers<Depth>&, FrameCounts&);
#define UMBRA78_FRAME(Depth)                                                                      \
    template std::size_t frame_bytes<Depth>(const hw::MachineSpec&, std::size_t);                 \
    template FrameBuffers<Depth> carve(std::span<std::byte>, const hw::MachineSpec&,              \
                                       std::size_t);                                              \
    UMBRA78_STAGE(Depth, draw_light)                                                              \
    UMBRA78_STAGE(Depth, draw_observer)                                                           \
    UMBRA78_STAGE(Depth, cast_shadows)                                                            \
    UMBRA78_STAGE(Depth, filter_and_composite)                                                    \
    UMBRA78_STAGE(Depth, draw_frame)                                                              \
    template FrameStatus render(const Scene&, const Settings&, FrameBuffers<Depth>&,              \
                                FrameMatrices&, FrameCounts&);
UMBRA78_FRAME(hw::Depth16)
UMBRA78_FRAME(hw::Depth32)
#undef UMBRA78_FRAME
#undef UMBRA78_STAGE

}  // namespace umbra78::shadow
