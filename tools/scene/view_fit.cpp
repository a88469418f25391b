#include "tools/scene/view_fit.hpp"

#include "fixed/wide_product.hpp"

#include <algorithm>
#include <limits>

namespace umbra78::tools {
namespace {

using fixed::Rounding;
using raster::World;

// Places in a view are Q.38: products of Q2.30 axes and Q.16 places, eight bits dropped, so that
// sums of the largest ones stay within 64 bits.
constexpr int place_fraction = 38;
constexpr int from_world = place_fraction - raster::world_fraction;

struct Place {
    std::int64_t side, depth;  // the larger of |x| and |y|, rounded up; along -back
};

std::int64_t along(const raster::Axis& axis, const World& from, const World& to) {
    return axis[0] * (std::int64_t{to.x} - from.x) + axis[1] * (std::int64_t{to.y} - from.y) +
           axis[2] * (std::int64_t{to.z} - from.z);
}

Place place(const raster::View& view, const World& point) {
    constexpr int dropped = 30 + raster::world_fraction - place_fraction;
    const auto q38 = [](std::int64_t q46, Rounding rounding) {
        return fixed::round_shift(q46, dropped, rounding);
    };
    const std::int64_t x = std::abs(along(view.axes.right, view.target, point));
    const std::int64_t y = std::abs(along(view.axes.up, view.target, point));
    const std::int64_t toward = along(view.axes.back, view.target, point);
    const bool perspective = view.projection == raster::Projection::perspective;
    const std::int64_t eye = perspective ? std::int64_t{view.distance} << from_world : 0;
    return {q38(std::max(x, y), Rounding::ceiling), eye - q38(toward, Rounding::half_even)};
}

// a / b > c / d, for numbers that are not negative.
bool greater(std::int64_t a, std::int64_t b, std::int64_t c, std::int64_t d) {
    const auto word = [](std::int64_t v) { return static_cast<std::uint64_t>(v); };
    const fixed::Word128 left = fixed::multiply_wide(word(a), word(d));
    const fixed::Word128 right = fixed::multiply_wide(word(c), word(b));
    return left.high != right.high ? left.high > right.high : left.low > right.low;
}

constexpr std::int32_t no_points_extent = std::int32_t{1} << raster::world_fraction;

std::int32_t clamp_to_word(std::int64_t v) {
    constexpr std::int64_t max = std::numeric_limits<std::int32_t>::max();
    return static_cast<std::int32_t>(std::clamp<std::int64_t>(v, 1, max));
}

}  // namespace

std::int32_t fitted_extent(const raster::View& view, const raster::ViewRanges& ranges) {
    if (ranges.right.min > ranges.right.max) return no_points_extent;
    const auto reach = [&](const raster::Axis& axis, const raster::AxisRange& range) {
        const std::int64_t target = raster::along(axis, view.target);
        return std::max(std::abs(range.min - target), std::abs(range.max - target));
    };
    const std::int64_t side = std::max(reach(view.axes.right, ranges.right),
                                       reach(view.axes.up, ranges.up));
    return clamp_to_word(fixed::round_shift(side, 30, Rounding::ceiling));
}

PerspectiveFit::PerspectiveFit(const raster::View& view) : view_(view) {}

void PerspectiveFit::add(const World& point) {
    any_ = true;
    const Place at = place(view_, point);
    if (at.depth <= 0 || !greater(at.side, at.depth, side_, depth_)) return;
    side_ = at.side;
    depth_ = at.depth;
}

std::int32_t PerspectiveFit::extent() const {
    if (!any_) return no_points_extent;
    const bool too_wide = greater(side_, depth_, 4, 1);
    const fixed::Rational slope = too_wide ? fixed::Rational(4) : fixed::Rational(side_, depth_);
    std::int64_t extent = 0;
    (slope * fixed::Rational(view_.distance)).round_scaled(0, Rounding::ceiling, extent);
    return clamp_to_word(extent);
}

std::int32_t fitted_extent(const raster::View& view, const Surfaces& surfaces) {
    if (view.projection == raster::Projection::perspective) {
        PerspectiveFit fit(view);
        surfaces.for_points([&](const World& p) { fit.add(p); });
        return fit.extent();
    }
    raster::ViewRanges ranges{view.axes};
    surfaces.for_points([&](const World& p) { ranges.add(p); });
    return fitted_extent(view, ranges);
}

Outside count_outside(const raster::View& view, const Surfaces& surfaces) {
    const bool perspective = view.projection == raster::Projection::perspective;
    Outside outside;
    bool window = false, depth = false;
    const auto look = [&](const World& point) {
        const Place at = place(view, point);
        window |= perspective
                      ? at.depth <= 0 || greater(at.side, at.depth, view.extent, view.distance)
                      : at.side > std::int64_t{view.extent} << from_world;
        const std::int64_t d = fixed::round_shift(at.depth, from_world, Rounding::half_even);
        depth |= d < view.near_depth || d > view.far_depth;
    };
    const auto count = [&] {
        outside.window += window;
        outside.depth += depth;
        window = depth = false;
    };
    for (const raster::Patch& patch : surfaces.patches) {
        for (const World& point : patch.control) look(point);
        count();
    }
    for (const raster::Facet& facet : surfaces.mesh.facets) {
        for (const std::uint32_t k : facet.vertex) look(surfaces.mesh.vertices[k]);
        count();
    }
    return outside;
}

}  // namespace umbra78::tools
