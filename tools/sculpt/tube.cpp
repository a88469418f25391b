// A circle swept along a path.
#include "tools/sculpt/surface.hpp"

namespace umbra78::tools {
namespace {

Point reflected(Point direction, Point normal) {
    return direction - 2 * dot(direction, normal) / dot(normal, normal) * normal;
}

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
        const Point* p = &path[3 * q];
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

}  // namespace umbra78::tools
