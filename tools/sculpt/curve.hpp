// Curves that surfaces are made from: chains of cubic Bezier curves, joined end to end.
//
// A chain of n cubics has 3 n + 1 control points, of which every third lies on the curve. A quarter
// of a circle has handles of 4/3 tan(22.5 degrees) of the radius; in general an arc of angle a has
// handles of 4/3 tan(a / 4). Its radius is then right to 0.03 % at a quarter turn.
#pragma once

#include "tools/sculpt/point.hpp"

#include <cstddef>
#include <vector>

namespace umbra78::tools {

using Chain = std::vector<Point>;

std::size_t cubics(const Chain&);

inline constexpr double round_handle = 0.5522847498307936;  // 4/3 tan(22.5 degrees)

// Draws a chain in the plane z = 0.
class Pen {
public:
    Pen(double x, double y) : chain_{{x, y, 0}} {}

    Pen& line(double x, double y);
    // A quarter of an ellipse to (x, y), which leaves toward a corner and comes from it. A greater
    // handle bends more sharply: 0.8 makes the side of a box with round edges.
    Pen& bend(double corner_x, double corner_y, double x, double y, double handle = round_handle);

    operator Chain() const { return chain_; }

private:
    Chain chain_;
};

// Closed, about the y axis, at radius 1 in the plane y = 0, in so many equal arcs.
Chain circle(int arcs);
// The same with four corners that a greater handle makes sharper; half its size along x and z.
Chain rounded_square(double handle, double half_x = 1, double half_z = 1);

// Through all points, its direction at each parallel to the line from the one before to the one
// after (Catmull and Rom 1974).
Chain through(const std::vector<Point>&);

// Part of a circle of a radius about `centre` in the plane of the directions `from` and `to`,
// which are of length 1 and at right angles. It starts at `from`.
Chain arc(Point centre, Point from, Point to, double radius, double degrees, int arcs);

}  // namespace umbra78::tools
