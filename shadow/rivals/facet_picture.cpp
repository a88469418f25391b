#include "shadow/rivals/facet_picture.hpp"

#include <algorithm>

namespace umbra78::shadow::rivals {
namespace {

// A side of a box has this many bits and a sign; of them behind the point, for a light at a place
// whose picture has quotients, and for a direction, whose picture has words.
inline constexpr int box_bits = 30;
inline constexpr int quotient_fraction = 20;
inline constexpr int word_fraction = 4;
// Of a quotient's divisor. The dividend is kept within 2^box_bits quotients.
inline constexpr int divisor_bits = 31;
static_assert(divisor_bits + box_bits < 63);
static_assert(word_bits + 2 + word_fraction < box_bits);

inline constexpr std::int32_t widest = std::int32_t{1} << box_bits;
inline constexpr PictureBox everything{-widest, widest, -widest, widest};

// [from, to] has X / W in it, where X is between x and x + rest, and W between w and w + rest.
struct Interval {
    std::int32_t from, to;
};

Interval interval(std::int64_t x, std::int64_t w, std::int64_t rest, int fraction) {
    const std::int64_t most = w << (box_bits - fraction);
    const std::int64_t one = std::int64_t{1} << fraction;
    const std::int64_t low = std::clamp(x, -most, most), high = std::clamp(x + rest, -most, most);
    const std::int64_t from =
        fixed::round_divide(low * one, low < 0 ? w : w + rest, fixed::Rounding::floor);
    const std::int64_t to =
        fixed::round_divide(high * one, high < 0 ? w + rest : w, fixed::Rounding::ceiling);
    return {static_cast<std::int32_t>(from), static_cast<std::int32_t>(to)};
}

inline constexpr PictureBox nothing{widest, -widest, widest, -widest};

// A place of the picture, u = X / W and v = Y / W, of which the leading bits are known: X is x, or
// between x and x + 1 if rest is 1, and so on.
struct RoughPlace {
    std::int64_t x, y, w, rest;
};

void widen(PictureBox& box, const RoughPlace& at, int fraction) {
    const Interval u = interval(at.x, at.w, at.rest, fraction);
    const Interval v = interval(at.y, at.w, at.rest, fraction);
    box = {std::min(box.u0, u.from), std::max(box.u1, u.to), std::min(box.v0, v.from),
           std::max(box.v1, v.to)};
}

// Where two lines meet.
RoughPlace meeting_of(const LightLine& p, const LightLine& q,
                      const std::array<std::size_t, 3>& axis) {
    const auto minor = [&](std::size_t k) {
        const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
        return full_product(p.v[i], q.v[j]) - full_product(p.v[j], q.v[i]);
    };
    auto x = minor(axis[0]), y = minor(axis[1]), w = minor(axis[2]);
    if (w.is_negative()) x = -x, y = -y, w = -w;
    const int shift = std::max(0, w.bit_length() - divisor_bits);
    return {(x >> shift).to_int64(), (y >> shift).to_int64(), (w >> shift).to_int64(),
            shift > 0 ? 1 : 0};
}

// From the light's place.
std::array<std::int64_t, 3> from_light(const Centre& light, const Point& p) {
    return {std::int64_t{p.x} - light.x, std::int64_t{p.y} - light.y,
            std::int64_t{p.z} - light.z};
}

}  // namespace

FacetPicture::FacetPicture(const Setting& setting, std::uint32_t facet) {
    const Centre& light = setting.light.centre;
    is_direction_ = light.w == 0;
    if (is_direction_) {
        const auto [d, a, b] = LightPicture(light).axes();
        d_ = d, a_ = a, b_ = b, has_boxes_ = true;
        return;
    }
    std::int64_t farthest = 0;
    for (std::size_t d = 0; d < 3; ++d) {
        for (const std::int64_t sense : {1, -1}) {
            std::int64_t nearest = INT64_MAX;
            for (const Point& p : setting.mesh.corners(facet))
                nearest = std::min(nearest, sense * from_light(light, p)[d]);
            if (nearest <= farthest) continue;
            farthest = nearest, has_boxes_ = true;
            d_ = d, a_ = (d + 1) % 3, b_ = (d + 2) % 3, sense_ = sense;
        }
    }
}

// False if some of it is not before the light.
bool FacetPicture::add_facet(const Setting& setting, std::uint32_t facet, PictureBox& box) const {
    const Centre& light = setting.light.centre;
    const std::array<std::int64_t, 3> l{light.x, light.y, light.z};
    for (const Point& p : setting.mesh.corners(facet)) {
        RoughPlace at{};
        if (is_direction_) {
            const std::array<std::int64_t, 3> v{p.x, p.y, p.z};
            const std::int64_t turn = l[d_] < 0 ? -1 : 1;
            at = {turn * (v[a_] * l[d_] - v[d_] * l[a_]), turn * (v[b_] * l[d_] - v[d_] * l[b_]),
                  turn * l[d_], 0};
        } else {
            const auto v = from_light(light, p);
            at = {sense_ * v[a_], sense_ * v[b_], sense_ * v[d_], 0};
        }
        if (at.w <= 0) return false;
        widen(box, at, is_direction_ ? word_fraction : quotient_fraction);
    }
    return true;
}

PictureBox FacetPicture::of_facets(const Setting& setting,
                                   std::span<const std::uint32_t> facets) const {
    PictureBox box = nothing;
    for (const std::uint32_t f : facets)
        if (!add_facet(setting, f, box)) return everything;
    return box;
}

PictureBox FacetPicture::of_piece(const LightLines& lines, std::span<const LineId> piece) const {
    using Axes = std::array<std::size_t, 3>;
    const Axes axes = is_direction_ ? Axes{0, 1, 2} : Axes{a_, b_, d_};
    PictureBox box = nothing;
    for (std::size_t i = 0; i < piece.size(); ++i) {
        const LineId p = piece[i], q = piece[i + 1 < piece.size() ? i + 1 : 0];
        widen(box, meeting_of(lines.line(p), lines.line(q), axes),
              is_direction_ ? word_fraction : quotient_fraction);
    }
    return box;
}

}  // namespace umbra78::shadow::rivals
