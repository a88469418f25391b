#include "shadow/post_process.hpp"


#include <algorithm>

namespace umbra78::shadow {

template <class Depth>
PostProcessCounts post_process(const hw::FrameStore<Depth>& observer,
                               const hw::FrameStore<Depth>& light, const hw::MatrixWords& matrix,
                               const ShadowTest& settings, const PostProcessWork& work,
                               std::span<std::uint8_t> mask) {
    const hw::MachineSpec& spec = settings.machine;
    const hw::TransformUnit unit(spec, matrix, work.unit);
    const LightMap<Depth> map{light, spec, settings.lookup, settings.background};
    PostProcessCounts counts;
    for (int y = 0; y < spec.size_px(); ++y) {
        // The noise is clocked at every pixel, visible or not.
        hw::NoiseSource noise(drawn_dither(settings), spec, 0, y);
        for (int x = 0; x < spec.size_px(); ++x) {
            const hw::DitherWords d = work.noise ? noise.next() : hw::DitherWords{0, 0};
            const std::size_t a = observer.address(x, y);
            const std::uint32_t code = observer.depth[a];
            const bool visible = code != spec.background();
            mask[a] = mask_lit;
            if (!visible && !work.background) continue;
            ++counts.visible;
            if (!in_shadow(map, unit(pixel_words(x, y, code, settings)), d)) continue;
            if (!visible) continue;  // transformed for nothing
            ++counts.shadowed;
            mask[a] = mask_shadow;
        }
    }
    return counts;
}

template PostProcessCounts post_process(const hw::FrameStore<hw::Depth16>&,
                                        const hw::FrameStore<hw::Depth16>&,
                                        const hw::MatrixWords&, const ShadowTest&,
                                        const PostProcessWork&, std::span<std::uint8_t>);
template PostProcessCounts post_process(const hw::FrameStore<hw::Depth32>&,
                                        const hw::FrameStore<hw::Depth32>&,
                                        const hw::MatrixWords&, const ShadowTest&,
                                        const PostProcessWork&, std::span<std::uint8_t>);

}  // namespace umbra78::shadow
