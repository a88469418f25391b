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

}  // namespace

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
