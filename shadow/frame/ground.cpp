#include "shadow/frame/ground.hpp"

#include "shadow/frame/drawing.hpp"
#include "shadow/frame/planar_cost.hpp"
#include "shadow/planar.hpp"

#include <algorithm>

namespace umbra78::shadow {
namespace {

template <class Depth>
void draw_shadow(const FrameInputs& in, const FramePlan& plan, std::size_t l,
                 FrameBuffers<Depth>& frame, FrameCounts& counts) {
    counts.lights[l].map = {};
    if (plan.leaves_out(Omission::light_map, l) || plan.leaves_out(Omission::post_process, l))
        return;
    CoverageSink<Depth> sink(frame.observer, in.settings.machine, frame.lights[l].mask);
    raster::DrawSetup setup = draw_setup(in, plan, in.matrices.lights[l].world_to_light);
    setup.facing = light_facing(in);
    for_casters(in, [&](const raster::Surfaces& surfaces) {
        counts.lights[l].map += draw_surfaces(surfaces, in.scene.observer, setup, frame, sink);
    });
}

}  // namespace

template <class Depth>
void draw_on_ground(const FrameInputs& in, const FramePlan& plan, FrameBuffers<Depth>& frame,
                    FrameCounts& counts) {
    const raster::View& view = in.scene.observer;
    const raster::DrawSetup setup = draw_setup(in, plan, in.matrices.world_to_observer);
    hw::FrameStore<Depth> store = drawn_store(in, frame);
    raster::PictureSink<Depth> ground{store};
    counts.observer = draw_surfaces(in.scene.patches.subspan(in.scene.ground, 1), view, setup,
                                    frame, ground);
    for (std::size_t l = 0; l < in.scene.light_count; ++l)
        draw_shadow(in, plan, l, frame, counts);
    const std::span lights = std::span(frame.lights).first(in.scene.light_count);
    const auto light_up = [lights](std::size_t address) {
        for (const LightBuffers<Depth>& light : lights) light.mask[address] = mask_lit;
    };
    BeforeSink before(store, light_up);
    for_others_than_ground(in.scene, [&](const raster::Surfaces& surfaces) {
        counts.observer += draw_surfaces(surfaces, view, setup, frame, before);
    });
}

template <class Depth>
void count_on_ground(const FrameInputs& in, const FramePlan&, std::size_t l,
                     FrameBuffers<Depth>& frame, FrameCounts& counts) {
    const std::span<const std::uint8_t> mask = frame.lights[l].mask;
    const auto none = static_cast<Depth>(in.settings.machine.background());
    const auto times = [](const auto& plane, auto value) {
        return static_cast<std::uint64_t>(std::count(plane.begin(), plane.end(), value));
    };
    PostProcessCounts& counted = counts.lights[l].post_process;
    counted = {};
    counted.visible = mask.size() - times(frame.observer.depth, none);
    counted.shadowed = times(mask, mask_shadow);
}

template <class Depth>
void cost_on_ground(const FrameInputs& in, std::size_t, const FrameBuffers<Depth>&,
                    const FrameCounts&, FrameLedger& ledger) {
    const hw::Operations o = ledger.observer_counts.samples * cost::mask_with_record;
    ledger.test = {o, method_of(in).units(o, in.settings)};
}

#define UMBRA78_GROUND(Depth)                                                                    \
    template void draw_on_ground(const FrameInputs&, const FramePlan&, FrameBuffers<Depth>&,     \
                                 FrameCounts&);                                                  \
    template void count_on_ground(const FrameInputs&, const FramePlan&, std::size_t,             \
                                  FrameBuffers<Depth>&, FrameCounts&);                           \
    template void cost_on_ground(const FrameInputs&, std::size_t, const FrameBuffers<Depth>&,    \
                                 const FrameCounts&, FrameLedger&);
UMBRA78_GROUND(hw::Depth16)
UMBRA78_GROUND(hw::Depth32)
#undef UMBRA78_GROUND

}  // namespace umbra78::shadow
