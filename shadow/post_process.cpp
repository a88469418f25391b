// The definition of the post-process: one pixel after the other, through the units themselves.
#include "shadow/post_process.hpp"

#include "shadow/lines.hpp"

#include <algorithm>

namespace umbra78::shadow {

template <class Depth>
PostProcessCounts post_process(const DepthMaps<Depth>& maps, const hw::MatrixWords& matrix,
                               const ShadowTest& test, const PostProcessWork& work,
                               std::span<std::uint8_t> mask) {
    const hw::MachineSpec& spec = test.machine;
    check(maps, spec, mask);
    const hw::FrameStore<const Depth>& observer = maps.observer;
    const hw::TransformUnit unit(spec, matrix, work.unit);
    const LightMap<Depth> map = light_map(maps.light, test);
    const int size = spec.size_px();
    const LineSet lines =
        work.empty_lines ? LineSet::all(size)
                         : lines_with_visible<Depth>(observer.depth, size, spec.background());
    PostProcessCounts counts;
    for (int y = 0; y < size; ++y) {
        if (!lines.has(y)) {
            std::fill_n(mask.data() + observer.address(0, y), size, mask_lit);
            continue;
        }
        // The noise is clocked at every pixel, visible or not.
        hw::NoiseSource noise(drawn_dither(test), spec, 0, y);
        for (int x = 0; x < size; ++x) {
            const hw::DitherWords d = work.noise ? noise.next() : hw::DitherWords{0, 0};
            const std::size_t a = observer.address(x, y);
            const std::uint32_t code = observer.depth[a];
            const bool visible = code != spec.background();
            mask[a] = mask_lit;
            if (!visible && !work.background) continue;
            ++counts.visible;
            if (!in_shadow(map, unit(pixel_words(x, y, code, test)), d)) continue;
            if (!visible) continue;  // transformed for nothing
            ++counts.shadowed;
            mask[a] = mask_shadow;
        }
    }
    return counts;
}

template PostProcessCounts post_process(const DepthMaps<hw::Depth16>&, const hw::MatrixWords&,
                                        const ShadowTest&, const PostProcessWork&,
                                        std::span<std::uint8_t>);
template PostProcessCounts post_process(const DepthMaps<hw::Depth32>&, const hw::MatrixWords&,
                                        const ShadowTest&, const PostProcessWork&,
                                        std::span<std::uint8_t>);

}  // namespace umbra78::shadow
