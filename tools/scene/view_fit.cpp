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

std::int32_t clamp_to_word(std::int64_t v) {
    constexpr std::int64_t max = std::numeric_limits<std::int32_t>::max();
    return static_cast<std::int32_t>(std::clamp<std::int64_t>(v, 1, max));
}

}  // namespace

World box_centre(const Surfaces& surfaces) {
    constexpr std::int32_t low = std::numeric_limits<std::int32_t>::min();
    constexpr std::int32_t high = std::numeric_limits<std::int32_t>::max();
    World min{high, high, high}, max{low, low, low};
    surfaces.for_points([&](const World& p) {
        min = {std::min(min.x, p.x), std::min(min.y, p.y), std::min(min.z, p.z)};
        max = {std::max(max.x, p.x), std::max(max.y, p.y), std::max(max.z, p.z)};
    });
    if (min.x > max.x) return {};
    const auto middle = [](std::int64_t a, std::int64_t b) {
        return static_cast<std::int32_t>(fixed::round_shift(a + b, 1, Rounding::floor));
    };
    return {middle(min.x, max.x), middle(min.y, max.y), middle(min.z, max.z)};
}

std::int32_t fitted_extent(const raster::View& view, const Surfaces& surfaces) {
    if (surfaces.empty()) return std::int32_t{1} << raster::world_fraction;
    if (view.projection == raster::Projection::orthographic) {
        std::int64_t side = 0;
        surfaces.for_points([&](const World& p) { side = std::max(side, place(view, p).side); });
        return clamp_to_word(fixed::round_shift(side, from_world, Rounding::ceiling));
    }
    Place steepest{0, 1};
    surfaces.for_points([&](const World& p) {
        const Place at = place(view, p);
        if (at.depth > 0 && greater(at.side, at.depth, steepest.side, steepest.depth))
            steepest = at;
    });
    if (greater(steepest.side, steepest.depth, 4, 1)) steepest = {4, 1};
    std::int64_t extent = 0;
    const fixed::Rational slope(steepest.side, steepest.depth);
    (slope * fixed::Rational(view.distance)).round_scaled(0, Rounding::ceiling, extent);
    return clamp_to_word(extent);
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
