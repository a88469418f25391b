#include "tools/scene/visible_depths.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace umbra78::tools {
namespace {

constexpr int deepest_level = 48;   // halvings
constexpr double small_part = 1.0 / 32;

// In the view: x and y over the half width of the window at depth 1 (orthographic: at any depth).
struct Point {
    double x, y, depth;
};
using Net = std::array<Point, 16>;

Point middle(const Point& a, const Point& b) {
    return {(a.x + b.x) / 2, (a.y + b.y) / 2, (a.depth + b.depth) / 2};
}

// Halves four control points that stand `step` apart from `at` on.
void halve_row(const Net& whole, Net& low, Net& high, std::size_t at, std::size_t step) {
    const Point &a = whole[at], &b = whole[at + step], &c = whole[at + 2 * step],
                &d = whole[at + 3 * step];
    const Point ab = middle(a, b), bc = middle(b, c), cd = middle(c, d);
    const Point abc = middle(ab, bc), bcd = middle(bc, cd), centre = middle(abc, bcd);
    low[at] = a, low[at + step] = ab, low[at + 2 * step] = abc, low[at + 3 * step] = centre;
    high[at] = centre, high[at + step] = bcd, high[at + 2 * step] = cd, high[at + 3 * step] = d;
}

class Window {
public:
    explicit Window(const raster::View& view)
        : view_(view), perspective_(view.projection == raster::Projection::perspective),
          near_(q16(view.near_depth)), far_(q16(view.far_depth)) {}

    CutDepths cut(const Surfaces& surfaces) {
        const auto count = [&](const Net& net) {
            before_ = behind_ = false;
            look(net, 0);
            cut_.before += before_;
            cut_.behind += behind_;
        };
        for (const raster::Patch& patch : surfaces.patches) count(net_of(patch));
        for (const raster::Facet& facet : surfaces.mesh.facets)
            count(net_of(facet, surfaces.mesh));
        return cut_;
    }

private:
    static double q16(std::int64_t word) { return std::ldexp(static_cast<double>(word), -16); }

    Point seen(const raster::World& p) const {
        const auto dot = [&](const raster::Axis& axis) {
            return std::ldexp(static_cast<double>(axis[0]) * (p.x - double(view_.target.x)) +
                              static_cast<double>(axis[1]) * (p.y - double(view_.target.y)) +
                              static_cast<double>(axis[2]) * (p.z - double(view_.target.z)), -46);
        };
        const double half = q16(view_.extent) / (perspective_ ? q16(view_.distance) : 1);
        return {dot(view_.axes.right) / half, dot(view_.axes.up) / half,
                (perspective_ ? q16(view_.distance) : 0) - dot(view_.axes.back)};
    }
    Net net_of(const raster::Patch& patch) const {
        Net net;
        for (std::size_t k = 0; k < net.size(); ++k) net[k] = seen(patch.control[k]);
        return net;
    }
    Net net_of(const raster::Facet& facet, const raster::Mesh& mesh) const {
        std::array<Point, 3> corner;
        for (std::size_t k = 0; k < 3; ++k) corner[k] = seen(mesh.vertices[facet.vertex[k]]);
        const auto between = [](const Point& a, const Point& b, std::size_t third) {
            const double t = static_cast<double>(third) / 3;
            return Point{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y),
                         a.depth + t * (b.depth - a.depth)};
        };
        Net net;
        for (std::size_t k = 0; k < net.size(); ++k)
            net[k] = between(between(corner[0], corner[1], k % 4), corner[2], k / 4);
        return net;
    }

    double width(const Point& p) const { return perspective_ ? p.depth : 1; }
    bool shows(const Point& p) const {
        return std::abs(p.x) <= width(p) && std::abs(p.y) <= width(p) &&
               (!perspective_ || p.depth > 0);
    }
    // Whether a side of the window, or the eye's plane, has all of the hull beyond it.
    bool beside(const Net& net) const {
        const auto all = [&](auto beyond) { return std::all_of(net.begin(), net.end(), beyond); };
        return all([&](const Point& p) { return p.x > width(p); }) ||
               all([&](const Point& p) { return -p.x > width(p); }) ||
               all([&](const Point& p) { return p.y > width(p); }) ||
               all([&](const Point& p) { return -p.y > width(p); }) ||
               (perspective_ && all([](const Point& p) { return p.depth <= 0; }));
    }

    void look(const Net& net, int level) {
        const auto [first, last] = std::minmax_element(
            net.begin(), net.end(),
            [](const Point& a, const Point& b) { return a.depth < b.depth; });
        // Fitted depths are rounded by a word or two.
        const double slack = 1e-9 * (std::abs(near_) + std::abs(far_)) + std::ldexp(4, -16);
        const bool before = first->depth < near_ - slack, behind = last->depth > far_ + slack;
        const bool known = (!before || (before_ && first->depth >= cut_.nearest)) &&
                           (!behind || (behind_ && last->depth <= cut_.farthest));
        if (known || beside(net)) return;
        for (const std::size_t corner : {0u, 3u, 12u, 15u}) {
            const Point& p = net[corner];
            if (!shows(p)) continue;
            if (p.depth < near_ - slack) {
                before_ = true;
                cut_.nearest = std::min(cut_.nearest, p.depth);
            }
            if (p.depth > far_ + slack) {
                behind_ = true;
                cut_.farthest = std::max(cut_.farthest, p.depth);
            }
        }
        if (level == deepest_level || is_small(net, first->depth, last->depth)) return;
        Net low, high;
        for (std::size_t k = 0; k < 4; ++k) {
            if (level % 2 == 0) halve_row(net, low, high, 4 * k, 1);
            else halve_row(net, low, high, k, 4);
        }
        look(low, level + 1);
        look(high, level + 1);
    }

    bool is_small(const Net& net, double first, double last) const {
        const double wide = 2 * (perspective_ ? std::max(first, 0.0) : 1) * small_part;
        const auto [left, right] = std::minmax_element(
            net.begin(), net.end(), [](const Point& a, const Point& b) { return a.x < b.x; });
        const auto [low, high] = std::minmax_element(
            net.begin(), net.end(), [](const Point& a, const Point& b) { return a.y < b.y; });
        return right->x - left->x <= wide && high->y - low->y <= wide &&
               (!perspective_ || last - first <= first * small_part);
    }

    const raster::View& view_;
    bool perspective_;
    double near_, far_;
    CutDepths cut_;
    bool before_ = false, behind_ = false;  // of the current patch or facet
};

}  // namespace

CutDepths cut_depths(const raster::View& view, const Surfaces& surfaces) {
    return Window(view).cut(surfaces);
}

}  // namespace umbra78::tools
