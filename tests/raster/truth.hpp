// Truth for the rasterizer's tests, in double precision: where a sphere is on the screen.
#pragma once

#include "tests/support/drawing.hpp"

#include <array>
#include <cmath>
#include <optional>

namespace umbra78::raster::test {

using Vector3 = std::array<double, 3>;

inline double dot3(const Vector3& a, const Vector3& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Vector3 along(const Vector3& a, double s, const Vector3& b) {
    return {a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]};
}
inline Vector3 unit3(const Vector3& a) { return along({}, 1 / std::sqrt(dot3(a, a)), a); }

inline Vector3 axis3(const Axis& a) {
    const double q30 = 1 << 30;
    return {a[0] / q30, a[1] / q30, a[2] / q30};
}
inline Vector3 world3(const World& w) { return {w.x / 65536.0, w.y / 65536.0, w.z / 65536.0}; }

// Rays of a view's screen places, in pixels from the centre, y down.
struct Camera {
    Camera(const View& v, const MachineSpec& spec)
        : view(v), half_px(spec.half_px()), right(axis3(v.axes.right)), up(axis3(v.axes.up)),
          back(axis3(v.axes.back)), target(world3(v.target)), extent(v.extent / 65536.0),
          distance(v.distance / 65536.0), near(static_cast<double>(v.near_depth) / 65536),
          far(static_cast<double>(v.far_depth) / 65536) {}

    const View& view;
    double half_px;
    Vector3 right, up, back, target;
    double extent, distance, near, far;

    bool is_perspective() const { return view.projection == Projection::perspective; }
    Vector3 eye() const { return along(target, distance, back); }

    struct Ray {
        Vector3 origin, direction;
    };
    Ray ray(double x, double y) const {
        const double scale = extent / half_px;
        const Vector3 at = along(along(target, x * scale, right), -y * scale, up);
        if (is_perspective()) return {eye(), unit3(along(at, -1, eye()))};
        return {along(at, 1000, back), {-back[0], -back[1], -back[2]}};
    }
    // The Z code, with its fraction, of a world point.
    double code(const Vector3& p, const MachineSpec& spec) const {
        const Vector3 from = is_perspective() ? eye() : target;
        const double d = -dot3(back, along(p, -1, from));
        const double z = is_perspective()
                             ? ((far + near) * d - 2 * far * near) / ((far - near) * d)
                             : 2 * (d - near) / (far - near) - 1;
        return (z + 1) * static_cast<double>(spec.depth_offset());
    }
};

// The nearest point of the sphere on the ray, if it hits.
inline std::optional<Vector3> hit(const Camera::Ray& r, const Sphere& s) {
    const Vector3 to = along(world3(s.centre), -1, r.origin);
    const double b = dot3(to, r.direction), radius = s.radius / 65536.0;
    const Vector3 miss = along(to, -b, r.direction);
    const double under = radius * radius - dot3(miss, miss);
    if (under < 0) return std::nullopt;
    return along(r.origin, b - std::sqrt(under), r.direction);
}

// How the disc of `margin` pixels about a place lies to the sphere's outline.
enum class Lies { inside, outside, across };
inline Lies disc_lies(const Camera& camera, const Sphere& s, double x, double y, double margin) {
    int hits = 0;
    constexpr int steps = 8;
    for (int k = 0; k < steps; ++k) {
        const double angle = k * (2 * 3.14159265358979 / steps);
        hits += hit(camera.ray(x + margin * std::cos(angle), y + margin * std::sin(angle)), s)
                    ? 1 : 0;
    }
    if (hits == steps) return Lies::inside;
    return hits == 0 && !hit(camera.ray(x, y), s) ? Lies::outside : Lies::across;
}

}  // namespace umbra78::raster::test
