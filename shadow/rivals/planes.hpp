// The one predicate of the rivals: on which side of a plane is the point that a pixel shows?
//
// Every question here is of this kind. Does a facet cover a pixel: three planes through the eye
// and an edge. Which of two facets is nearer: the plane of one, at the point of the other. Does a
// facet shadow a point: three planes through the light and an edge, and the facet's own plane.
// With homogeneous words (x, y, z, w), the eye E, the pixel p = (px, py, 0, 1), and a plane's
// value pi . v = n . (x, y, z) + d w, the point of the facet with plane pi that the pixel shows is
//
//   P = (pi . p) E - (pi . E) p
//
// and the value of another plane there, lambda . P, is affine in px and py: a line on the screen,
// where the two planes meet. So a question about a pixel is a sign of x px + y py + c, exact, with
// no point ever rounded.
//
// Ties. The pixel's centre is moved to (px + e, py + e^2), e arbitrarily small (simulation of
// simplicity, Edelsbrunner & Muecke 1990, on the query alone). A value of 0 so takes the sign of
// x, then of y; if all three are 0 the planes are one, and the sign is 0, which no test takes for
// before or inside.
//
// Bits. A vertex word has 22, so an edge 23, a normal 47 and n . a 71, each and its sign. pi . E
// has 47 for an eye at infinity and 72 for one at a place. A line's coefficients are products of
// two of these, twice: 2 (71 + 72) < 145 bits, and the line's value at a pixel 147: within 192.
#pragma once

#include "fixed/wide_int.hpp"
#include "raster/vector.hpp"
#include "shadow/rivals/space.hpp"

#include <algorithm>
#include <cstdint>

namespace umbra78::shadow::rivals {

using Sum = fixed::WideInt<3>;

inline constexpr int edge_bits = word_bits + 1;
inline constexpr int normal_bits = 2 * edge_bits + 1;
inline constexpr int offset_bits = normal_bits + word_bits + 2;
inline constexpr int line_bits = 2 * offset_bits + 2;
inline constexpr int value_bits = line_bits + 2;
static_assert(normal_bits < 63 && value_bits < Sum::bits);

constexpr int sign(std::int64_t v) { return v > 0 ? 1 : v < 0 ? -1 : 0; }
constexpr int sign(const Sum& v) { return v.is_negative() ? -1 : v.is_zero() ? 0 : 1; }

// n . (x, y, z) + d w
struct Plane {
    raster::WideVector n;
    Sum d;

    Sum at(const Centre& c) const { return dot(c.x, c.y, c.z) + d * c.w; }
    Sum at(const Point& p) const { return dot(p.x, p.y, p.z) + d; }
    bool is_nothing() const { return n == raster::WideVector{}; }

private:
    Sum dot(std::int64_t x, std::int64_t y, std::int64_t z) const {
        return Sum(n[0]) * x + Sum(n[1]) * y + Sum(n[2]) * z;
    }
};

namespace detail {

constexpr raster::WideVector difference(const Point& b, const Point& a) {
    return {std::int64_t{b.x} - a.x, std::int64_t{b.y} - a.y, std::int64_t{b.z} - a.z};
}

inline Plane plane_at(const Point& a, const raster::WideVector& n) {
    return {n, -(Sum(n[0]) * a.x + Sum(n[1]) * a.y + Sum(n[2]) * a.z)};
}

}  // namespace detail

// Positive where a, b and c turn to the left seen from there.
inline Plane plane_of(const Point& a, const Point& b, const Point& c) {
    return detail::plane_at(a, raster::cross(detail::difference(b, a), detail::difference(c, a)));
}

// Through a centre of projection and an edge. For a facet a, b, c it is positive at the facet's
// inside, for each of its edges in turn, where the centre lies on its plane's negative side.
inline Plane plane_through(const Centre& o, const Point& a, const Point& b) {
    const std::int64_t w = o.w;
    const raster::WideVector from{o.x - w * a.x, o.y - w * a.y, o.z - w * a.z};
    return detail::plane_at(a, raster::cross(detail::difference(b, a), from));
}

// A plane as the eye has it: its value x px + y py + c at a pixel, and e at the eye.
struct SeenPlane {
    std::int64_t x = 0, y = 0;
    Sum c, e;
};

inline SeenPlane seen(const Plane& p, const Centre& eye) {
    return {p.n[0], p.n[1], p.d, p.at(eye)};
}

// A line on the screen, with a sign on each side.
struct ScreenLine {
    Sum x, y, c;

    Sum value(std::int64_t px, std::int64_t py) const { return x * px + y * py + c; }
    // -1 or 1; 0 if the line is none.
    int sign_at(std::int64_t px, std::int64_t py) const {
        const int s = sign(value(px, py));
        return s != 0 ? s : tie();
    }
    int tie() const {
        const int s = sign(x);
        return s != 0 ? s : sign(y);
    }
    bool is_none() const { return x.is_zero() && y.is_zero() && c.is_zero(); }
};

// A plane's own value at the pixels: of a plane through the eye.
inline ScreenLine line_of(const SeenPlane& p) { return {p.x, p.y, p.c}; }

// The value of `other` at the point of the plane `on` that a pixel shows, times a positive factor.
// `on` is not seen edge-on, and its point is before the eye.
inline ScreenLine meet(const SeenPlane& on, const SeenPlane& other) {
    const ScreenLine line{on.e * other.x - other.e * on.x, on.e * other.y - other.e * on.y,
                          on.e * other.c - other.e * on.c};
    return on.e.is_negative() ? ScreenLine{-line.x, -line.y, -line.c} : line;
}

// --- a row of pixels ------------------------------------------------------------------------

// Columns from `from` to before `to`; none if from >= to.
struct Run {
    int from, to;
    bool empty() const { return from >= to; }
    Run operator&(const Run& o) const { return {std::max(from, o.from), std::min(to, o.to)}; }
};

inline Run whole_row(const Space& space) { return {0, space.size_px()}; }

// The columns of a row where a line's sign is `wanted`, which is 1 or -1.
Run run_of(const ScreenLine& line, int wanted, const Space& space, int row);

}  // namespace umbra78::shadow::rivals
