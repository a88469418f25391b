// A circle swept along a path.
#include "tools/sculpt/surface.hpp"

#include <array>
#include <cmath>
#include <numbers>

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

// About a direction of length 1, right-handed; the axis is at right angles to it.
Point turned(Point axis, Point along, double angle) {
    return std::cos(angle) * axis + std::sin(angle) * cross(along, axis);
}

// The two ends of a cubic of the path.
std::array<Station, 2> stations(const Point* p) {
    return {station(p[0], 3 * (p[1] - p[0]), 6 * (p[2] - 2 * p[1] + p[0])),
            station(p[3], 3 * (p[3] - p[2]), 6 * (p[3] - 2 * p[2] + p[1]))};
}

// By which angle the circle, carried once round a closed path, misses the arcs it set out with: at
// most half an arc.
double gap(const Chain& path, Point across, int arcs) {
    const Point along = unit(path[1] - path[0]);
    if (length(path.back() - path.front()) > 1e-9 ||
        length(unit(path.back() - path[path.size() - 2]) - along) > 1e-9)
        return 0;
    Point last = across;
    for (std::size_t q = 0; q < cubics(path); ++q) {
        const auto [a, b] = stations(&path[3 * q]);
        last = carried(last, a, b);
    }
    const double angle = std::atan2(dot(cross(last, across), along), dot(last, across));
    const double arc = 2 * std::numbers::pi / arcs;
    return angle - arc * std::round(angle / arc);
}

// How the circle changes over one cubic: its radius, and its turn about the path.
struct Change {
    double growth, turn;
};

// One row of a net: the circle's control points at a station, moved by `t` along the sweep.
void sweep_row(Point* row, const Station& s, const Chain& circle, std::size_t first, double radius,
               Change change, double t) {
    for (std::size_t i = 0; i < 4; ++i) {
        const Point c = circle[first + i];
        const Point out = c.x * s.across + c.z * s.up;
        const Point rate = (1 - radius * dot(out, s.curvature)) * s.speed +
                           change.growth * out + change.turn * radius * cross(unit(s.speed), out);
        row[i] = s.place + radius * out + t * rate;
    }
}

}  // namespace

Surface tube(const Chain& path, const std::vector<double>& radii, int arcs) {
    const Chain section = circle(arcs);
    Surface surface;
    Point across = beside(unit(path[1] - path[0]));
    const double turn = gap(path, across, arcs) / static_cast<double>(cubics(path));
    for (std::size_t q = 0; q < cubics(path); ++q) {
        auto [a, b] = stations(&path[3 * q]);
        a.across = across;
        b.across = across = turned(carried(across, a, b), unit(b.speed), turn);
        a.up = cross(a.across, unit(a.speed));
        b.up = cross(b.across, unit(b.speed));
        const Change change{radii[q + 1] - radii[q], turn};
        for (std::size_t k = 0; k < cubics(section); ++k) {
            Net net;
            sweep_row(&net[0], a, section, 3 * k, radii[q], change, 0);
            sweep_row(&net[4], a, section, 3 * k, radii[q], change, 1. / 3);
            sweep_row(&net[8], b, section, 3 * k, radii[q + 1], change, -1. / 3);
            sweep_row(&net[12], b, section, 3 * k, radii[q + 1], change, 0);
            surface.push_back(net);
        }
    }
    return surface;
}

}  // namespace umbra78::tools
