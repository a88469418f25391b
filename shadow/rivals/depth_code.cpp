#include "shadow/rivals/depth_code.hpp"

namespace umbra78::shadow::rivals {

DepthScale depth_scale(const raster::View& observer, const Space& space, int z_bits) {
    return {observer.near_depth, observer.far_depth, observer.extent,
            std::int64_t{1} << (space.xy_bits() - 1 + space.fraction()), z_bits};
}

// With m the plane's value at the pixel and e that at the eye, the depth in words is m / e seen
// from infinitely far, and D e / (e - m) from an eye at distance D.
PlaneCodes::PlaneCodes(const SeenPlane& plane, const Space& space, const DepthScale& scale)
    : deepest_(scale.deepest()) {
    const bool has_eye = space.eye().w != 0;
    const Sum size = std::int64_t{1} << scale.bits;
    const Sum range = Sum(scale.far - scale.near);
    Sum by_m, by_e, divisor;  // code = (by_m m + by_e e) / divisor
    if (has_eye) {
        const Sum reach = Sum(-std::int64_t{space.eye().z}) * scale.word_num;
        const Sum before = Sum(scale.near) * scale.word_den, times = size * scale.far;
        by_m = times * before;
        by_e = times * (reach - before);
        divisor = range * reach * plane.e;
    } else {
        by_m = size * scale.word_num;
        by_e = -(size * scale.near * scale.word_den);
        divisor = range * scale.word_den * plane.e;
    }
    const bool turned = divisor.is_negative();
    if (turned) by_m = -by_m, by_e = -by_e, divisor = -divisor;
    above_ = {by_m * plane.x * 2, by_m * plane.y * 2,
              (by_m * plane.c + by_e * plane.e) * 2 + divisor};
    divisor_ = divisor * 2;
}

std::uint32_t PlaneCodes::at(std::int32_t px, std::int32_t py) const {
    const Sum value = above_.value(px, py);
    if (value.is_negative()) return 0;
    if (value >= divisor_ * (std::int64_t{deepest_} + 1)) return deepest_;
    return static_cast<std::uint32_t>((value / divisor_).to_int64());
}

}  // namespace umbra78::shadow::rivals
