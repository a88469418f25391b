#include "raster/projection.hpp"

#include "fixed/overflow.hpp"
#include "raster/extent.hpp"

#include <algorithm>
#include <bit>

namespace umbra78::raster {
namespace {

using fixed::Rounding;

// The whole pixel c that the bounds of a quotient are taken about lies within +-2^12.
constexpr std::int64_t farthest_centre = 1 << 12;

// X, Y, Z and W are signed words of 44 bits: X - c W and all that block.hpp makes of it fit 64.
constexpr int homogeneous_bits = 44;
constexpr std::int64_t max_growth_here = INT64_MAX / (std::int64_t{1} << (homogeneous_bits - 1));
static_assert(max_growth <= max_growth_here);
// X - c W is made of components, not of control points: their bounds grow by less.
constexpr std::int64_t max_bounds_growth = 2 + 4 * 3 + 2 * 3 + 4 * 9;  // slope_u, the greatest
static_assert(max_bounds_growth * (farthest_centre + 1) <= max_growth_here);

template <class Transform>
Component component(const ObjectWords& p, Transform&& transform) {
    std::array<std::int64_t, 16> control{};
    for (std::size_t k = 0; k < 16; ++k) control[k] = transform(p[k]);
    return component_from_bezier(control);
}

// A row's accumulator at the matrix's common exponent, brought to 44 bits.
std::int64_t homogeneous_row(const hw::Words& v, hw::Row r, const MatrixWords& m,
                             const MachineSpec& spec, WordFormat format) {
    const int common = *std::max_element(m.exponent.begin(), m.exponent.end());
    const int up = homogeneous_bits - (format.bits + spec.coefficient_bits + 2);
    return fixed::scale_shift(hw::accumulate(m, r, v, format.one_word()),
                              common - m.exponent[static_cast<std::size_t>(r)] - up,
                              spec.transform_rounding);
}

// a - c b, corner by corner.
Component minus_multiple(const Component& a, std::int64_t c, const Component& b) {
    Component r;
    for (std::size_t k = 0; k < 4; ++k) {
        r.f[k] = a.f[k] - c * b.f[k];
        r.gu[k] = a.gu[k] - c * b.gu[k];
        r.gv[k] = a.gv[k] - c * b.gv[k];
        r.guv[k] = a.guv[k] - c * b.guv[k];
    }
    return r;
}

// v 2^n rounded up, or `huge` where that would leave 58 bits. v >= 0, n from -2 to 22.
constexpr std::int64_t huge = huge_bound;

std::int64_t scaled_up(std::int64_t v, int n) {
    if (n < 0) return fixed::scale_shift(v, -n, Rounding::ceiling);
    return v >= fixed::floor_shift(huge, n) ? huge : v << n;
}

// Corner 0 of X / W, floored to a whole pixel. W > 0.
std::int64_t whole_pixel(const Component& x, const Component& w) {
    return fixed::round_divide(x.f[0], w.f[0], Rounding::floor);
}

// Bounds of X / W in 2^-fraction pixel; bw.min > 0.
Bounds quotient_bounds(const Component& x, const Component& w, const Bounds& bw, int fraction) {
    // W is brought to 24 bits and rounded down, what is divided by it to the same scale and up.
    const int down = std::max(0, static_cast<int>(std::bit_width(
                                     static_cast<std::uint64_t>(bw.min))) - 24);
    const std::int64_t w_min = fixed::floor_shift(bw.min, down);
    const auto scaled = [&](std::int64_t v) { return fixed::floor_shift(v, down) + 1; };
    const std::int64_t centre = std::clamp(whole_pixel(x, w), -farthest_centre, farthest_centre);
    const Bounds b = bounds(minus_multiple(x, centre, w));
    const auto over_w = [&](std::int64_t v) {  // v / W in the target's fraction, rounded up
        return scaled_up(scaled(v), fraction) / w_min + 1;
    };
    const std::int64_t reach = over_w(std::max(-b.min, b.max));
    const auto times = [&](std::int64_t v) {  // reach v / W
        const std::int64_t s = scaled(v);
        if (reach >= std::int64_t{1} << 26 || s >= std::int64_t{1} << 31) return huge;
        return reach * s / w_min + 1;
    };
    Bounds out{};
    out.min = fixed::scale_shift(centre, -fraction, Rounding::floor) - reach;
    out.max = fixed::scale_shift(centre, -fraction, Rounding::ceiling) + reach;
    out.slope_u = over_w(b.slope_u) + times(bw.slope_u);
    out.slope_v = over_w(b.slope_v) + times(bw.slope_v);
    // An eighth of |x''| <= (|X''| + |x W''| + 2 |x' W'|) / W.
    const auto bend = [&](std::int64_t bx, std::int64_t bw_bend, std::int64_t slope,
                          std::int64_t w_slope) {
        const std::int64_t s = scaled(w_slope);
        const std::int64_t mixed = slope >= std::int64_t{1} << 28 || s >= std::int64_t{1} << 30
                                       ? huge
                                       : slope * s / (4 * w_min) + 1;
        return over_w(bx) + times(bw_bend) + mixed;
    };
    out.bend_u = bend(b.bend_u, bw.bend_u, out.slope_u, bw.slope_u);
    out.bend_v = bend(b.bend_v, bw.bend_v, out.slope_v, bw.slope_v);
    return out;
}

// Whether corner 0 of a block (W > 0) is farther out than any centre. About a clamped centre its
// bounds contain the frame however small the block is, so the block rule would split it until the
// patch's splits were used up, though the block is a thousand frames away.
bool far_out(const std::array<Component, 4>& c) {
    for (std::size_t k = 0; k < 3; ++k) {
        const std::int64_t at = whole_pixel(c[k], c[3]);
        if (at < -farthest_centre || at > farthest_centre) return true;
    }
    return false;
}

// Whether a block, or the part of it before the eye, lies beyond one side of the cube grown by a
// pixel: X - e W > 0 or X + e W < 0. This holds for W of any sign, unlike a bound of X / W.
bool beyond_a_side(const std::array<Component, 4>& c, std::int64_t edge_px) {
    for (std::size_t k = 0; k < 3; ++k) {
        if (bounds(minus_multiple(c[k], edge_px, c[3])).min > 0) return true;
        if (bounds(minus_multiple(c[k], -edge_px, c[3])).max < 0) return true;
    }
    return false;
}

}  // namespace

WordFormat object_format(const Surfaces& surfaces) {
    Box box;
    surfaces.for_points([&](const World& p) { box.add(p); });
    return object_format(box.largest());
}

WordFormat object_format(std::uint32_t largest) {
    int fraction = object_bits - 2;
    while (fraction > 0 && !fixed::fits(fixed::round_shift(largest, world_fraction - fraction,
                                                           Rounding::half_up),
                                        object_bits))
        --fraction;
    return {object_bits, fraction};
}

ObjectWords to_object_words(const Patch& patch, WordFormat format) {
    ObjectWords out{};
    for (std::size_t k = 0; k < 16; ++k) out[k] = to_object_words(patch.control[k], format);
    return out;
}

ScreenPlace affine_place(const hw::TransformUnit& unit, const hw::Words& place) {
    const MachineSpec& spec = unit.spec();
    return {unit.affine_row(hw::Row::x, place, raster_fraction),
            unit.affine_row(hw::Row::y, place, raster_fraction),
            unit.affine_row(hw::Row::z, place, spec.depth_fraction() + depth_guard(spec)), 1};
}

ScreenPlace homogeneous_place(const hw::Words& place, const MatrixWords& m,
                              const MachineSpec& spec, WordFormat format) {
    ScreenPlace out{};
    for (const hw::Row r : {hw::Row::x, hw::Row::y, hw::Row::z, hw::Row::w})
        out[static_cast<std::size_t>(r)] = homogeneous_row(place, r, m, spec, format);
    return out;
}

std::array<Component, 3> affine_components(const ObjectWords& p, const MatrixWords& m,
                                           const MachineSpec& spec, WordFormat format,
                                           hw::UnitWork work) {
    const hw::TransformUnit unit(spec, m, format, work);
    const auto row = [&](hw::Row r, int fraction) {
        return component(p,
                         [&](const hw::Words& v) { return unit.affine_row(r, v, fraction); });
    };
    return {row(hw::Row::x, raster_fraction), row(hw::Row::y, raster_fraction),
            row(hw::Row::z, spec.depth_fraction() + depth_guard(spec))};
}

std::array<Component, 4> homogeneous_components(const ObjectWords& p, const MatrixWords& m,
                                                const MachineSpec& spec, WordFormat format) {
    const auto row = [&](hw::Row r) {
        return component(
            p, [&](const hw::Words& v) { return homogeneous_row(v, r, m, spec, format); });
    };
    return {row(hw::Row::x), row(hw::Row::y), row(hw::Row::z), row(hw::Row::w)};
}

ScreenBounds affine_bounds(const std::array<Component, 3>& c) {
    return {bounds(c[0]), bounds(c[1]), bounds(c[2])};
}

Visibility projected_bounds(const std::array<Component, 4>& c, const MachineSpec& spec,
                            ScreenBounds& out) {
    const Bounds w = bounds(c[3]);
    if (w.max <= 0) return Visibility::outside;
    const bool crosses = w.min <= 0;
    if ((crosses || far_out(c)) && beyond_a_side(c, spec.half_px() + 1)) return Visibility::outside;
    if (crosses) return Visibility::unknown;
    out = {quotient_bounds(c[0], c[3], w, raster_fraction),
           quotient_bounds(c[1], c[3], w, raster_fraction),
           quotient_bounds(c[2], c[3], w, spec.depth_fraction() + depth_guard(spec))};
    return Visibility::bounded;
}

}  // namespace umbra78::raster
