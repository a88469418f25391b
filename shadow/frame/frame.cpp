#include "shadow/frame/frame.hpp"

#include "raster/sinks.hpp"
#include "shadow/filters/low_pass.hpp"
#include "shadow/filters/ramp.hpp"
#include "shadow/frame/composite_stage.hpp"
#include "shadow/frame/drawing.hpp"
#include "shadow/lines.hpp"

#include <algorithm>
#include <array>

namespace umbra78::shadow {
namespace {

// Memory that holds no result: two planes, for work whose result nobody reads.
template <class Depth>
std::span<std::uint8_t> scratch(FrameBuffers<Depth>& frame, std::size_t plane = 0) {
    const std::span coverage = std::as_writable_bytes(frame.edge_memory.coverage);
    const std::span bytes(reinterpret_cast<std::uint8_t*>(coverage.data()), coverage.size());
    return bytes.subspan(plane * frame.pixels(), frame.pixels());
}

// Where Z is kept and intensities and normals are drawn anew: they start from the max, and only
// samples at the stored depth compete, so that each comes out as in a frame drawn anew.
template <class Depth>
void clear_intensities(const hw::MachineSpec& spec, hw::FrameStore<Depth>& store) {
    const std::size_t pixels = store.depth.size();
    const auto background = static_cast<Depth>(spec.background());
    const auto start = [&](auto planes, auto nothing, auto greatest) {
        for (std::size_t p = 0; p < planes.size(); p += pixels)
            for (std::size_t k = 0; k < pixels; ++k)
                planes[p + k] = store.depth[k] == background ? nothing : greatest;
    };
    start(store.intensity, std::uint8_t{0}, std::uint8_t{255});
    start(store.direct, std::uint8_t{0}, std::uint8_t{255});
    start(store.normal, hw::no_normal, hw::NormalWord{0xffff});
}

void light_up(std::span<std::uint8_t> mask) { std::fill(mask.begin(), mask.end(), mask_lit); }

void require_held(const FrameInputs& in) {
    fixed::require(!in.scene.streamed, "a stream is drawn by draw_stream() alone");
}

template <class Depth>
void draw_map(const FrameInputs& in, const FramePlan& plan, std::size_t l,
              FrameBuffers<Depth>& frame, FrameCounts& counts) {
    if (plan.leaves_out(Omission::same_light_map, l) || !method_of(in).has_map()) return;
    if (plan.leaves_out(Omission::light_drawing, l)) {  // draw_observer copies it
        counts.lights[l].map = {};
        return;
    }
    hw::FrameStore<Depth>& map = frame.lights[l].map;
    counts.lights[l].map = {};
    clear_map(in, frame.lights[l], frame.executor);
    if (plan.leaves_out(Omission::light_map, l)) return;
    const auto into = [&](auto sink) {
        counts.lights[l].map = draw_map_view(in, plan, l, frame, sink);
        finish_map(in, frame.lights[l]);
    };
    if (plan.leaves_out(Omission::light_shading, l)) {
        into(raster::DepthSink<Depth>{map});
        return;
    }
    // Grey and of one source: what is computed for nothing is not kept either.
    hw::FrameStore<Depth> shaded = map;
    shaded.intensity = scratch(frame, 0);
    shaded.direct = scratch(frame, 1);
    into(raster::PictureSink<Depth>{shaded});
}

// A pass of the low-pass over `plane` on these lines. `room` is free.
template <class Depth>
void pass_low(std::span<std::uint8_t> plane, const FrameBuffers<Depth>& frame, Depth none,
              std::span<std::uint8_t> room, const LineSet& lines) {
    for_bands(frame.executor, lines.size(), [&](hw::Band band, std::size_t) {
        low_pass<Depth>(plane, frame.observer, none, room, lines.within(band));
    });
}

// Fills a source's edges and filtered. Returns the lines that the composite
// has work on: a filter leaves a line as it is if it and its neighbours are lit, and each pass of
// the low-pass reaches one line further.
template <class Depth>
LineSet filter(const FrameInputs& in, const FramePlan& plan, const Source& source,
               FrameBuffers<Depth>& frame, FrameCounts& counts) {
    const std::size_t l = source.first_light;
    const Settings& settings = in.settings;
    const int size = settings.machine.size_px();
    const auto none = static_cast<Depth>(settings.machine.background());
    LightBuffers<Depth>& light = frame.lights[l];
    LightCounts& counted = counts.lights[l];
    counted.filtered_lines = {};
    counted.chain_steps = 0;
    LineSet lines = plan.leaves_out(Omission::lit_lines, l) ? lines_with_shadow(light.joined, size)
                                                            : LineSet::all(size);
    const Executor& executor = frame.executor;
    copy_lines(light.joined, LineSet::all(size), light.edges, executor);
    if constexpr (!hw::built(hw::Feature::filters)) {
        copy(light.edges, light.filtered);
        return lines;
    }
    const bool has_edges = method_of(in).darkness == Darkness::binary && !source.is_graded();
    if (has_edges && !plan.leaves_out(Omission::dequantize, l)) {
        counted.filtered_lines.dequantize = lines.count();
        counted.chain_steps =
            dequantize<Depth>(light.joined, frame.observer, none, settings.dequantize_passes,
                              frame.edge_memory, light.edges, lines, executor);
    }
    copy_lines(light.edges, LineSet::all(size), light.filtered, executor);
    if (plan.leaves_out(Omission::low_pass, l)) return lines;
    for (int pass = 0; pass < settings.low_pass_passes; ++pass) {
        lines = lines.with_neighbours();
        counted.filtered_lines.low_pass += lines.count();
        // The picture's first plane is free until the composite.
        pass_low(light.filtered, frame, none, frame.picture_of(0), lines);
        copy_lines(frame.picture_of(0), lines, light.filtered, executor);
    }
    if (settings.low_pass_passes == 0)  // not left out: a pass whose result nobody reads
        pass_low(light.filtered, frame, none, scratch(frame), LineSet::all(size));
    return lines;
}

// A source's darkness from the masks of its lights: their mean, rounded half up; or a ramp around
// its one mask.
template <class Depth>
void join(const FrameInputs& in, const Source& source, FrameBuffers<Depth>& frame) {
    if (!source.is_graded()) return;  // the darkness is its light's mask
    if constexpr (hw::built(hw::Feature::lights)) {
        if (source.ramp_px > 0) {
            const LightBuffers<Depth>& light = frame.lights[source.first_light];
            ramp<Depth>(light.mask, frame.observer,
                        static_cast<Depth>(in.settings.machine.background()), source.ramp_px,
                        scratch(frame), light.joined);
            return;
        }
    }
    const std::span lights = std::span(frame.lights).subspan(source.first_light, source.lights);
    const std::span<std::uint8_t> joined = lights.front().joined;
    const auto n = static_cast<std::uint32_t>(source.lights);
    const hw::FrameStore<Depth>& store = frame.observer;
    for_bands(frame.executor, store.size_px(), [&](hw::Band band, std::size_t) {
        for (std::size_t a = store.address(0, band.first); a < store.address(0, band.end); ++a) {
            std::uint32_t sum = 0;
            for (const LightBuffers<Depth>& light : lights) sum += light.mask[a];
            joined[a] = static_cast<std::uint8_t>((2 * sum + n) / (2 * n));
        }
    });
}

template <class Depth>
void test_light(const FrameInputs& in, const FramePlan& plan, std::size_t l,
                FrameBuffers<Depth>& frame, FrameCounts& counts) {
    if (plan.leaves_out(Omission::same_mask, l)) return;
    if (plan.leaves_out(Omission::post_process, l)) {
        counts.lights[l].post_process = {};
        light_up(frame.lights[l].mask);
    } else {
        method_of(in).stages<Depth>().cast(in, plan, l, frame, counts);
    }
}

// The sectors have one mask, of which each writes the pixels in its cone; it is kept whole or not.
template <class Depth>
void test_sectors(const FrameInputs& in, const FramePlan& plan, const Source& source,
                  FrameBuffers<Depth>& frame, FrameCounts& counts) {
    const std::size_t first = source.first_light;
    if (plan.leaves_out(Omission::same_mask, first)) return;
    light_up(frame.lights[first].mask);
    const bool classified = in.settings.sector_test == SectorTest::classified;
    bool needed = false;  // by any
    for (std::size_t k = 0; k < source.lights; ++k) {
        counts.lights[first + k].post_process = {};
        needed = needed || !plan.leaves_out(Omission::post_process, first + k);
    }
    for (std::size_t k = 0; k < source.lights; ++k)
        if (classified ? needed && k == 0 : !plan.leaves_out(Omission::post_process, first + k))
            method_of(in).stages<Depth>().cast(in, plan, first + k, frame, counts);
}

// Whether the intensities of a view whose Z is kept were shaded from the list of what it shows. The
// list is made in the first such frame.
template <class Depth>
bool shaded_from_list(const FrameInputs& in, const FramePlan& plan, FrameBuffers<Depth>& frame,
                      FrameCounts& counts) {
    raster::VisibleList* list = frame.visible;
    const raster::ShadingSpec spec = shading_of(in);
    if (list == nullptr || list->does_not_fit() || !raster::lists_cover(spec) ||
        in.settings.surface != raster::PatchForm::catmull || !in.scene.mesh.facets.empty())
        return false;
    if (!list->is_whole()) {
        raster::VisibleSink<Depth> sink{frame.observer, *list};
        counts.observer =
            draw_view(in, plan, in.scene.observer, in.matrices.world_to_observer, frame, sink);
        list->end();
        if (!list->is_whole()) return false;
    }
    raster::shade_list(*list, in.scene.patches, in.scene.materials, spec, frame.observer);
    return true;
}

template <class Depth>
void draw_picture(const FrameInputs& in, const FramePlan& plan, FrameBuffers<Depth>& frame,
                  FrameCounts& counts) {
    if (plan.leaves_out(Omission::same_observer)) return;
    const Method& method = method_of(in);
    hw::FrameStore<Depth> store = drawn_store(in, frame);
    bool tested = false;  // in this drawing
    for (std::size_t l = 0; method.tests_when_drawn() && l < in.scene.light_count; ++l) {
        light_up(frame.lights[l].mask);
        tested = tested || !plan.leaves_out(Omission::post_process, l);
    }
    if (!tested && plan.leaves_out(Omission::same_depth)) {
        clear_intensities(in.settings.machine, store);
        if constexpr (hw::built(hw::Feature::reuse))
            if (shaded_from_list(in, plan, frame, counts)) return;
    } else {
        if (frame.visible != nullptr) frame.visible->forget();
        clear_store(in, store, frame.executor);
    }
    if (tested) {
        method.stages<Depth>().draw(in, plan, frame, counts);
        return;
    }
    raster::PictureSink<Depth> sink{store};
    counts.observer = draw_view(in, plan, in.scene.observer, in.matrices.world_to_observer, frame,
                                sink);
}

}  // namespace

template <class Depth>
void draw_light(const FrameInputs& in, const FramePlan& plan, FrameBuffers<Depth>& frame,
                FrameCounts& counts) {
    require_held(in);
    require_fits(in, frame);
    for (std::size_t l = 0; l < in.scene.light_count; ++l) draw_map(in, plan, l, frame, counts);
}

template <class Depth>
void draw_observer(const FrameInputs& in, const FramePlan& plan, FrameBuffers<Depth>& frame,
                   FrameCounts& counts) {
    require_held(in);
    require_fits(in, frame);
    draw_picture(in, plan, frame, counts);
    for (std::size_t l = 0; l < in.scene.light_count; ++l) {
        if (method_of(in).has_map() && plan.leaves_out(Omission::light_drawing, l) &&
            !plan.leaves_out(Omission::same_light_map, l))
            std::copy(frame.observer.depth.begin(), frame.observer.depth.end(),
                      frame.lights[l].map.depth.begin());
    }
}

template <class Depth>
void cast_shadows(const FrameInputs& in, const FramePlan& plan, FrameBuffers<Depth>& frame,
                  FrameCounts& counts) {
    require_fits(in, frame);
    for (std::size_t s = 0; s < in.scene.sources_used(); ++s) {
        const Source source = in.scene.source(s);
        if (source.sectored) {
            test_sectors(in, plan, source, frame, counts);
        } else {
            for (std::size_t k = 0; k < source.lights; ++k)
                test_light(in, plan, source.first_light + k, frame, counts);
        }
        join(in, source, frame);
    }
}

template <class Depth>
void filter_and_composite(const FrameInputs& in, const FramePlan& plan, FrameBuffers<Depth>& frame,
                          FrameCounts& counts) {
    require_fits(in, frame);
    if (plan.leaves_out(Omission::same_picture)) return;
    // All filters before the first composite: the low-pass works in the picture's plane.
    std::array<LineSet, max_sources> lines;
    const std::size_t sources = in.scene.sources_used();
    for (std::size_t s = 0; s < sources; ++s) {
        const std::size_t l = in.scene.source(s).first_light;
        lines[s] = filter(in, plan, in.scene.source(s), frame, counts);
        if (!plan.leaves_out(Omission::composite, l))
            counts.lights[l].filtered_lines.composite = lines[s].count();
    }
    for_bands(frame.executor, in.settings.machine.size_px(), [&](hw::Band band, std::size_t) {
        for (std::size_t channel = 0; channel < in.scene.channels; ++channel)
            composite_all(in, plan, channel, lines, band, frame);
    });
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
