#include "shadow/frame/irregular_map.hpp"

#include "raster/places.hpp"
#include "shadow/carver.hpp"
#include "shadow/frame/drawing.hpp"
#include "shadow/light_place.hpp"
#include "shadow/post_process.hpp"
#include "shadow/rivals/costs.hpp"

#include <algorithm>

namespace umbra78::shadow {
namespace {

template <class Depth>
struct Parts {
    std::span<Depth> codes;
    std::span<raster::Place> places;
    std::span<std::uint32_t> heads;
};

template <class Depth>
Parts<Depth> take_parts(Carver& carver, std::size_t pixels) {
    return {carver.take<Depth>(pixels), carver.take<raster::Place>(pixels),
            carver.take<std::uint32_t>(pixels)};
}

// Calls visit(x, y, address, place) for the visible points that lie in the light's volume; returns
// how many are visible.
template <class Depth, class Visit>
std::uint64_t for_points(const FrameInputs& in, const hw::TransformUnit& unit,
                         const hw::FrameStore<Depth>& observer, Visit&& visit) {
    const ShadowTest& test = in.settings;
    const auto none = static_cast<Depth>(test.machine.background());
    std::uint64_t visible = 0;
    for (int y = 0; y < test.machine.size_px(); ++y) {
        for (int x = 0; x < test.machine.size_px(); ++x) {
            const std::size_t at = observer.address(x, y);
            if (observer.depth[at] == none) continue;
            ++visible;
            const hw::Point p = unit(pixel_words(x, y, observer.depth[at], test));
            const LightPlace place = light_place(test.machine, p, hw::DitherWords{0, 0});
            if (place.inside) visit(x, y, at, place);
        }
    }
    return visible;
}

// All but the drawing.
hw::Operations operations_of(const hw::MatrixWords& matrix, std::uint64_t visible,
                             const raster::PlaceCounts& places) {
    namespace cost = rivals::cost;
    return places.places * cost::placed_sample + places.texels * cost::scanned_texel +
           places.visits * cost::box_test +
           visible * (matrix.affine ? cost::moved_point : cost::divided_point);
}

}  // namespace

std::size_t irregular_map_bytes(const FrameInputs& in) {
    const std::size_t pixels = std::size_t{1} << (2 * in.settings.machine.xy_bits);
    Carver carver(static_cast<std::byte*>(nullptr));
    take_parts<hw::Depth32>(carver, pixels);
    return carver.used();
}

template <class Depth>
void cast_irregular_map(const FrameInputs& in, const FramePlan& plan, std::size_t l,
                        FrameBuffers<Depth>& frame, FrameCounts& counts) {
    const hw::MachineSpec& spec = in.settings.machine;
    const std::span<std::uint8_t> mask = frame.lights[l].mask;
    LightCounts& counted = counts.lights[l];
    Carver carver(frame.method_memory);
    const Parts<Depth> parts = take_parts<Depth>(carver, mask.size());
    counted.capacity = {carver.fits(), carver.used()};
    if (!carver.fits()) return;

    const hw::TransformUnit unit(spec, in.matrices.lights[l].observer_to_light, plan.unit_work());
    raster::Places places(spec, parts.places, parts.heads);
    const int scale = raster::raster_fraction - spec.fraction_bits;
    counted.post_process = {};
    counted.post_process.visible = for_points(
        in, unit, frame.observer, [&](int x, int y, std::size_t, const LightPlace& place) {
            places.add(static_cast<std::int32_t>(place.x * (1 << scale)),
                       static_cast<std::int32_t>(place.y * (1 << scale)), x, y);
        });
    hw::FrameStore<Depth> codes{spec.xy_bits, parts.codes};
    codes.clear(spec);
    raster::PlaceSink<Depth> sink{codes, places};
    counted.map = draw_view(in, plan, in.scene.lights[l], in.matrices.lights[l].world_to_light,
                            frame, sink);
    std::fill(mask.begin(), mask.end(), mask_lit);
    for_points(in, unit, frame.observer, [&](int, int, std::size_t at, const LightPlace& place) {
        if (place.code <= std::int64_t{codes.depth[at]}) return;
        mask[at] = mask_shadow;
        ++counted.post_process.shadowed;
    });
    counted.method_frame = operations_of(in.matrices.lights[l].observer_to_light,
                                         counted.post_process.visible, places.counts());
    counted.method_entries = places.counts().places;
}

#define UMBRA78_IRREGULAR_MAP(Depth)                                                             \
    template void cast_irregular_map(const FrameInputs&, const FramePlan&, std::size_t,          \
                                     FrameBuffers<Depth>&, FrameCounts&);
UMBRA78_IRREGULAR_MAP(hw::Depth16)
UMBRA78_IRREGULAR_MAP(hw::Depth32)
#undef UMBRA78_IRREGULAR_MAP

}  // namespace umbra78::shadow
