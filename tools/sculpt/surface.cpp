#include "tools/sculpt/surface.hpp"

#include <utility>

namespace umbra78::tools {
namespace {

std::array<double, 4> bernstein(double t) {
    const double s = 1 - t;
    return {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
}

}  // namespace

Point point_on(const Net& net, double u, double v) {
    const auto a = bernstein(u), b = bernstein(v);
    Point sum;
    for (std::size_t j = 0; j < 4; ++j)
        for (std::size_t i = 0; i < 4; ++i) sum = sum + a[i] * b[j] * net[4 * j + i];
    return sum;
}

Surface lathe(const Chain& profile, const Chain& section) {
    Surface surface;
    for (std::size_t q = 0; q < cubics(profile); ++q)
        for (std::size_t p = 0; p < cubics(section); ++p) {
            Net net;
            for (std::size_t j = 0; j < 4; ++j)
                for (std::size_t i = 0; i < 4; ++i) {
                    const Point edge = profile[3 * q + j], around = section[3 * p + i];
                    net[4 * j + i] = {edge.x * around.x, edge.y, edge.x * around.z};
                }
            surface.push_back(net);
        }
    return surface;
}

Surface loft(const std::vector<Chain>& sections) {
    std::vector<Chain> columns;  // one along each control point of the sections
    for (std::size_t i = 0; i < sections[0].size(); ++i) {
        std::vector<Point> points;
        for (const Chain& section : sections) points.push_back(section[i]);
        columns.push_back(through(points));
    }
    Surface surface;
    for (std::size_t q = 0; q + 1 < sections.size(); ++q)
        for (std::size_t p = 0; p < cubics(sections[0]); ++p) {
            Net net;
            for (std::size_t j = 0; j < 4; ++j)
                for (std::size_t i = 0; i < 4; ++i)
                    net[4 * j + i] = columns[3 * p + i][3 * q + j];
            surface.push_back(net);
        }
    return surface;
}

Surface placed(Surface surface, const Placement& where) {
    for (Net& net : surface)
        for (Point& point : net) point = placed(point, where);
    return surface;
}

Surface mirrored(Surface surface) { return placed(std::move(surface), {{}, {}, {-1, 1, 1}}); }

Surface along(Surface surface, Point from, Point to) {
    const Point y = unit(to - from), x = beside(y), z = cross(x, y);
    for (Net& net : surface)
        for (Point& p : net) p = from + p.x * x + p.y * y + p.z * z;
    return surface;
}

Surface joined(std::vector<Surface> surfaces) {
    Surface all;
    for (const Surface& each : surfaces) all.insert(all.end(), each.begin(), each.end());
    return all;
}

}  // namespace umbra78::tools
