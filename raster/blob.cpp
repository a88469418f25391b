#include "raster/blob.hpp"

#include "fixed/rational.hpp"
#include "raster/arc.hpp"

#include <array>

namespace umbra78::raster {
namespace {

using fixed::Rational;
using fixed::Rounding;

WideVector between(const World& from, const World& to) {
    return {std::int64_t{to.x} - from.x, std::int64_t{to.y} - from.y, std::int64_t{to.z} - from.z};
}

template <class Int>
Vector<Int> widened(const WideVector& v) {
    return {Int(v[0]), Int(v[1]), Int(v[2])};
}

// False if the word leaves the world.
bool rounded(const Rational& exact, std::int32_t& out) {
    std::int64_t word = 0;
    if (!exact.round_scaled(0, Rounding::half_even, word)) return false;
    if (word < -max_world || word > max_world) return false;
    out = static_cast<std::int32_t>(word);
    return true;
}

bool rounded(const Vector<Rational>& exact, World& out) {
    return rounded(exact[0], out.x) && rounded(exact[1], out.y) && rounded(exact[2], out.z);
}

}  // namespace

void EllipseFit::Range::add(const Vector<Int>& from_origin, bool first) {
    const Int at = dot(along, from_origin);
    if (first || at < min) min = at;
    if (first || at > max) max = at;
}

EllipseFit::EllipseFit(const Patch& ground)
    : origin_(ground.control[0]), u_(between(origin_, ground.control[3])),
      v_(between(origin_, ground.control[12])) {
    const Vector<Int> u = widened<Int>(u_), v = widened<Int>(v_);
    const Int uu = dot(u, u), vv = dot(v, v), uv = dot(u, v);
    scale_ = uu * vv - uv * uv;
    for (std::size_t k = 0; k < 3; ++k) {
        s_.along[k] = vv * u[k] - uv * v[k];
        t_.along[k] = uu * v[k] - uv * u[k];
    }
}

void EllipseFit::add(const World& point) {
    const Vector<Int> from_origin = widened<Int>(between(origin_, point));
    s_.add(from_origin, !any_);
    t_.add(from_origin, !any_);
    any_ = true;
}

bool EllipseFit::fit(Ellipse& out) const {
    if (!any_ || scale_.is_zero()) return false;
    const auto half = [&](const Int& twice) {
        return Rational(Rational::Int(twice), Rational::Int(scale_) * Rational::Int(2));
    };
    const Rational s = half(s_.max + s_.min), t = half(t_.max + t_.min);
    const Rational along_u = half(s_.max - s_.min), along_v = half(t_.max - t_.min);
    Vector<Rational> centre, a, b;
    const std::array<std::int32_t, 3> o{origin_.x, origin_.y, origin_.z};
    for (std::size_t k = 0; k < 3; ++k) {
        centre[k] = Rational(o[k]) + s * Rational(u_[k]) + t * Rational(v_[k]);
        a[k] = along_u * Rational(u_[k]);
        b[k] = along_v * Rational(v_[k]);
    }
    Ellipse e;
    if (!rounded(centre, e.centre) || !rounded(a, e.a) || !rounded(b, e.b)) return false;
    const auto inside = [](std::int64_t c, std::int64_t p, std::int64_t q) {
        const auto magnitude = [](std::int64_t v) { return v < 0 ? -v : v; };
        return magnitude(c) + magnitude(p) + magnitude(q) <= max_world;
    };
    if (!inside(e.centre.x, e.a.x, e.b.x) || !inside(e.centre.y, e.a.y, e.b.y) ||
        !inside(e.centre.z, e.a.z, e.b.z))
        return false;
    out = e;
    return true;
}

void ellipse_patches(const Ellipse& e, std::span<Patch, patches_per_ellipse> out) {
    const auto at = [](std::int32_t centre, std::int32_t a, std::int32_t b,
                       const fixed::SineCosine& arc, int j) {
        const std::int64_t rim = std::int64_t{a} * arc.cosine + std::int64_t{b} * arc.sine;
        return static_cast<std::int32_t>(
            centre + fixed::round_divide(rim * j, std::int64_t{3} * axis_one,
                                         Rounding::half_even));
    };
    for (int m = 0; m < patches_per_ellipse; ++m)
        for (int n = 0; n < 16; ++n) {
            const fixed::SineCosine arc = arc_point(m, n % 4);
            out[static_cast<std::size_t>(m)].control[static_cast<std::size_t>(n)] = {
                at(e.centre.x, e.a.x, e.b.x, arc, n / 4), at(e.centre.y, e.a.y, e.b.y, arc, n / 4),
                at(e.centre.z, e.a.z, e.b.z, arc, n / 4)};
        }
}

}  // namespace umbra78::raster
