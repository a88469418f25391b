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
    const bool draws_noise = hw::built(hw::Feature::dither) && work.noise;
    const LineSet lines =
        work.empty_lines ? LineSet::all(size)
                         : lines_with_visible<Depth>(observer.depth, size, spec.background());
    const int noisy_taps = map.window.noisy_taps();
    PostProcessCounts counts;
    for (int y = 0; y < size; ++y) {
        if (!lines.has(y)) {
            std::fill_n(mask.data() + observer.address(0, y), size, mask_lit);
            continue;
        }
        // The noise is clocked at every pixel, visible or not.
        hw::NoiseSource noise(drawn_dither(test), spec, 0, y);
        hw::TapNoise tap_noise(test.dither.seed, noisy_taps, spec, 0, y);
        for (int x = 0; x < size; ++x) {
            const hw::DitherWords d = draws_noise ? noise.next() : hw::DitherWords{0, 0};
            const hw::TapBytes taps = noisy_taps > 0 ? tap_noise.next() : hw::TapBytes{};
            const std::size_t a = observer.address(x, y);
            const std::uint32_t code = observer.depth[a];
            const bool visible = code != spec.background();
            mask[a] = mask_lit;
            if (!visible && !work.background) continue;
            ++counts.visible;
            const std::uint8_t dark =
                darkness(map, unit(pixel_words(x, y, code, test)), d, taps);
            if (dark == mask_lit || !visible) continue;  // background: transformed for nothing
            ++counts.shadowed;
            mask[a] = dark;
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
