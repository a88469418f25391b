#include "raster/view.hpp"

#include "fixed/root.hpp"
#include "fixed/sine.hpp"

#include <algorithm>
#include <bit>

namespace umbra78::raster {
namespace {

using fixed::Rounding;

constexpr std::int64_t one_q16 = std::int64_t{1} << world_fraction;

Rational q30(std::int32_t word) { return Rational(word, axis_one); }
Rational q16(std::int64_t word) { return Rational(word, one_q16); }

using ExactVector = Vector<Rational>;

// Pixels a world unit at the target (orthographic: everywhere), times `distance` in perspective.
Rational focal(const View& v, const MachineSpec& spec) {
    const Rational scale = Rational(spec.half_px()) / q16(v.extent);
    return has_eye(v) ? scale * q16(v.distance) : scale;
}

// scale (a, -a . o)
std::array<Rational, 4> plane_row(const ExactVector& a, const ExactVector& o,
                                  const Rational& scale) {
    return {scale * a[0], scale * a[1], scale * a[2], -(scale * dot(a, o))};
}

ExactVector negated(const ExactVector& v) { return {-v[0], -v[1], -v[2]}; }

// v / |v| in Q2.30, for components of at most 33 bits that are not all 0.
Axis normalized(WideVector v) {
    std::uint64_t largest = 0;
    for (const std::int64_t c : v) largest = std::max(largest, fixed::magnitude(c));
    // The largest component gets 30 bits, so that the squares' sum fits 62.
    const int down = static_cast<int>(std::bit_width(largest)) - 30;
    for (std::int64_t& c : v) c = fixed::scale_shift(c, down, Rounding::half_even);
    const std::int64_t length = fixed::isqrt(static_cast<std::uint64_t>(dot(v, v)));
    Axis out{};
    for (std::size_t k = 0; k < 3; ++k)
        out[k] = static_cast<std::int32_t>(
            fixed::round_divide(v[k] * axis_one, length, Rounding::half_even));
    return out;
}

}  // namespace

ExactVector exact(const Axis& a) { return {q30(a[0]), q30(a[1]), q30(a[2])}; }

ExactVector origin(const View& v) {
    ExactVector o{q16(v.target.x), q16(v.target.y), q16(v.target.z)};
    if (has_eye(v)) {
        const ExactVector back = exact(v.axes.back);
        for (std::size_t k = 0; k < 3; ++k) o[k] += q16(v.distance) * back[k];
    }
    return o;
}

ViewAxes axes_from_angles(std::int32_t azimuth_q16, std::int32_t elevation_q16) {
    const fixed::SineCosine a = fixed::sine_cosine(azimuth_q16);
    const fixed::SineCosine b = fixed::sine_cosine(elevation_q16);
    return {{a.cosine, 0, -a.sine},
            {-axis_product(a.sine, b.sine), b.cosine, -axis_product(a.cosine, b.sine)},
            {axis_product(a.sine, b.cosine), b.sine, axis_product(a.cosine, b.cosine)}};
}

World place_on_area(const World& middle, const ViewAxes& axes, std::int32_t side, AreaPlace at) {
    const auto along = [&](std::int32_t p, std::size_t k) {
        const std::int64_t steps = at.right * std::int64_t{axes.right[k]} +
                                   at.up * std::int64_t{axes.up[k]};  // Q2.30
        const Rational off = Rational(steps, std::int64_t{at.over}) *
                             Rational(side, std::int64_t{1} << axis_fraction);
        std::int64_t word = 0;
        fixed::require(off.round_scaled(0, fixed::Rounding::half_up, word),
                       "a place on an area is beyond all words");
        return static_cast<std::int32_t>(p + word);
    };
    return {along(middle.x, 0), along(middle.y, 1), along(middle.z, 2)};
}

bool axes_from_points(const World& from, const World& to, ViewAxes& out) {
    const WideVector v{std::int64_t{from.x} - to.x, std::int64_t{from.y} - to.y,
                       std::int64_t{from.z} - to.z};
    if (v[0] == 0 && v[1] == 0 && v[2] == 0) return false;
    out.back = normalized(v);
    if (v[0] == 0 && v[2] == 0) {
        out.right = {axis_one, 0, 0};
    } else {
        out.right = normalized({v[2], 0, -v[0]});
    }
    // up = back x right; right has no vertical part.
    const Axis& b = out.back;
    const Axis& r = out.right;
    out.up = {axis_product(b[1], r[2]), axis_product(b[2], r[0]) - axis_product(b[0], r[2]),
              -axis_product(b[1], r[0])};
    return true;
}

std::int32_t distance_between(const World& a, const World& b) {
    std::uint64_t sum = 0;
    for (const std::int64_t d : {std::int64_t{a.x} - b.x, std::int64_t{a.y} - b.y,
                                 std::int64_t{a.z} - b.z}) {
        if (d < -max_distance || d > max_distance) return 0;
        sum += static_cast<std::uint64_t>(d * d);
    }
    const std::uint64_t root = fixed::isqrt(sum);
    const std::uint64_t rounded = root + (sum - root * root > root ? 1 : 0);
    return rounded > max_distance ? 0 : static_cast<std::int32_t>(rounded);
}

DepthRange depth_range(const View& view, const Surfaces& surfaces) {
    AxisRange back;
    surfaces.for_points([&](const World& p) { back.add(along(view.axes.back, p)); });
    return depth_range_of(view, back);
}

DepthRange depth_range_of(const View& view, const AxisRange& back) {
    if (back.min > back.max) return {0, 0};
    const Rational offset = -dot(exact(view.axes.back), origin(view));
    const auto word = [&](std::int64_t q46, Rounding rounding) {
        std::int64_t out = 0;
        (Rational(q46, axis_one * one_q16) - offset).round_scaled(world_fraction, rounding, out);
        return out;
    };
    return {word(-back.max, Rounding::floor), word(-back.min, Rounding::ceiling)};
}

void fit_depth(View& view, const DepthRange& scene) {
    if (view.projection == Projection::orthographic) {
        const std::int64_t reach =
            std::max({std::int64_t{view.extent}, -scene.min, scene.max + 1});
        view.near_depth = -reach;
        view.far_depth = reach;
        return;
    }
    view.far_depth = std::max<std::int64_t>(scene.max + scene.max / 64 + 1, 1024);
    view.near_depth = std::max(scene.min - scene.min / 64 - 1, view.far_depth / 1024);
    if (view.near_depth >= view.far_depth) view.near_depth = view.far_depth / 1024;
}

RationalMatrix world_to_screen(const View& view, const MachineSpec& spec) {
    const ExactVector o = origin(view);
    const ExactVector away = negated(exact(view.axes.back));
    const Rational near = q16(view.near_depth), far = q16(view.far_depth);
    const Rational h = spec.half_px();
    const Rational scale = focal(view, spec);
    RationalMatrix m;
    m[0] = plane_row(exact(view.axes.right), o, scale);
    m[1] = plane_row(negated(exact(view.axes.up)), o, scale);
    if (view.projection == Projection::orthographic) {
        // z = h (2 (d - near) / (far - near) - 1)
        m[2] = plane_row(away, o, h * Rational(2) / (far - near));
        m[2][3] -= h * (far + near) / (far - near);
        m[3] = {0, 0, 0, 1};
    } else {
        // z = h ((far + near) d - 2 far near) / ((far - near) d),  w = d
        m[2] = plane_row(away, o, h * (far + near) / (far - near));
        m[2][3] -= h * Rational(2) * far * near / (far - near);
        m[3] = plane_row(away, o, 1);
    }
    return m;
}

RationalMatrix screen_to_world(const View& view, const MachineSpec& spec) {
    const ExactVector o = origin(view);
    const ExactVector right = exact(view.axes.right), up = exact(view.axes.up);
    const ExactVector back = exact(view.axes.back);
    const Rational near = q16(view.near_depth), far = q16(view.far_depth);
    const Rational h = spec.half_px();
    const Rational scale = focal(view, spec);
    RationalMatrix m;
    for (std::size_t k = 0; k < 3; ++k) {
        m[k][0] = right[k] / scale;
        m[k][1] = -(up[k] / scale);
        if (view.projection == Projection::orthographic) {
            // d = (far + near) / 2 + z (far - near) / (2 h)
            m[k][2] = -(back[k] * (far - near) / (Rational(2) * h));
            m[k][3] = o[k] - back[k] * (far + near) / Rational(2);
        } else {
            // 1 / d = (a - z) / b; the homogeneous point is the world point over d.
            const Rational b = Rational(2) * h * far * near / (far - near);
            m[k][2] = -(o[k] / b);
            m[k][3] = o[k] * (far + near) / (Rational(2) * far * near) - back[k];
        }
    }
    if (view.projection == Projection::orthographic) {
        m[3] = {0, 0, 0, 1};
    } else {
        m[3] = {0, 0, -((far - near) / (Rational(2) * h * far * near)),
                (far + near) / (Rational(2) * far * near)};
    }
    return m;
}

RationalMatrix multiply(const RationalMatrix& a, const RationalMatrix& b) {
    RationalMatrix m;
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = 0; j < 4; ++j) {
            for (std::size_t k = 0; k < 4; ++k) {
                if (!a[i][k].is_zero() && !b[k][j].is_zero()) m[i][j] += a[i][k] * b[k][j];
            }
        }
    }
    return m;
}

RationalMatrix observer_to_light(const View& observer, const View& light, const MachineSpec& spec,
                                 std::int64_t bias_q16) {
    RationalMatrix m = multiply(world_to_screen(light, spec), screen_to_world(observer, spec));
    const int fraction = spec.depth_fraction();
    const Rational quantum_px = fraction >= 0 ? Rational(1, std::int64_t{1} << fraction)
                                              : Rational(std::int64_t{1} << -fraction);
    const Rational bias_px = q16(bias_q16) * quantum_px;
    for (std::size_t j = 0; j < 4; ++j) m[2][j] -= bias_px * m[3][j];
    return m;
}

}  // namespace umbra78::raster
