// Triangles on the screen to samples (hw/MACHINE.md, section 21).
//
// In: three corners in raster units (block_rule.hpp), in any order, X and Y within +-max_screen, Z
// within 31 bits. Out: for each pixel of the frame whose centre the triangle covers, its Z there.
//
// A centre on an edge belongs to the triangle whose top or left edge it is (X right, Y down), so
// triangles that share an edge cover each centre once. Z is that of the plane through the corners,
// exact, rounded half up once. Everything steps: an edge's crossing from line to line and Z from
// pixel to pixel are fractions of which quotient and remainder are kept, so that a step is two
// additions and never loses a bit.
// Not emulated: the order in which a machine of 1978 would have sorted its edges.
#pragma once

#include "fixed/wide_product.hpp"
#include "raster/sampling.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

namespace umbra78::raster {

// 2^14 pixels: a doubled area then has at most 57 bits, and so has an edge's value at a centre.
inline constexpr std::int32_t max_screen = (1 << 27) + 1;
static_assert(std::int64_t{2} * max_screen * (std::int64_t{2} * max_screen) <
              std::int64_t{1} << 57);

namespace detail {

// floor(numerator / denominator) of a fraction that grows by another one at each step.
class Stepper {
public:
    // denominator > 0
    Stepper(std::int64_t numerator, std::int64_t grows, std::int64_t denominator)
        : denominator_(denominator), value_(fixed::round_divide(numerator, denominator, floor)),
          rest_(numerator - value_ * denominator),
          step_(fixed::round_divide(grows, denominator, floor)),
          step_rest_(grows - step_ * denominator) {}

    std::int64_t value() const { return value_; }
    void step() {
        value_ += step_;
        rest_ += step_rest_;
        if (rest_ < denominator_) return;
        rest_ -= denominator_;
        ++value_;
    }

private:
    static constexpr auto floor = fixed::Rounding::floor;
    std::int64_t denominator_, value_, rest_, step_, step_rest_;
};

// The first pixel of a line whose centre is not left of an edge's line.
class EdgeCrossing {
public:
    EdgeCrossing(const Corner& p, const Corner& q, int first_line, std::int32_t half_px);

    bool is_left() const { return left_; }  // else a right edge: pixels before the crossing are in
    std::int64_t pixel() const { return pixel_.value(); }
    void next_line() { pixel_.step(); }

private:
    bool left_;
    Stepper pixel_;
};

// Z over a triangle: at a covered centre from the corners, then from pixel to pixel.
class DepthPlane {
public:
    // area = turn(a, b, c) > 0
    DepthPlane(const Corner& a, const Corner& b, const Corner& c, std::int64_t area);

    // `longer`: the span has a second pixel.
    void start(std::int64_t x, std::int64_t y, bool longer);
    std::int64_t z() const { return value_ + (2 * rest_ >= area_ ? 1 : 0); }
    void step() {
        value_ += step_;
        rest_ += step_rest_;
        if (rest_ < area_) return;
        rest_ -= area_;
        ++value_;
    }

private:
    void make_step();

    Corner a_, b_, c_;
    std::int64_t area_;
    std::int64_t lowest_;
    std::int64_t value_ = 0, rest_ = 0, step_ = 0, step_rest_ = 0;
    bool has_step_ = false;
};

// The lines and pixels whose centres lie in the corners' box, less its lower side, which no
// triangle owns; none if first > last.
struct CentreBox {
    std::int32_t x0, x1, y0, y1;
};

inline CentreBox centre_box(const Corner& a, const Corner& b, const Corner& c,
                            std::int32_t half_px) {
    const auto [min_x, max_x] = std::minmax({a.x, b.x, c.x});
    const auto [min_y, max_y] = std::minmax({a.y, b.y, c.y});
    const std::int32_t last = 2 * half_px - 1;
    return {std::max<std::int32_t>(first_pixel(min_x, half_px), 0),
            std::min(last_pixel(max_x, half_px), last),
            std::max<std::int32_t>(first_pixel(min_y, half_px), 0),
            std::min(last_pixel(max_y - 1, half_px), last)};
}

// An edge's value at a pixel's centre, less what the top-left rule takes from edges that are
// neither: a centre is covered where none of the three is negative. It steps by additions.
struct EdgeValue {
    std::int64_t value, right, down;

    EdgeValue(const Corner& p, const Corner& q, std::int32_t x, std::int32_t y)
        : value(turn(p, q, x, y) - (q.y < p.y || (q.y == p.y && q.x > p.x) ? 0 : 1)),
          right((std::int64_t{p.y} - q.y) * pixel_units),
          down((std::int64_t{q.x} - p.x) * pixel_units) {}
};

// The samples of a triangle whose box holds few centres: each is tested by itself, which takes less
// than what the edges' crossings need to begin.
template <class Emit>
void sample_few_centres(const Corner& a, const Corner& b, const Corner& c, const CentreBox& box,
                        std::int32_t half, DepthPlane& plane, Emit&& emit) {
    const std::int32_t x0 = pixel_centre(box.x0, half), y0 = pixel_centre(box.y0, half);
    EdgeValue ab(a, b, x0, y0), bc(b, c, x0, y0), ca(c, a, x0, y0);
    for (int py = box.y0; py <= box.y1; ++py) {
        std::int64_t e = ab.value, f = bc.value, g = ca.value;
        for (int px = box.x0; px <= box.x1; ++px) {
            if ((e | f | g) >= 0) {
                const std::int32_t x = pixel_centre(px, half), y = pixel_centre(py, half);
                plane.start(x, y, false);
                emit(Sample{px, py, x, y, plane.z(), 0, 0});
            }
            e += ab.right, f += bc.right, g += ca.right;
        }
        ab.value += ab.down, bc.value += bc.down, ca.value += ca.down;
    }
}

}  // namespace detail

// Hands every sample of the triangle to `emit`, line by line from the top. Returns how many lines
// were looked at. The definition is the specification's; tests hold this form to it.
template <class Emit>
std::uint64_t sample_triangle(Corner a, Corner b, Corner c, const hw::MachineSpec& spec,
                              Emit&& emit) {
    const std::int32_t half = spec.half_px();
    const detail::CentreBox box = detail::centre_box(a, b, c, half);
    if (box.x0 > box.x1 || box.y0 > box.y1) return 0;
    std::int64_t area = detail::turn(a, b, c.x, c.y);
    if (area == 0) return 0;
    if (area < 0) {
        std::swap(b, c);
        area = -area;
    }
    detail::DepthPlane plane(a, b, c, area);
    if (box.x1 - box.x0 < 8 && box.y1 - box.y0 < 8) {
        detail::sample_few_centres(a, b, c, box, half, plane, emit);
        return static_cast<std::uint64_t>(box.y1 - box.y0 + 1);
    }
    std::array<detail::EdgeCrossing, 3> edges{detail::EdgeCrossing(a, b, box.y0, half),
                                              detail::EdgeCrossing(b, c, box.y0, half),
                                              detail::EdgeCrossing(c, a, box.y0, half)};
    for (int py = box.y0; py <= box.y1; ++py) {
        std::int64_t from = box.x0, to = std::int64_t{box.x1} + 1;
        for (detail::EdgeCrossing& e : edges) {
            if (e.is_left()) {
                from = std::max(from, e.pixel());
            } else {
                to = std::min(to, e.pixel());
            }
            e.next_line();
        }
        if (from >= to) continue;
        const std::int32_t y = pixel_centre(py, half);
        plane.start(pixel_centre(static_cast<int>(from), half), y, to - from > 1);
        for (auto px = static_cast<int>(from); px < to; ++px) {
            emit(Sample{px, py, pixel_centre(px, half), y, plane.z(), 0, 0});
            plane.step();
        }
    }
    return static_cast<std::uint64_t>(box.y1 - box.y0 + 1);
}

}  // namespace umbra78::raster
