// Points and directions of models in double precision, and where a part stands.
//
// x right, y up, z toward an observer at azimuth 0, as in a scene. Angles are degrees.
#pragma once

#include <cmath>
#include <numbers>

namespace umbra78::tools {

struct Point {
    double x = 0, y = 0, z = 0;

    constexpr bool operator==(const Point&) const = default;
};

constexpr Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
constexpr Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
constexpr Point operator*(double s, Point a) { return {s * a.x, s * a.y, s * a.z}; }
constexpr double dot(Point a, Point b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr Point cross(Point a, Point b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(Point a) { return std::sqrt(dot(a, a)); }
inline Point unit(Point a) { return 1 / length(a) * a; }

// A direction of length 1 at right angles to one of length 1.
Point beside(Point along);

constexpr double radians(double degrees) { return degrees * std::numbers::pi / 180; }

// A part is scaled along its axes, turned about x, then y, then z, and then moved.
struct Placement {
    Point place{};
    Point turn{};
    Point scale{1, 1, 1};
};

Point placed(Point, const Placement&);

}  // namespace umbra78::tools
