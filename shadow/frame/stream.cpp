#include "shadow/frame/stream.hpp"

#include "raster/extent.hpp"
#include "raster/sinks.hpp"
#include "shadow/frame/drawing.hpp"
#include "shadow/frame/frame.hpp"
#include "shadow/frame/methods.hpp"

#include <algorithm>

namespace umbra78::shadow {
namespace {

// The views that a pass over the source draws.
struct Pass {
    bool lights, observer;
};

template <class Depth>
void clear(const FrameInputs& in, FrameBuffers<Depth>& frame) {
    frame.observer.clear(in.settings.machine);
    for (std::size_t l = 0; l < in.scene.light_count; ++l) {
        clear_map(in, frame.lights[l], frame.executor);
        std::ranges::fill(frame.lights[l].mask, mask_lit);
    }
}

template <class Depth>
void draw_lights(const FrameInputs& part, const FramePlan& plan, FrameBuffers<Depth>& frame,
                 FrameCounts& counts) {
    for (std::size_t l = 0; l < part.scene.light_count; ++l) {
        raster::DepthSink<Depth> sink{frame.lights[l].map};
        counts.lights[l].map += draw_map_view(part, plan, l, frame, sink);
    }
}

template <class Depth>
void draw_part(const FrameInputs& part, const FramePlan& plan, FrameBuffers<Depth>& frame,
                  FrameCounts& counts) {
    const Method& method = method_of(part);
    if (method.tests_when_drawn()) {
        FrameCounts of_batch;
        method.stages<Depth>().draw(part, plan, frame, of_batch);
        counts.observer += of_batch.observer;
        return;
    }
    hw::FrameStore<Depth> store = drawn_store(part, frame);
    raster::PictureSink<Depth> sink{store};
    counts.observer += draw_view(part, plan, part.scene.observer,
                                 part.matrices.world_to_observer, frame, sink);
}

template <class Depth>
StreamStatus run(Pass pass, const FrameInputs& in, const FramePlan& plan,
                 raster::PrimitiveSource& source, FrameBuffers<Depth>& frame,
                 FrameCounts& counts) {
    using Next = raster::PrimitiveSource::Next;
    if (!source.rewind()) return StreamStatus::cannot_rewind;
    FrameInputs part = in;
    raster::Surfaces batch;
    while (true) {
        const Next next = source.next(batch);
        if (next == Next::end) break;
        if (next == Next::failed) return StreamStatus::source_failed;
        raster::Box box;
        batch.for_points([&](const raster::World& p) { box.add(p); });
        if (box.largest() > in.scene.largest_streamed) return StreamStatus::beyond_largest;
        part.scene.patches = batch.patches;
        part.scene.mesh = batch.mesh;
        if (pass.lights) draw_lights(part, plan, frame, counts);
        if (pass.observer) draw_part(part, plan, frame, counts);
    }
    for (std::size_t l = 0; pass.lights && l < in.scene.light_count; ++l)
        finish_map(in, frame.lights[l]);
    return StreamStatus::ok;
}

}  // namespace

template <class Depth>
StreamStatus draw_stream(const FrameInputs& in, const FramePlan& plan,
                         raster::PrimitiveSource& source, FrameBuffers<Depth>& frame,
                         FrameCounts& counts) {
    fixed::require(in.scene.streamed && in.scene.surfaces().empty(),
                   "draw_stream: the scene has surfaces of its own");
    require_fits(in, frame);
    fixed::require(method_of(in).has_map(), "draw_stream: a stream names no ground");
    counts = {};
    clear(in, frame);
    const bool map_first = method_of(in).tests_when_drawn();
    StreamStatus status = run({true, !map_first}, in, plan, source, frame, counts);
    if (status == StreamStatus::ok && map_first)
        status = run({false, true}, in, plan, source, frame, counts);
    if (status != StreamStatus::ok) return status;
    cast_shadows(in, plan, frame, counts);
    filter_and_composite(in, plan, frame, counts);
    return status;
}

#define UMBRA78_STREAM(Depth)                                                                    \
    template StreamStatus draw_stream(const FrameInputs&, const FramePlan&,                      \
                                      raster::PrimitiveSource&, FrameBuffers<Depth>&, FrameCounts&);
UMBRA78_STREAM(hw::Depth16)
UMBRA78_STREAM(hw::Depth32)
#undef UMBRA78_STREAM

}  // namespace umbra78::shadow
