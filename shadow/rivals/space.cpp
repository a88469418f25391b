#include "shadow/rivals/space.hpp"

#include "fixed/divide.hpp"

namespace umbra78::shadow::rivals {
namespace {

using fixed::Rounding;
using raster::WideVector;

WideVector wide(const raster::Axis& a) { return {a[0], a[1], a[2]}; }

// The eye of a view in perspective, from the world's origin: world words, rounded half even.
WideVector eye_of(const raster::View& v) {
    WideVector eye{v.target.x, v.target.y, v.target.z};
    for (std::size_t k = 0; k < 3; ++k)
        eye[k] += raster::axis_product(v.axes.back[k], v.distance);
    return eye;
}

}  // namespace

ToWords::ToWords(const raster::View& observer, int xy_bits, int fraction)
    : observer_(observer), xy_bits_(xy_bits), fraction_(fraction) {
    fixed::require(xy_bits >= 1 && fraction >= 1 && xy_bits + fraction <= word_bits,
                   "rival space: a fraction outside 1..22 - n");
}

// `along` has the fraction bits of a world word and of an axis.
bool ToWords::word(std::int64_t along, std::int32_t& out) const {
    const int shift = xy_bits_ - 1 + fraction_ - raster::axis_fraction;
    const fixed::Quotient q =
        fixed::divide(along, observer_.extent, shift, word_bits + 2, Rounding::half_even);
    if (q.status != fixed::DivideStatus::ok || q.value > max_word || q.value < -max_word)
        return false;
    out = static_cast<std::int32_t>(q.value);
    return true;
}

bool ToWords::words(const WideVector& d, Point& out) const {
    const raster::ViewAxes& axes = observer_.axes;
    return word(raster::dot(wide(axes.right), d), out.x) &&
           word(-raster::dot(wide(axes.up), d), out.y) &&
           word(-raster::dot(wide(axes.back), d), out.z);
}

bool ToWords::point(const raster::World& p, Point& out) const {
    const raster::World& t = observer_.target;
    return words({std::int64_t{p.x} - t.x, std::int64_t{p.y} - t.y, std::int64_t{p.z} - t.z}, out);
}

bool ToWords::light(const raster::View& light, Centre& out) const {
    if (raster::has_eye(light)) {
        const raster::World& t = observer_.target;
        const WideVector eye = eye_of(light);
        Point p{};
        if (!words({eye[0] - t.x, eye[1] - t.y, eye[2] - t.z}, p)) return false;
        out = {p.x, p.y, p.z, 1};
        return true;
    }
    const auto along = [&](const raster::Axis& axis) {
        const std::int64_t product = raster::dot(wide(axis), wide(light.axes.back));
        return static_cast<std::int32_t>(fixed::round_shift(
            product, 2 * raster::axis_fraction - direction_fraction, Rounding::half_even));
    };
    const raster::ViewAxes& axes = observer_.axes;
    out = {along(axes.right), -along(axes.up), -along(axes.back), 0};
    return true;
}

bool ToWords::space(Space& out) const {
    Centre eye{0, 0, -1, 0};
    if (raster::has_eye(observer_)) {
        std::int32_t distance = 0;
        if (!word(std::int64_t{observer_.distance} << raster::axis_fraction, distance))
            return false;
        eye = {0, 0, -distance, 1};
    }
    out = Space(xy_bits_, fraction_, eye);
    return true;
}

SpaceStatus fit_fraction(const raster::View& observer, int xy_bits,
                         const raster::Surfaces& surfaces, std::span<const raster::View> lights,
                         int& fraction) {
    for (fraction = word_bits - xy_bits; fraction >= 1; --fraction) {
        const ToWords to(observer, xy_bits, fraction);
        Space space;
        Centre centre{};
        Point p{};
        bool fits = to.space(space);
        for (const raster::View& l : lights) fits = fits && to.light(l, centre);
        surfaces.for_points([&](const raster::World& w) { fits = fits && to.point(w, p); });
        if (fits) return SpaceStatus::ok;
    }
    return SpaceStatus::too_wide;
}

}  // namespace umbra78::shadow::rivals
