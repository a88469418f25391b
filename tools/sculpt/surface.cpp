#include "tools/sculpt/surface.hpp"

#include <utility>

namespace umbra78::tools {
namespace {

std::array<double, 4> bernstein(double t) {
    const double s = 1 - t;
    return {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
}

std::size_t cubics(const Chain& chain) { return (chain.size() - 1) / 3; }

// A direction of length 1 at right angles to `along`.
Point beside(Point along) {
    const Point axis = std::abs(along.y) < 0.9 ? Point{0, 1, 0} : Point{0, 0, 1};
    return unit(cross(axis, along));
}

Point reflected(Point direction, Point normal) {
    return direction - 2 * dot(direction, normal) / dot(normal, normal) * normal;
}

}  // namespace

Point at(const Net& net, double u, double v) {
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

namespace {

// A place on the path with the direction and curvature there, and the circle's axes.
struct Station {
    Point place, speed, curvature, across, up;
};

Station station(Point place, Point speed, Point acceleration) {
    const double square = dot(speed, speed);
    const Point bend = acceleration - dot(acceleration, speed) / square * speed;
    return {place, speed, 1 / square * bend, {}, {}};
}

Point carried(Point axis, const Station& from, const Station& to) {
    const Point way = to.place - from.place;
    const Point turned = reflected(unit(from.speed), way);
    const Point rest = unit(to.speed) - turned;
    const Point once = reflected(axis, way);
    return dot(rest, rest) < 1e-20 ? once : reflected(once, rest);
}

// One row of a net: the circle's control points at a station, moved by `t` along the sweep.
void sweep_row(Point* row, const Station& s, const Chain& circle, std::size_t first, double radius,
               double growth, double t) {
    for (std::size_t i = 0; i < 4; ++i) {
        const Point c = circle[first + i];
        const Point out = c.x * s.across + c.z * s.up;
        const Point rate = (1 - radius * dot(out, s.curvature)) * s.speed + growth * out;
        row[i] = s.place + radius * out + t * rate;
    }
}

}  // namespace

Surface tube(const Chain& path, const std::vector<double>& radii, int arcs) {
    const Chain section = circle(arcs);
    Surface surface;
    Point across = beside(unit(path[1] - path[0]));
    for (std::size_t q = 0; q < cubics(path); ++q) {
        const Point *p = &path[3 * q];
        Station a = station(p[0], 3 * (p[1] - p[0]), 6 * (p[2] - 2 * p[1] + p[0]));
        Station b = station(p[3], 3 * (p[3] - p[2]), 6 * (p[3] - 2 * p[2] + p[1]));
        a.across = across;
        b.across = across = carried(across, a, b);
        a.up = cross(a.across, unit(a.speed));
        b.up = cross(b.across, unit(b.speed));
        const double growth = radii[q + 1] - radii[q];
        for (std::size_t k = 0; k < cubics(section); ++k) {
            Net net;
            sweep_row(&net[0], a, section, 3 * k, radii[q], growth, 0);
            sweep_row(&net[4], a, section, 3 * k, radii[q], growth, 1. / 3);
            sweep_row(&net[8], b, section, 3 * k, radii[q + 1], growth, -1. / 3);
            sweep_row(&net[12], b, section, 3 * k, radii[q + 1], growth, 0);
            surface.push_back(net);
        }
    }
    return surface;
}

Surface ellipsoid(double half_x, double half_y, double half_z, int arcs) {
    const Chain half = Pen(0, -1).bend(1, -1, 1, 0).bend(1, 1, 0, 1);
    return placed(lathe(half, circle(arcs)), {{}, {}, {half_x, half_y, half_z}});
}

Surface rounded_box(double half_x, double half_y, double half_z, double handle) {
    const Chain half = Pen(0, -1).bend(1, -1, 1, 0, handle).bend(1, 1, 0, 1, handle);
    return placed(lathe(half, rounded_square(handle)), {{}, {}, {half_x, half_y, half_z}});
}

Surface button(double radius, double height, double edge, int arcs) {
    const double flat = radius - edge, side = height - edge;
    return lathe(Pen(radius, 0).line(radius, side).bend(radius, height, flat, height)
                     .line(0, height), circle(arcs));
}

Surface ring(double radius, double thickness, int arcs) {
    return tube(arc({}, {1, 0, 0}, {0, 0, 1}, radius, 360, arcs),
                std::vector<double>(static_cast<std::size_t>(arcs) + 1, thickness));
}

Surface limb(Point from, Point to, double radius_from, double radius_to) {
    const double a = radius_from, b = radius_to, far = length(to - from);
    return along(lathe(Pen(0, -a).bend(a, -a, a, 0).line(b, far).bend(b, far + b, 0, far + b),
                       circle(4)), from, to);
}

}  // namespace umbra78::tools
