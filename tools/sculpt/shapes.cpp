// Shapes made by lathe and tube.
#include "tools/sculpt/surface.hpp"

namespace umbra78::tools {
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
