#include "shadow/post_process.hpp"

namespace umbra78::shadow {
namespace {

template <class Depth>
PostProcessCounts test_frame(const hw::FrameStore<const Depth>& observer,
                             const hw::FrameStore<const Depth>& light,
                             const hw::MatrixWords& matrix, const ShadowTest& settings,
                             const PostProcessWork& work, std::span<std::uint8_t> mask) {
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

}  // namespace

PostProcessCounts post_process(const hw::FrameStore<const hw::Depth16>& observer,
                               const hw::FrameStore<const hw::Depth16>& light,
                               const hw::MatrixWords& matrix, const ShadowTest& settings,
                               const PostProcessWork& work, std::span<std::uint8_t> mask) {
    return test_frame(observer, light, matrix, settings, work, mask);
}
PostProcessCounts post_process(const hw::FrameStore<const hw::Depth32>& observer,
                               const hw::FrameStore<const hw::Depth32>& light,
                               const hw::MatrixWords& matrix, const ShadowTest& settings,
                               const PostProcessWork& work, std::span<std::uint8_t> mask) {
    return test_frame(observer, light, matrix, settings, work, mask);
}

}  // namespace umbra78::shadow
