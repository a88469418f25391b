#include "shadow/rivals/casters.hpp"

namespace umbra78::shadow::rivals {
namespace {

// Whether some corner is on a plane's side 1, and some on its side -1, times `sense`.
struct Sides {
    bool positive = false, negative = false;
};

Sides sides_of(const std::array<Point, 3>& corners, const Plane& plane, int sense) {
    Sides sides;
    for (const Point& p : corners) {
        const int s = sense * sign(plane.at(p));
        sides.positive = sides.positive || s > 0;
        sides.negative = sides.negative || s < 0;
    }
    return sides;
}

// Along a direction the distance, for a place its square: less is nearer.
std::int64_t depth_of(const Centre& light, const Point& p) {
    const std::int64_t w = light.w, x = light.x, y = light.y, z = light.z;
    if (w == 0) return -(x * p.x + y * p.y + z * p.z);
    const std::int64_t dx = p.x - x, dy = p.y - y, dz = p.z - z;
    return dx * dx + dy * dy + dz * dz;
}

}  // namespace

std::int64_t nearest_depth(const Setting& setting, std::uint32_t facet) {
    std::int64_t depth = INT64_MAX;
    for (const Point& p : setting.mesh.corners(facet))
        depth = std::min(depth, depth_of(setting.light.centre, p));
    return depth;
}

Before before(const Setting& setting, std::uint32_t f, std::uint32_t on) {
    const Mesh& mesh = setting.mesh;
    const Sides f_of_on = sides_of(mesh.corners(f), mesh.plane(on), setting.light.sides[on]);
    if (!f_of_on.positive) return Before::no;
    if (!f_of_on.negative) return Before::yes;
    const Sides on_of_f = sides_of(mesh.corners(on), mesh.plane(f), setting.light.sides[f]);
    if (!on_of_f.negative) return Before::no;
    return on_of_f.positive ? Before::partly : Before::yes;
}

}  // namespace umbra78::shadow::rivals
