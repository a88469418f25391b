// The definition of the post-process: one pixel after the other, through the units themselves.
#include "shadow/post_process.hpp"

#include "shadow/pixel_darkness.hpp"

#include <algorithm>

namespace umbra78::shadow {

template <class Depth>
PostProcessCounts post_process(const DepthMaps<Depth>& maps, const hw::MatrixWords& matrix,
                               const ShadowTest& test, const PostProcessWork& work,
                               std::span<std::uint8_t> mask, const ReceiverWords& receiver,
                               hw::Band band) {
    const hw::MachineSpec& spec = test.machine;
    check(maps, spec, mask);
    const hw::FrameStore<const Depth>& observer = maps.observer;
    check_normals(observer, test);
    const hw::TransformUnit unit(spec, matrix, work.unit);
    const LightMap<Depth> map = light_map(maps.light, test);
    PostProcessCounts counts;
    const auto left_out = [&](int y) {
        std::fill_n(mask.data() + observer.address(0, y), spec.size_px(), mask_lit);
    };
    const int noisy_taps = map.window.noisy_taps();
    walk_pixels(observer, test, work, noisy_taps, band, left_out, [&](const WalkedPixel& at) {
        mask[at.address] = mask_lit;
        if (!at.visible && !work.background) return;
        ++counts.visible;
        const hw::Point p = unit(pixel_words(at.x, at.y, at.code, test));
        const std::uint8_t dark = pixel_darkness(map, observer, unit, test, at, p, receiver);
        if (dark == mask_lit || !at.visible) return;  // background: transformed for nothing
        ++counts.shadowed;
        mask[at.address] = dark;
    });
    return counts;
}

template PostProcessCounts post_process(const DepthMaps<hw::Depth16>&, const hw::MatrixWords&,
                                        const ShadowTest&, const PostProcessWork&,
                                        std::span<std::uint8_t>, const ReceiverWords&, hw::Band);
template PostProcessCounts post_process(const DepthMaps<hw::Depth32>&, const hw::MatrixWords&,
                                        const ShadowTest&, const PostProcessWork&,
                                        std::span<std::uint8_t>, const ReceiverWords&, hw::Band);

}  // namespace umbra78::shadow
