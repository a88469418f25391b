#include "tools/sculpt/curve.hpp"

namespace umbra78::tools {

std::size_t cubics(const Chain& chain) { return (chain.size() - 1) / 3; }

Point beside(Point along) {
    const Point axis = std::abs(along.y) < 0.9 ? Point{0, 1, 0} : Point{0, 0, 1};
    return unit(cross(axis, along));
}

Point placed(Point p, const Placement& at) {
    const auto turned = [](double& a, double& b, double degrees) {
        const double c = std::cos(radians(degrees)), s = std::sin(radians(degrees));
        const double first = c * a - s * b;
        b = s * a + c * b;
        a = first;
    };
    p = {p.x * at.scale.x, p.y * at.scale.y, p.z * at.scale.z};
    turned(p.y, p.z, at.turn.x);
    turned(p.z, p.x, at.turn.y);
    turned(p.x, p.y, at.turn.z);
    return p + at.place;
}

Pen& Pen::line(double x, double y) {
    const Point from = chain_.back(), to{x, y, 0};
    chain_.insert(chain_.end(), {2. / 3 * from + 1. / 3 * to, 1. / 3 * from + 2. / 3 * to, to});
    return *this;
}

Pen& Pen::bend(double corner_x, double corner_y, double x, double y, double handle) {
    const Point from = chain_.back(), corner{corner_x, corner_y, 0}, to{x, y, 0};
    chain_.insert(chain_.end(),
                  {from + handle * (corner - from), to + handle * (corner - to), to});
    return *this;
}

Chain arc(Point centre, Point from, Point to, double radius, double degrees, int arcs) {
    const double step = radians(degrees) / arcs, handle = 4. / 3 * std::tan(step / 4);
    const auto direction = [&](double a) { return std::cos(a) * from + std::sin(a) * to; };
    Chain chain{centre + radius * from};
    for (int k = 0; k < arcs; ++k) {
        const double a = k * step, b = (k + 1) * step, right = std::numbers::pi / 2;
        chain.push_back(centre + radius * (direction(a) + handle * direction(a + right)));
        chain.push_back(centre + radius * (direction(b) - handle * direction(b + right)));
        chain.push_back(centre + radius * direction(b));
    }
    return chain;
}

Chain circle(int arcs) {
    Chain chain = arc({}, {1, 0, 0}, {0, 0, 1}, 1, 360, arcs);
    chain.back() = chain.front();
    return chain;
}

Chain rounded_square(double handle, double half_x, double half_z) {
    const double x = half_x, z = half_z, h = handle;
    return {{x, 0, 0},      {x, 0, h * z},   {h * x, 0, z},  {0, 0, z},  {-h * x, 0, z},
            {-x, 0, h * z}, {-x, 0, 0},      {-x, 0, -h * z}, {-h * x, 0, -z}, {0, 0, -z},
            {h * x, 0, -z}, {x, 0, -h * z},  {x, 0, 0}};
}

Chain through(const std::vector<Point>& points) {
    const std::size_t last = points.size() - 1;
    const auto third = [&](std::size_t k) {  // of the curve's derivative at a point
        if (k == 0) return 1. / 3 * (points[1] - points[0]);
        if (k == last) return 1. / 3 * (points[last] - points[last - 1]);
        return 1. / 6 * (points[k + 1] - points[k - 1]);
    };
    Chain chain{points[0]};
    for (std::size_t k = 0; k < last; ++k) {
        chain.push_back(points[k] + third(k));
        chain.push_back(points[k + 1] - third(k + 1));
        chain.push_back(points[k + 1]);
    }
    return chain;
}

}  // namespace umbra78::tools
