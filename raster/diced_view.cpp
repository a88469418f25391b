#include "raster/diced_view.hpp"

#include <algorithm>

namespace umbra78::raster {
namespace {

constexpr int displacement = 2;  // object words; a vertex's is less than 9/8
// Each of these moves a coordinate by at most one: the roundings of the four words that a bound is
// made of, and up to six cuts.
constexpr std::int64_t roundings = 10;

// X and Y: a pixel beyond the frame's edge in perspective, a 64th of one else, where pixels have
// fractions. Z: the guard band's, beyond which no facet is drawn.
GuardBand cube(const MachineSpec& spec, bool affine) {
    const std::int64_t edge =
        affine ? spec.half_px() * pixel_units + pixel_units / 64 : spec.half_px() + 1;
    return {edge, edge, guard_band(spec, affine)[2]};
}

std::int64_t magnitude(std::int64_t v) { return v < 0 ? -v : v; }

}  // namespace

DicedView::DicedView(const MachineSpec& spec, const MatrixWords& matrix, WordFormat object)
    : spec_(spec), unit_(spec, matrix, object, hw::UnitWork{}), object_(object),
      limit_(cube(spec, matrix.affine)) {
    const ScreenPlace middle = place({0, 0, 0});
    const auto sign = [](unsigned bits, unsigned n) { return (bits >> n & 1u) != 0 ? 1 : -1; };
    for (unsigned corner = 0; corner < 8; ++corner) {
        const ScreenPlace p = place({displacement * sign(corner, 0),
                                     displacement * sign(corner, 1),
                                     displacement * sign(corner, 2)});
        for (std::size_t k = 0; k < margin_.size(); ++k)
            margin_[k] = std::max(margin_[k], within(p, k) - within(middle, k));
        for (std::size_t k = 0; k < spread_.size(); ++k)
            spread_[k] = std::max(spread_[k], magnitude(p[k] - middle[k]));
    }
    for (std::size_t k = 0; k < margin_.size(); ++k)
        margin_[k] += roundings * (matrix.affine ? 1 : limit_[k / 2] + 1);
    for (std::int64_t& s : spread_) s += roundings;
    if (matrix.affine) spread_[3] = 0;  // W is 1
}

ScreenPlace DicedView::place(const hw::Words& words) const {
    return unit_.matrix().affine ? affine_place(unit_, words)
                                 : homogeneous_place(words, unit_.matrix(), spec_, object_);
}

// How far a place lies within a plane of the cube: limit W + X of even ones, limit W - X of odd.
std::int64_t DicedView::within(const ScreenPlace& p, std::size_t plane) const {
    const std::size_t axis = plane / 2;
    const std::int64_t limit = limit_[axis] * p[3];
    return plane % 2 == 0 ? limit + p[axis] : limit - p[axis];
}

// A cut keeps what lies before the eye, W > 0, and of that nothing comes within a plane that all
// vertices lie beyond.
bool DicedView::outside(const Patch& patch) const {
    unsigned beyond_all = (1u << margin_.size()) - 1;
    for (const World& control : patch.control) {
        const ScreenPlace p = place(to_object_words(control, object_));
        for (std::size_t k = 0; k < margin_.size(); ++k)
            if (within(p, k) + margin_[k] >= 0) beyond_all &= ~(1u << k);
        if (beyond_all == 0) return false;
    }
    return true;
}

// A control point's share of an axis's bounds in raster units; false if there is no quotient. That
// of a mean lies between those of what it is made of, W being positive.
bool DicedView::quotients(const ScreenPlace& p, std::size_t axis, Bounds& b) const {
    const int fraction =
        axis == 2 ? spec_.depth_fraction() + depth_guard(spec_) : raster_fraction;
    for (const std::int64_t x : {p[axis] - spread_[axis], p[axis] + spread_[axis]}) {
        for (const std::int64_t w : {p[3] - spread_[3], p[3] + spread_[3]}) {
            fixed::Quotient q{x, fixed::DivideStatus::ok};
            if (!unit_.matrix().affine)
                q = fixed::divide(x, w, fraction, 31, fixed::Rounding::half_up);
            if (q.status != fixed::DivideStatus::ok) return false;
            b.min = std::min(b.min, q.value);
            b.max = std::max(b.max, q.value);
        }
    }
    return true;
}

Visibility DicedView::footprint(const Patch& patch, Footprint& out) const {
    if (outside(patch)) return Visibility::outside;
    ScreenBounds bounds{};
    for (Bounds& b : bounds) {
        b.min = INT64_MAX;
        b.max = INT64_MIN;
    }
    out = whole_frame(spec_);
    for (const World& control : patch.control) {
        const ScreenPlace p = place(to_object_words(control, object_));
        for (std::size_t axis = 0; axis < bounds.size(); ++axis)
            if (!quotients(p, axis, bounds[axis])) return Visibility::unknown;
    }
    out = raster::footprint(bounds, spec_);
    return Visibility::bounded;
}

}  // namespace umbra78::raster
