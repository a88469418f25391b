// The definition of the post-process: one pixel after the other, through the units themselves.
#include "shadow/post_process.hpp"

#include "shadow/lines.hpp"

#include <algorithm>

namespace umbra78::shadow {

namespace {

// The plane of a visible pixel whose results are `at`.
template <class Depth>
ReceiverPlane plane_of(const hw::FrameStore<const Depth>& observer, const hw::TransformUnit& unit,
                       const ShadowTest& test, int x, int y, const hw::Point& at,
                       std::int64_t limit) {
    int beside_x = 0, beside_y = 0, below_x = 0, below_y = 0;
    const std::uint32_t none = test.machine.background();
    if (!nearer_neighbour(observer, none, x, y, 1, 0, beside_x, beside_y) ||
        !nearer_neighbour(observer, none, x, y, 0, 1, below_x, below_y))
        return {at, 0, 0, limit};
    const auto result = [&](int px, int py) {
        return unit(pixel_words(px, py, observer.depth[observer.address(px, py)], test));
    };
    return receiver_plane(at, result(beside_x, beside_y), result(below_x, below_y), limit);
}

}  // namespace

template <class Depth>
PostProcessCounts post_process(const DepthMaps<Depth>& maps, const hw::MatrixWords& matrix,
                               const ShadowTest& test, const PostProcessWork& work,
                               std::span<std::uint8_t> mask, std::int64_t limit) {
    const hw::MachineSpec& spec = test.machine;
    check(maps, spec, mask);
    const hw::FrameStore<const Depth>& observer = maps.observer;
    const hw::TransformUnit unit(spec, matrix, work.unit);
    const LightMap<Depth> map = light_map(maps.light, test);
    const int size = spec.size_px();
    const bool has_plane =
        hw::built(hw::Feature::surface_bias) && test.receiver == Receiver::plane;
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
            const hw::Point p = unit(pixel_words(x, y, code, test));
            ReceiverPlane plane;
            if (has_plane && visible) plane = plane_of(observer, unit, test, x, y, p, limit);
            const std::uint8_t dark = darkness(map, p, d, taps, has_plane ? &plane : nullptr);
            if (dark == mask_lit || !visible) continue;  // background: transformed for nothing
            ++counts.shadowed;
            mask[a] = dark;
        }
    }
    return counts;
}

template PostProcessCounts post_process(const DepthMaps<hw::Depth16>&, const hw::MatrixWords&,
                                        const ShadowTest&, const PostProcessWork&,
                                        std::span<std::uint8_t>, std::int64_t);
template PostProcessCounts post_process(const DepthMaps<hw::Depth32>&, const hw::MatrixWords&,
                                        const ShadowTest&, const PostProcessWork&,
                                        std::span<std::uint8_t>, std::int64_t);

}  // namespace umbra78::shadow
