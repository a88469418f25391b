// Surfaces of bicubic Bezier patches, made from curves.
//
// A net is the 16 control points of a patch, point (i, j) at 4 j + i. Patches of one surface that
// meet share the control points of their border. A surface of free patches is a list of their nets.
#pragma once

#include "tools/sculpt/curve.hpp"

#include <array>
#include <vector>

namespace umbra78::tools {

using Net = std::array<Point, 16>;
using Surface = std::vector<Net>;

Point point_on(const Net&, double u, double v);

// A profile (x is the radius, y the height) carried around the y axis along a section of radius 1:
// circle(n) makes a surface of revolution, rounded_square(h) one with flat sides.
// P(u, v) = (x(v) s.x(u), y(v), x(v) s.z(u)), which is bicubic.
Surface lathe(const Chain& profile, const Chain& section);

// A circle swept along a path, its radius given at each end of a cubic and linear between them. A
// patch is right in places at the ends of its piece of the path, and in the direction there:
//
//   dP/dt = p' (1 - r e.k) + r' e    e: from the path to the surface, k: the path's curvature
//
// which makes a bent tube's patch a torus's, to the error of an arc. The circle does not twist: it
// is carried by two reflections (Wang et al. 2008). On a path that ends as it began it turns evenly
// by what it takes for the last patches to meet the first.
Surface tube(const Chain& path, const std::vector<double>& radii, int arcs = 4);

// Through sections with equally many control points, one after another, smoothly.
Surface loft(const std::vector<Chain>& sections);

// Ready shapes about the origin.
Surface ellipsoid(double half_x, double half_y, double half_z, int arcs = 4);
// Its sides bulge less the greater the handle (a superellipsoid's look).
Surface rounded_box(double half_x, double half_y, double half_z, double handle = 0.8);
// About the y axis, with a flat or a domed end above and its foot at the origin.
Surface button(double radius, double height, double edge, int arcs = 4);
Surface ring(double radius, double thickness, int arcs = 4);
// A limb of round section with round ends, its middle line from one point to another.
Surface limb(Point from, Point to, double radius_from, double radius_to);

Surface placed(Surface, const Placement&);
Surface mirrored(Surface);  // at the plane x = 0
// The y axis turned into the direction of the limb, the origin moved to `from`.
Surface along(Surface, Point from, Point to);
Surface joined(std::vector<Surface>);

}  // namespace umbra78::tools
