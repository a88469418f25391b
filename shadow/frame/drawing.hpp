// Drawing a view of a frame into one of its stores: what the stages and the methods share.
#pragma once

#include "shadow/frame/buffers.hpp"
#include "shadow/frame/features.hpp"
#include "shadow/frame/methods.hpp"
#include "shadow/frame/plan.hpp"
#include "shadow/frame/shared_drawing.hpp"
#include "shadow/midpoint.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

namespace umbra78::shadow {

// Whether the observer's view is drawn with its normals.
inline bool keeps_normals(const FrameInputs& in) {
    return hw::built(hw::Feature::surface_bias) && method_of(in).plane == ExtraPlane::normal &&
           reads_normals(in.settings);
}

// The observer's store as it is drawn: a frame may have room for normals that are not kept.
template <class Depth>
hw::FrameStore<Depth> drawn_store(const FrameInputs& in, const FrameBuffers<Depth>& frame) {
    hw::FrameStore<Depth> store = frame.observer;
    if (!keeps_normals(in)) store.normal = {};
    return store;
}

// The check at a stage's entry: the buffers have the sizes that the settings and the scene ask for.
template <class Depth>
void require_fits(const FrameInputs& in, const FrameBuffers<Depth>& frame) {
    const hw::MachineSpec& m = in.settings.machine;
    const std::size_t pixels = std::size_t{1} << (2 * m.xy_bits);
    const std::size_t sources = in.scene.sources_used(), channels = in.scene.channels;
    bool fits = frame.observer.xy_bits == m.xy_bits && frame.observer.depth.size() == pixels &&
                frame.observer.intensity.size() == channels * pixels &&
                frame.observer.direct.size() == channels * sources * pixels &&
                frame.picture.size() == channels * pixels;
    fits = fits && frame.observer.normal.size() >= (keeps_normals(in) ? 3 * pixels : 0);
    const std::size_t layers = static_cast<std::size_t>(map_layers(in.settings));
    for (std::size_t l = 0; l < in.scene.light_count; ++l) {
        const LightBuffers<Depth>& light = frame.lights[l];
        fits = fits && light.map.xy_bits == m.xy_bits && light.mask.size() == pixels &&
               light.map.depth.size() >= (layers > 0 ? pixels : 0) &&
               light.second.depth.size() >= (layers > 1 ? pixels : 0);
    }
    for (std::size_t s = 0; s < sources; ++s) {
        const LightBuffers<Depth>& first = frame.lights[in.scene.source(s).first_light];
        fits = fits && first.joined.size() == pixels && first.edges.size() == pixels &&
               first.filtered.size() == pixels;
    }
    fixed::require(frame.executor.workers <= frame.workers,
                   "frame carved for fewer workers than the executor has");
    fixed::require(missing_feature(in.scene, in.settings).empty(),
                   "this build leaves out a stage that is asked for");
    fixed::require(fits, "frame carved for other widths than the settings have");
    fixed::require(m.z_bits <= static_cast<int>(8 * sizeof(Depth)),
                   "frame carved for fewer bits of Z than the settings have");
    fixed::require(in.scene.streamed || (in.scene.patches.size() <= frame.order.size() &&
                                         in.scene.patches.size() <= frame.nearest.size()),
                   "frame carved for fewer patches than the scene has");
}

// A quarter of the observer's pixel at its target: both views are diced alike.
inline std::int64_t dice_tolerance(const FrameInputs& in) {
    return fixed::floor_shift(std::int64_t{in.scene.observer.extent},
                              in.settings.machine.xy_bits + 1);
}

inline raster::ShadingSpec shading_of(const FrameInputs& in) {
    const hw::WordFormat object = in.matrices.object;
    raster::ShadingSpec spec;
    spec.ambient_q8 = in.settings.ambient_q8;
    spec.viewer = raster::toward_eye(in.scene.observer, object);
    spec.source_count = in.scene.sources_used();
    spec.channels = in.scene.channels;
    spec.rule = in.settings.shading;
    spec.keeps_normals = keeps_normals(in);
    for (std::size_t s = 0; s < spec.source_count; ++s) {
        const Source source = in.scene.source(s);
        spec.sources[s] = {raster::toward_eye(source.place, object), source.level_q8};
    }
    return spec;
}

inline raster::DrawSetup draw_setup(const FrameInputs& in, const FramePlan& plan,
                                    const hw::MatrixWords& matrix) {
    const hw::WordFormat object = in.matrices.object;
    return {in.settings.machine,
            matrix,
            object,
            in.settings.sampling,
            in.scene.materials,
            shading_of(in),
            in.settings.surface,
            in.settings.dice_levels,
            dice_tolerance(in),
            in.settings.facing,
            !in.scene.streamed,  // the ledger's counts are then those of this drawing
            plan.unit_work(),
            plan.leaves_out(Omission::outside_surfaces) ? raster::Drawn::inside
                                                        : raster::Drawn::all};
}

// What of the surfaces casts light l's shadows, and how deep.
inline raster::Casters casters_of(const FrameInputs& in, std::size_t l) {
    const Settings& s = in.settings;
    raster::Casters c;
    if (!method_of(in).has_map()) return c;  // no depth is kept
    if (s.map_depth == MapDepth::back) c.facing = raster::Facing::back;
    c.slope_q8 = s.bias_slope_q8;
    if (s.bias_clamp_q16 > 0)
        c.limit = fixed::floor_shift(in.matrices.lights[l].clamp_quanta_q16,
                                     16 - raster::depth_guard(s.machine));
    return c;
}

// By how much light l's receivers' planes may change a depth, in quanta.
inline std::int64_t plane_limit(const FrameInputs& in, std::size_t l) {
    return in.settings.bias_clamp_q16 == 0
               ? INT64_MAX
               : fixed::floor_shift(in.matrices.lights[l].clamp_quanta_q16, 16);
}

inline ReceiverWords receiver_words(const FrameInputs& in, std::size_t l) {
    const LightMatrices& m = in.matrices.lights[l];
    return {plane_limit(in, l), m.scale, m.axes};
}

// What stands on a scene's ground, in two parts: what comes before and after it.
template <class Visit>
void for_others_than_ground(const Scene& scene, Visit&& visit) {
    visit(raster::Surfaces(scene.patches.first(scene.ground)));
    visit(raster::Surfaces(scene.patches.subspan(scene.ground + 1), scene.mesh));
}

// What is drawn for a light, in parts: all surfaces for its map; on a ground, what stands there, or
// the blobs.
template <class Visit>
void for_casters(const FrameInputs& in, Visit&& visit) {
    if (!method_of(in).on_ground()) {
        visit(in.scene.surfaces());
        return;
    }
    if (method_of(in).form != Form::blob) {
        for_others_than_ground(in.scene, visit);
        return;
    }
    if constexpr (hw::built(hw::Feature::ground)) {
        for (const raster::Ellipse& blob : in.scene.blobs) {
            std::array<raster::Patch, raster::patches_per_ellipse> patches;
            raster::ellipse_patches(blob, patches);
            visit(raster::Surfaces(patches));
        }
    }
}

// Which triangles cast: a shadow that is drawn flat has lost the side that faces the light.
inline raster::Facing light_facing(const FrameInputs& in) {
    return method_of(in).has_map() ? in.settings.facing : raster::Facing::both;
}

// Draws these surfaces front to back, which saves time and changes no bit; a blob's as they are.
template <class Depth, class Sink>
raster::DrawCounts draw_surfaces(const raster::Surfaces& surfaces, const raster::View& view,
                                 const raster::DrawSetup& setup, FrameBuffers<Depth>& frame,
                                 Sink& sink) {
    const std::size_t patches = surfaces.patches.size();
    const std::span order =
        patches <= frame.order.size() ? frame.order.first(patches) : std::span<std::uint32_t>();
    if (!order.empty()) raster::order_front_to_back(surfaces.patches, view, order, frame.nearest);
    if constexpr (BandSink<Sink>) {
        if (frame.executor.shares()) return draw_shared(surfaces, order, setup, frame, sink);
    }
    return raster::draw(surfaces, order, setup, *frame.draw, sink);
}

// Draws into what the store holds; the sink decides whether a sample replaces what is there. What
// is left out as hidden depends on the order; a batch of a stream has none.
template <class Depth, class Sink>
raster::DrawCounts draw_view(const FrameInputs& in, const FramePlan& plan, const raster::View& view,
                             const hw::MatrixWords& matrix, FrameBuffers<Depth>& frame,
                             Sink& sink, const raster::Casters& casters = {}) {
    raster::DrawSetup setup = draw_setup(in, plan, matrix);
    setup.casters = casters;
    if (in.scene.streamed) return raster::draw(in.scene.surfaces(), {}, setup, *frame.draw, sink);
    return draw_surfaces(in.scene.surfaces(), view, setup, frame, sink);
}

// The same of light l's view. `sink` serves maps of one layer; with two the frame's own is used.
template <class Depth, class Sink>
raster::DrawCounts draw_map_view(const FrameInputs& in, const FramePlan& plan, std::size_t l,
                                 FrameBuffers<Depth>& frame, Sink& sink) {
    const auto into = [&](auto& any) {
        return draw_view(in, plan, in.scene.lights[l], in.matrices.lights[l].world_to_light, frame,
                         any, casters_of(in, l));
    };
    if constexpr (hw::built(hw::Feature::surface_bias)) {
        if (map_layers(in.settings) > 1) {
            MidpointSink<Depth> both{frame.lights[l].map, frame.lights[l].second};
            return into(both);
        }
    }
    return into(sink);
}

// FrameStore::clear().
template <class Depth>
void clear_store(const FrameInputs& in, const hw::FrameStore<Depth>& store,
                 const Executor& executor) {
    const std::size_t pixels = store.depth.size();
    for_bands(executor, store.size_px(), [&](hw::Band band, std::size_t) {
        const std::size_t first = store.address(0, band.first);
        const std::size_t count = store.address(0, band.end) - first;
        const auto fill = [&](auto planes, auto value) {
            for (std::size_t p = 0; p < planes.size(); p += pixels)
                std::fill_n(planes.data() + p + first, count, value);
        };
        fill(store.depth, static_cast<Depth>(in.settings.machine.background()));
        fill(store.intensity, std::uint8_t{0});
        fill(store.direct, std::uint8_t{0});
        fill(store.normal, hw::no_normal);
    });
}

// Before the first of a map's surfaces, and after the last.
template <class Depth>
void clear_map(const FrameInputs& in, LightBuffers<Depth>& light, const Executor& executor) {
    clear_store(in, light.map, executor);
    if (map_layers(in.settings) > 1) clear_store(in, light.second, executor);
}
template <class Depth>
void finish_map(const FrameInputs& in, LightBuffers<Depth>& light) {
    if (map_layers(in.settings) > 1) 
        take_midpoints<Depth>(in.settings.machine, light.second.depth, light.map.depth);
}

// What the plain post-process does under a plan.
inline PostProcessWork work_of(const FramePlan& plan) {
    return {plan.unit_work(), !plan.leaves_out(Omission::background_pixels),
            !plan.leaves_out(Omission::noise), !plan.leaves_out(Omission::empty_lines)};
}

}  // namespace umbra78::shadow
