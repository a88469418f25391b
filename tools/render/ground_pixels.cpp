#include "tools/render/ground_pixels.hpp"

#include "raster/sinks.hpp"
#include "shadow/frame/drawing.hpp"

#include <memory>
#include <type_traits>
#include <variant>

namespace umbra78::tools {

std::vector<std::uint8_t> ground_pixels(const LoadedScene& scene, const RenderJob& job) {
    const shadow::FrameInputs& in = job.inputs();
    const hw::MachineSpec& spec = job.settings().machine;
    const auto pixels = static_cast<std::size_t>(spec.size_px()) * spec.size_px();
    std::vector<std::uint8_t> seen(pixels, 0);
    if (!scene.ground) return seen;
    // Drawn alone by the whole scene's matrix, in the same words.
    std::vector<hw::Depth32> depth(pixels);
    hw::FrameStore<hw::Depth32> store{spec.xy_bits, depth, {}, {}};
    store.clear(spec);
    raster::DepthSink<hw::Depth32> sink{store};
    const auto memory = std::make_unique<raster::DrawMemory>();
    const shadow::Scene view = scene.view();
    raster::draw(raster::Surfaces(view.patches.subspan(view.ground, 1)), {},
                 shadow::draw_setup(in, {}, in.matrices.world_to_observer), *memory, sink);
    const Buffer observer = job.buffer(Plane::observer_z);
    std::visit(
        [&](const auto& codes) {
            for (std::size_t a = 0; a < pixels; ++a)
                seen[a] = codes[a] == depth[a] && depth[a] != spec.background() ? 1 : 0;
        },
        observer.values);
    return seen;
}

}  // namespace umbra78::tools
