#include "tools/truth/truth.hpp"

#include "tools/truth/real3.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace umbra78::tools {
namespace {

// Columns and rows that may show a surface, ends excluded.
struct PixelBox {
    int left, right, top, bottom;
};

// The pixels whose centres may lie in the picture of the corners' convex hull.
PixelBox box_of(const TruthView& view, std::span<const Real3> corners) {
    double low[2] = {infinity, infinity}, high[2] = {-infinity, -infinity};
    for (const Real3& corner : corners) {
        const Real3 seen = view.project(corner);
        if (view.perspective && seen[2] <= 0) return {0, view.size, 0, view.size};
        for (int axis = 0; axis < 2; ++axis) {
            low[axis] = std::min(low[axis], seen[axis]);
            high[axis] = std::max(high[axis], seen[axis]);
        }
    }
    const auto inside = [&](double at) {
        return static_cast<int>(std::clamp(at, 0.0, static_cast<double>(view.size)));
    };
    return {inside(std::floor(low[0]) - 1), inside(std::ceil(high[0]) + 1),
            inside(std::floor(low[1]) - 1), inside(std::ceil(high[1]) + 1)};
}

// The view-aligned cube around the sphere.
PixelBox box_of(const TruthView& view, const TruthSphere& sphere) {
    std::array<Real3, 8> corners;
    for (int i = 0; i < 8; ++i) {
        corners[i] = sphere.centre;
        for (int axis = 0; axis < 3; ++axis) {
            const double side = (i >> axis & 1) ? sphere.radius : -sphere.radius;
            corners[i] = along(corners[i], side, view.rotation[axis]);
        }
    }
    return box_of(view, corners);
}

PixelBox box_of(const TruthView& view, const TruthPlane& plane) {
    const Real3 a = along(plane.origin, 1, plane.u), b = along(plane.origin, 1, plane.v);
    return box_of(view, std::array{plane.origin, a, b, along(a, 1, plane.v)});
}

// Keeps at each pixel the nearest surface within near .. far; the lower number wins a tie.
// `nearest(ray)` is the first depth within near .. far at which the ray meets it, or infinity.
template <class Nearest>
void draw(Truth& truth, const TruthView& view, int surface, const PixelBox& box,
          Nearest nearest) {
    for (int row = box.top; row < box.bottom; ++row) {
        for (int column = box.left; column < box.right; ++column) {
            const double depth = nearest(view.ray(column + 0.5, row + 0.5));
            const std::size_t at = static_cast<std::size_t>(row) * view.size + column;
            if (depth < truth.depth[at]) {
                truth.depth[at] = depth;
                truth.surface[at] = surface;
            }
        }
    }
}

// Of the angle between a unit normal and a direction of any length.
double cosine(const Real3& unit_normal, const Real3& direction) {
    return dot(unit_normal, direction) / length(direction);
}

Real3 unit_normal(const TruthScene& scene, int surface, const Real3& at, const Real3& sight) {
    const int spheres = static_cast<int>(scene.spheres.size());
    if (surface < spheres) {
        const TruthSphere& sphere = scene.spheres[surface];
        const Real3 outward = times(1 / sphere.radius, minus(at, sphere.centre));
        return dot(outward, sight) > 0 ? times(-1, outward) : outward;
    }
    const TruthPlane& plane = scene.planes[surface - spheres];
    const Real3 normal = cross(plane.u, plane.v);
    return times((dot(normal, sight) > 0 ? -1 : 1) / length(normal), normal);
}

}  // namespace

Ray TruthView::ray(double column, double row) const {
    const double x = (column - 0.5 * size) * pixel(), y = (0.5 * size - row) * pixel();
    const auto& [right, up, back] = rotation;
    const Real3 on_target_plane = along(along(target, x, right), y, up);
    if (!perspective) return {on_target_plane, times(-1, back)};
    const Real3 eye = along(target, distance, back);
    return {eye, times(1 / distance, minus(on_target_plane, eye))};
}

Real3 TruthView::project(const Real3& world) const {
    const auto& [right, up, back] = rotation;
    const Real3 from_target = minus(world, target);
    const double depth = (perspective ? distance : 0) - dot(from_target, back);
    const double scale = (perspective ? distance / depth : 1) / pixel();
    return {0.5 * size + scale * dot(from_target, right),
            0.5 * size - scale * dot(from_target, up), depth};
}

TruthLight TruthLight::point_of_area(int i, int j) const {
    const auto along_side = [&](int k) { return (k + 0.5) / points_a_side - 0.5; };
    return {true, direction,
            along(along(position, along_side(i), side_u), along_side(j), side_v)};
}

Ray TruthLight::ray(const Real3& from) const {
    return {from, point ? minus(position, from) : direction};
}

// |o + t d|^2 = r^2 with o from the centre:  (d.d) t^2 + 2 (o.d) t + (o.o - r^2) = 0.
std::optional<std::array<double, 2>> crossings(const TruthSphere& sphere, const Ray& ray) {
    const Real3 o = minus(ray.origin, sphere.centre);
    const double a = dot(ray.direction, ray.direction), b = dot(o, ray.direction);
    const double c = dot(o, o) - sphere.radius * sphere.radius;
    const double discriminant = b * b - a * c;
    if (discriminant < 0) return std::nullopt;
    const double root = std::sqrt(discriminant);
    return std::array{(-b - root) / a, (-b + root) / a};
}

// Cramer's rule for  s u + t v - k d = o,  o from the plane's origin.
std::optional<PlaneCrossing> crossing(const TruthPlane& plane, const Ray& ray) {
    const Real3 normal = cross(plane.u, plane.v), o = minus(ray.origin, plane.origin);
    const double slope = dot(normal, ray.direction);
    if (slope == 0) return std::nullopt;
    const Real3 od = cross(o, ray.direction);
    const double s = -dot(plane.v, od) / slope, t = dot(plane.u, od) / slope;
    return PlaneCrossing{-dot(normal, o) / slope, s >= 0 && s <= 1 && t >= 0 && t <= 1};
}

bool blocked(const TruthScene& scene, const Ray& ray, double from, double to, int ignoring) {
    const auto between = [&](double t) { return t > from && t < to; };
    int surface = 0;
    for (const TruthSphere& sphere : scene.spheres) {
        if (surface++ == ignoring) continue;
        const auto hit = crossings(sphere, ray);
        if (hit && (between((*hit)[0]) || between((*hit)[1]))) return true;
    }
    for (const TruthPlane& plane : scene.planes) {
        if (surface++ == ignoring) continue;
        const auto hit = crossing(plane, ray);
        if (hit && hit->inside && between(hit->t)) return true;
    }
    return false;
}

double last_crossing(const TruthScene& scene, const Ray& ray, double to) {
    double last = 0;
    const auto meet = [&](double t) {
        if (t > last && t < to) last = t;
    };
    for (const TruthSphere& sphere : scene.spheres)
        if (const auto hit = crossings(sphere, ray))
            for (const double t : *hit) meet(t);
    for (const TruthPlane& plane : scene.planes)
        if (const auto hit = crossing(plane, ray); hit && hit->inside) meet(hit->t);
    return last;
}

bool seen_from_inside(const TruthScene& scene, int surface, const Real3& at, const Real3& normal) {
    if (surface >= static_cast<int>(scene.spheres.size())) return false;
    return dot(normal, minus(at, scene.spheres[surface].centre)) < 0;
}

bool left_through_itself(const TruthScene& scene, int surface, const Real3& normal, const Ray& ray,
                         double to) {
    if (!seen_from_inside(scene, surface, ray.origin, normal)) return false;
    const auto hit = crossings(scene.spheres[surface], ray);
    return hit && (*hit)[1] < to;
}

bool occluded(const Real3& point, const TruthLight& light, const TruthScene& scene,
              int ignoring) {
    return blocked(scene, light.ray(point), 0, light.reach(), ignoring);
}

Truth::Truth(int size_px) : size(size_px) {
    const std::size_t pixels = static_cast<std::size_t>(size) * size;
    visible.resize(pixels);
    lit.resize(pixels);
    surface.resize(pixels, no_surface);
    depth.resize(pixels, infinity);
    position.resize(pixels);
    normal.resize(pixels);
    n_dot_l.resize(pixels);
    behind.resize(pixels);
}

void Truth::measure_area(const TruthLight& light) {
    if (!light.has_area()) return;
    points = light.points_a_side * light.points_a_side;
    seen.resize(visible.size());
}

void Truth::see_area(std::size_t at, int points_of_it) {
    seen[at] = static_cast<std::uint16_t>(points_of_it);
    lit[at] = 2 * points_of_it >= points;
}

void Truth::see(std::size_t at, int surface_seen, double depth_seen, const Real3& where,
                const Real3& unit_normal, const TruthLight& light) {
    visible[at] = 1;
    surface[at] = surface_seen;
    depth[at] = depth_seen;
    position[at] = where;
    normal[at] = unit_normal;
    n_dot_l[at] = cosine(unit_normal, light.ray(where).direction);
}

double depth_of(const TruthScene& scene, int surface, const TruthView& view, const Ray& ray) {
    const auto seen = [&](double t) { return t >= view.near_depth && t <= view.far_depth; };
    const int spheres = static_cast<int>(scene.spheres.size());
    if (surface < spheres) {
        const auto hit = crossings(scene.spheres[surface], ray);
        if (!hit) return infinity;
        return seen((*hit)[0]) ? (*hit)[0] : seen((*hit)[1]) ? (*hit)[1] : infinity;
    }
    const auto hit = crossing(scene.planes[surface - spheres], ray);
    return hit && hit->inside && seen(hit->t) ? hit->t : infinity;
}

// A surface that faces the light does not stand in its own way, except a sphere that is seen from
// inside.
SurfacePoint surface_point(const TruthScene& scene, int surface, const TruthLight& light,
                           const Ray& sight, double depth) {
    SurfacePoint point{};
    point.position = along(sight.origin, depth, sight.direction);
    point.normal = unit_normal(scene, surface, point.position, sight.direction);
    point.n_dot_l = cosine(point.normal, light.ray(point.position).direction);
    point.lit = point.n_dot_l > 0 && !occluded(point.position, light, scene, surface) &&
                !left_through_itself(scene, surface, point.normal, light.ray(point.position),
                                     light.reach());
    return point;
}

Truth trace(const TruthScene& scene, const TruthView& view, const TruthLight& light) {
    Truth truth(view.size);
    truth.measure_area(light);

    // What is seen.
    const auto draw_surface = [&](int surface, const PixelBox& box) {
        draw(truth, view, surface, box,
             [&](const Ray& ray) { return depth_of(scene, surface, view, ray); });
    };
    int surface = 0;
    for (const TruthSphere& sphere : scene.spheres) draw_surface(surface++, box_of(view, sphere));
    for (const TruthPlane& plane : scene.planes) draw_surface(surface++, box_of(view, plane));

    // What of it the light sees.
    for (std::size_t at = 0; at < truth.surface.size(); ++at) {
        const int seen = truth.surface[at];
        if (seen == no_surface) continue;
        const int row = static_cast<int>(at / view.size);
        const int column = static_cast<int>(at % view.size);
        const Ray sight = view.ray(column + 0.5, row + 0.5);
        const SurfacePoint point = surface_point(scene, seen, light, sight, truth.depth[at]);
        truth.see(at, seen, truth.depth[at], point.position, point.normal, light);
        truth.lit[at] = point.lit;
        if (light.has_area())
            truth.see_area(at, points_seen(light, point.position, point.normal,
                                           [&](const TruthLight& one) {
                                               return !surface_point(scene, seen, one, sight,
                                                                     truth.depth[at]).lit;
                                           }));
        if (truth.lit[at]) continue;
        const Ray to_light = light.ray(point.position);
        truth.behind[at] =
            last_crossing(scene, to_light, light.reach()) * length(to_light.direction);
    }
    return truth;
}

}  // namespace umbra78::tools
