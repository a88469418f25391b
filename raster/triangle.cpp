#include "raster/triangle.hpp"

namespace umbra78::raster::detail {
namespace {

constexpr std::int64_t pixel = pixel_units;

std::uint64_t word(std::int64_t v) { return static_cast<std::uint64_t>(v); }

// The crossing of the line through an edge's ends with the first line's centre, in pixels rounded
// up: (p.x - centre 0) / pixel + (q.x - p.x) (y - p.y) / (pixel (q.y - p.y)).
Stepper crossing(const Corner& upper, const Corner& lower, int first_line, std::int32_t half_px) {
    const std::int64_t dx = std::int64_t{lower.x} - upper.x, dy = std::int64_t{lower.y} - upper.y;
    if (dy == 0) return {-1, 0, 1};  // a level edge: left of every pixel, so it excludes none
    const std::int64_t from_first = std::int64_t{upper.x} - pixel_centre(0, half_px);
    const std::int64_t down = std::int64_t{pixel_centre(first_line, half_px)} - upper.y;
    const std::int64_t denominator = pixel * dy;
    return {from_first * dy + dx * down + denominator - 1, dx * pixel, denominator};
}

}  // namespace

EdgeCrossing::EdgeCrossing(const Corner& p, const Corner& q, int first_line, std::int32_t half_px)
    : left_(q.y <= p.y),
      pixel_(left_ ? crossing(q, p, first_line, half_px) : crossing(p, q, first_line, half_px)) {}

DepthPlane::DepthPlane(const Corner& a, const Corner& b, const Corner& c, std::int64_t area)
    : a_(a), b_(b), c_(c), area_(area), lowest_(std::min({a.z, b.z, c.z})) {}

// The mean of the corners' depths over the lowest, weighted by the edges' values at a covered
// place, which are not negative and add up to the area.
void DepthPlane::start(std::int64_t x, std::int64_t y, bool longer) {
    const std::int64_t at_b = turn(c_, a_, x, y), at_c = turn(a_, b_, x, y);
    const auto part = [&](std::int64_t weight, const Corner& corner) {
        return fixed::multiply_wide(word(weight), word(corner.z - lowest_));
    };
    const fixed::Word128 sum = fixed::add_wide(
        part(area_ - at_b - at_c, a_), fixed::add_wide(part(at_b, b_), part(at_c, c_)));
    const fixed::QuotientRemainder mean = fixed::divide_wide(sum, word(area_));
    value_ = lowest_ + static_cast<std::int64_t>(mean.quotient);
    rest_ = static_cast<std::int64_t>(mean.remainder);
    if (longer && !has_step_) make_step();
}

// Z grows by slope pixel / area from pixel to pixel. Two covered centres lie a pixel apart, so this
// is at most the range of Z, whatever the triangle; the product alone would not fit 64 bits.
void DepthPlane::make_step() {
    const std::int64_t slope = (std::int64_t{b_.z} - a_.z) * (std::int64_t{c_.y} - a_.y) +
                               (std::int64_t{c_.z} - a_.z) * (std::int64_t{a_.y} - b_.y);
    const std::int64_t whole = fixed::round_divide(slope, area_, fixed::Rounding::floor);
    const fixed::QuotientRemainder part = fixed::divide_wide(
        fixed::multiply_wide(word(slope - whole * area_), word(pixel)), word(area_));
    step_ = whole * pixel + static_cast<std::int64_t>(part.quotient);
    step_rest_ = static_cast<std::int64_t>(part.remainder);
    has_step_ = true;
}

}  // namespace umbra78::raster::detail
