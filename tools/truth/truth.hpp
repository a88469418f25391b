// The exact shadow of an ideal scene, in closed form: what the machine's picture is held to.
//
// Spheres are shells and planes finite parallelograms, both without thickness. One ray a pixel
// finds the surface seen, one ray from there to the light decides its shadow: no depth map, no
// bias, no quantum. Double precision; nothing exact depends on it.
//
// World: x right, y up, z toward the viewer; one free unit of length for everything here.
// Pixels: row 0 is the top, index = row * size + column, centres at (column + 1/2, row + 1/2).
// Preconditions, not checked: radius > 0, extent > 0, size > 0, unit axes, a plane's u and v not
// parallel. A point that lies exactly on a second surface may be answered either way.
#pragma once

#include "tools/truth/real3.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace umbra78::tools {

// `direction` need not be a unit vector: its length is the unit of t.
struct Ray {
    Real3 origin, direction;
};

struct TruthSphere {
    Real3 centre;
    double radius;
};

// origin + s u + t v with 0 <= s, t <= 1; lit where light and viewer are on the same side.
struct TruthPlane {
    Real3 origin, u, v;
};

// Surfaces are numbered spheres first, then planes.
struct TruthScene {
    std::vector<TruthSphere> spheres;
    std::vector<TruthPlane> planes;
};
inline constexpr int no_surface = -1;

struct TruthView {
    bool perspective;
    Real3 target;
    Real3 rotation[3];  // rows right, up, back: unit, world; back points toward the viewer
    double extent;      // half width of the window, world units at the target plane
    double distance;    // eye to target, perspective only: eye = target + distance back
    double near_depth, far_depth;  // along -back, from the target plane or from the eye
    int size;           // pixels a side

    double pixel() const { return 2 * extent / size; }  // world units at the target plane
    Ray ray(double column, double row) const;           // t is depth, in both kinds of view
    Real3 project(const Real3& world) const;            // (column, row, depth), inverse of ray
};

struct TruthLight {
    bool point;
    Real3 direction;  // unit, toward the light; read unless `point`
    Real3 position;   // read if `point`
    // Of a square light about `position`: its two sides, and how many points a side its share is
    // measured by; 0 points: a light without area.
    Real3 side_u{}, side_v{};
    int points_a_side = 0;

    bool has_area() const { return points_a_side > 0; }
    TruthLight point_of_area(int i, int j) const;

    Ray ray(const Real3& from) const;  // toward the light
    double reach() const {             // t of the light on that ray
        return point ? 1.0 : std::numeric_limits<double>::infinity();
    }
};

// Planes of size * size pixels. Where `visible` is 0, `surface` is no_surface, `depth` infinite
// and the rest zero.
struct Truth {
    int size = 0;
    std::vector<std::uint8_t> visible;  // 1: a surface lies within near .. far
    std::vector<std::uint8_t> lit;      // 1: faces the light and nothing stands between
    std::vector<std::int32_t> surface;
    std::vector<double> depth;          // as TruthView measures it
    std::vector<Real3> position;
    std::vector<Real3> normal;          // unit, toward the viewer
    std::vector<double> n_dot_l;        // cosine, -1 .. 1
    std::vector<double> behind;         // in shadow: how far the last surface before the light
                                        // is, world units along the light's ray; 0 where lit
    // Of a light with an area: how many of `points` points on it are seen, and `lit` is 1 where at
    // least half of them are. Empty for others.
    std::vector<std::uint16_t> seen;
    int points = 1;

    // The share of the light that is seen, 0 .. 1.
    double light_share(std::size_t at) const {
        return seen.empty() ? lit[at] : static_cast<double>(seen[at]) / points;
    }

    // Before the first pixel is seen; nothing for a light without area.
    void measure_area(const TruthLight&);
    // Sees so many of the area's points.
    void see_area(std::size_t at, int points_of_it);

    Truth() = default;
    explicit Truth(int size_px);  // nothing seen

    // Sees a surface of that normal there, in shadow until it is said to be lit.
    void see(std::size_t at, int surface_seen, double depth_seen, const Real3& where,
             const Real3& unit_normal, const TruthLight&);
};

// How many points of a light with an area a surface point sees. `blocked(light)`: whether something
// stands before that point of it. Where 8 x 8 of the points, the outermost among them, agree, all
// are taken to.
template <class Blocked>
int points_seen(const TruthLight& light, const Real3& position, const Real3& normal,
                Blocked&& blocked) {
    const int n = light.points_a_side, few = std::min(n, 8);
    const auto count = [&](int m) {  // of m x m among them
        int seen = 0;
        for (int j = 0; j < m; ++j)
            for (int i = 0; i < m; ++i) {
                const TruthLight one = m == n ? light.point_of_area(i, j)
                                              : light.point_of_area(i * (n - 1) / (m - 1),
                                                                    j * (n - 1) / (m - 1));
                seen += dot(normal, one.ray(position).direction) > 0 && !blocked(one);
            }
        return seen;
    };
    const int first = count(few);
    return first == 0 ? 0 : first == few * few ? n * n : few == n ? first : count(n);
}

// Where a ray meets a whole sphere (first and second t) or a parallelogram.
std::optional<std::array<double, 2>> crossings(const TruthSphere&, const Ray&);
struct PlaneCrossing {
    double t;
    bool inside;  // of the parallelogram; otherwise t is where the unbounded plane is met
};
std::optional<PlaneCrossing> crossing(const TruthPlane&, const Ray&);  // none: parallel

// Whether any surface but `ignoring` meets the ray strictly between t = from and t = to.
bool blocked(const TruthScene&, const Ray&, double from, double to, int ignoring = no_surface);

// The last t > 0 before t = to at which the ray meets any surface; 0 where it meets none.
double last_crossing(const TruthScene&, const Ray&, double to);

// Whether the normal toward the viewer at a point of the surface shows that it is a sphere seen
// from inside; and whether the ray from that point leaves the sphere before t = to.
bool seen_from_inside(const TruthScene&, int surface, const Real3& at, const Real3& normal);
bool left_through_itself(const TruthScene&, int surface, const Real3& normal, const Ray& from_it,
                         double to);

// Whether anything but surface `ignoring` stands between the point and the light.
bool occluded(const Real3& point, const TruthLight&, const TruthScene&,
              int ignoring = no_surface);

// The first depth within near .. far at which the view's ray meets the surface; infinite if none.
double depth_of(const TruthScene&, int surface, const TruthView&, const Ray&);

// What is at a depth of that ray, on that surface.
struct SurfacePoint {
    Real3 position, normal;  // unit, toward the viewer
    double n_dot_l;
    bool lit;
};
SurfacePoint surface_point(const TruthScene&, int surface, const TruthLight&, const Ray& sight,
                           double depth);

Truth trace(const TruthScene&, const TruthView&, const TruthLight&);

}  // namespace umbra78::tools
