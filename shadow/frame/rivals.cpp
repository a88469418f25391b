#include "shadow/frame/rivals.hpp"

#include "shadow/frame/ledger.hpp"
#include "shadow/frame/rival_casts.hpp"
#include "shadow/rivals/dicing.hpp"

#include <algorithm>

namespace umbra78::shadow {
namespace {

std::span<const raster::View> lights_of(const Scene& scene) {
    return std::span(scene.lights).first(scene.light_count);
}

// What every rival works on.
struct Pieces {
    std::span<std::byte> mesh, setting;
    std::span<raster::DiceMemory> dice;
    std::span<std::uint32_t> shown;
};

Pieces lay_out(Carver& carver, const rivals::MeshSize& size, std::size_t pixels) {
    return {carver.take<std::byte>(rivals::MeshBuilder::bytes(size)),
            carver.take<std::byte>(rivals::setting_bytes(size.facets, 3 * size.facets)),
            carver.take<raster::DiceMemory>(1), carver.take<std::uint32_t>(pixels)};
}

rivals::MeshSize size_of(const FrameInputs& in) {
    return rivals::diced_size(in.scene.surfaces(), in.settings.dice_levels);
}

bool prepare(const FrameInputs& in, std::size_t l, const Pieces& p, rivals::Setting& out) {
    const int xy_bits = in.settings.machine.xy_bits;
    const raster::View& observer = in.scene.observer;
    int fraction = 0;
    rivals::fit_fraction(observer, xy_bits, in.scene.surfaces(), lights_of(in.scene), fraction);
    const rivals::ToWords to(observer, xy_bits, fraction);
    rivals::Space space;
    rivals::Centre light{};
    rivals::MeshBuilder builder(p.mesh, size_of(in));
    rivals::add_diced(in.scene.surfaces(), in.settings.dice_levels, to, p.dice.front(), builder);
    rivals::Mesh mesh;
    return to.space(space) && to.light(in.scene.lights[l], light) &&
           builder.finish(mesh) == rivals::MeshStatus::ok &&
           rivals::make_setting(space, mesh, light, p.setting, out);
}

RivalView view_of(const FrameInputs& in, std::size_t l, const Pieces& pieces) {
    rivals::Setting setting;
    fixed::require(prepare(in, l, pieces, setting), "a rival's scene was not checked");
    rivals::VisibleCounts visible;
    rivals::find_visible(setting, pieces.shown, visible);
    return {setting, pieces.shown};
}

}  // namespace

FrameStatus check_rival(const Scene& scene, const Settings& settings) {
    if (scene.streamed) return FrameStatus::rival_of_stream;
    int fraction = 0;
    const rivals::SpaceStatus fits =
        rivals::fit_fraction(scene.observer, settings.machine.xy_bits, scene.surfaces(),
                             lights_of(scene), fraction);
    return fits == rivals::SpaceStatus::ok ? FrameStatus::ok : FrameStatus::too_wide_for_rival;
}

std::size_t rival_bytes(const FrameInputs& in) {
    const std::size_t pixels = std::size_t{1} << (2 * in.settings.machine.xy_bits);
    const rivals::MeshSize size = size_of(in);
    Carver carver(static_cast<std::byte*>(nullptr));
    lay_out(carver, size, pixels);
    return carver.used();
}

RivalView rival_view(const FrameInputs& in, std::size_t l, std::span<std::byte> memory) {
    Carver carver(memory);
    const Pieces pieces = lay_out(carver, size_of(in),
                                  std::size_t{1} << (2 * in.settings.machine.xy_bits));
    fixed::require(carver.fits(), "memory of fewer than rival_bytes()");
    return view_of(in, l, pieces);
}

template <class Depth>
void cast_rival(const FrameInputs& in, const FramePlan&, std::size_t l,
                FrameBuffers<Depth>& frame, FrameCounts& counts) {
    const std::span<std::uint8_t> mask = frame.lights[l].mask;
    LightCounts& counted = counts.lights[l];
    Carver carver(frame.method_memory);
    const Pieces pieces = lay_out(carver, size_of(in), mask.size());
    rivals::Work work;
    if (carver.fits()) {
        const RivalView view = view_of(in, l, pieces);
        const rivals::DepthScale scale = rivals::depth_scale(
            in.scene.observer, view.setting.space, in.settings.machine.z_bits);
        work = rivals::cast_by(in.settings.form, view.setting, view.shown, scale, carver, mask);
    }
    counted.capacity = {carver.fits(), carver.used()};
    counted.method_once = work.once;
    counted.method_frame = work.frame;
    counted.method_entries = work.entries;
    if (!carver.fits()) return;
    const auto none = static_cast<Depth>(in.settings.machine.background());
    PostProcessCounts& pixels = counted.post_process;
    pixels = {};
    for (std::size_t at = 0; at < mask.size(); ++at) {
        if (frame.observer.depth[at] == none) mask[at] = mask_lit;  // the picture shows nothing
        pixels.visible += frame.observer.depth[at] != none ? 1 : 0;
        pixels.shadowed += mask[at] != mask_lit ? 1 : 0;
    }
}

template <class Depth>
void cost_of_rival(const FrameInputs& in, std::size_t l, const FrameBuffers<Depth>&,
                   const FrameCounts& counts, FrameLedger& ledger) {
    const auto phase = [&](const hw::Operations& o) {
        return PhaseLedger{o, method_of(in).units(o, in.settings)};
    };
    ledger.scene = phase(counts.lights[l].method_once);
    ledger.test = phase(counts.lights[l].method_frame);
}

#define UMBRA78_RIVAL(Depth)                                                                     \
    template void cast_rival(const FrameInputs&, const FramePlan&, std::size_t,                  \
                             FrameBuffers<Depth>&, FrameCounts&);                                \
    template void cost_of_rival(const FrameInputs&, std::size_t, const FrameBuffers<Depth>&,     \
                                const FrameCounts&, FrameLedger&);
UMBRA78_RIVAL(hw::Depth16)
UMBRA78_RIVAL(hw::Depth32)
#undef UMBRA78_RIVAL

}  // namespace umbra78::shadow
