#include "raster/facet.hpp"

#include "fixed/overflow.hpp"
#include "raster/block_form.hpp"

#include <algorithm>
#include <bit>

namespace umbra78::raster {
namespace {

using fixed::Rounding;

std::uint64_t word(std::int64_t v) { return static_cast<std::uint64_t>(v); }

// How far a place lies within plane k of the band: X + limit W of even ones, limit W - X of odd
// ones, for the axes Z, X, Y. Words of 55 bits and limits of 31 leave it in 63 bits.
constexpr std::size_t planes = 6;

std::int64_t within(const ScreenPlace& p, const GuardBand& band, std::size_t plane) {
    constexpr std::array<std::size_t, 3> axes{2, 0, 1};
    const std::size_t axis = axes[plane / 2];
    const std::int64_t limit = band[axis] * p[3];
    return plane % 2 == 0 ? limit + p[axis] : limit - p[axis];
}

unsigned outside(const ScreenPlace& p, const GuardBand& band) {
    unsigned bits = 0;
    for (std::size_t k = 0; k < planes; ++k) bits |= within(p, band, k) < 0 ? 1u << k : 0u;
    return bits;
}

// from + half_up((to - from) part / whole), 0 <= part <= whole.
std::int64_t between(std::int64_t from, std::int64_t to, std::int64_t part, std::int64_t whole) {
    const std::int64_t way = to - from;
    const fixed::QuotientRemainder q = fixed::divide_wide(
        fixed::multiply_wide(fixed::magnitude(way), word(part)), word(whole));
    const std::uint64_t rest = 2 * q.remainder;
    const bool up = way < 0 ? rest > word(whole) : rest >= word(whole);
    const auto step = static_cast<std::int64_t>(q.quotient + (up ? 1 : 0));
    return way < 0 ? from - step : from + step;
}

FacetVertex crossing(const FacetVertex& inner, std::int64_t inside, const FacetVertex& outer,
                     std::int64_t beyond) {
    FacetVertex v;
    const auto all = [&](auto FacetVertex::*member) {
        for (std::size_t k = 0; k < (v.*member).size(); ++k)
            (v.*member)[k] =
                between((inner.*member)[k], (outer.*member)[k], inside, inside - beyond);
    };
    all(&FacetVertex::screen);
    all(&FacetVertex::world);
    all(&FacetVertex::normal);
    return v;
}

// The part of a polygon within a plane, from its first vertex on (Sutherland and Hodgman, 1974).
FacetPolygon cut_by(const FacetPolygon& p, const GuardBand& band, std::size_t plane) {
    FacetPolygon out;
    for (std::size_t k = 0; k < p.count; ++k) {
        const FacetVertex &here = p.vertex[k], &next = p.vertex[(k + 1) % p.count];
        const std::int64_t d = within(here.screen, band, plane);
        const std::int64_t e = within(next.screen, band, plane);
        if (d >= 0) out.vertex[out.count++] = here;
        if (d >= 0 && e < 0) out.vertex[out.count++] = crossing(here, d, next, e);
        if (d < 0 && e >= 0) out.vertex[out.count++] = crossing(next, e, here, d);
    }
    return out;
}

WideVector weighted(const std::array<std::int64_t, 3>& t, const WideVector& a, const WideVector& b,
                    const WideVector& c) {
    WideVector sum{};
    for (std::size_t k = 0; k < 3; ++k) sum[k] = t[0] * a[k] + t[1] * b[k] + t[2] * c[k];
    return sum;
}

WideVector minus(const WideVector& a, const WideVector& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

// The words less as many low bits as bring the largest to `bits` bits.
std::array<std::int64_t, 3> cut_to(const std::array<std::int64_t, 3>& v, int bits) {
    const std::int64_t largest = std::max({v[0], v[1], v[2]});
    const int down = std::max(0, static_cast<int>(std::bit_width(word(largest))) - bits);
    return {fixed::floor_shift(v[0], down), fixed::floor_shift(v[1], down),
            fixed::floor_shift(v[2], down)};
}

}  // namespace

GuardBand guard_band(const MachineSpec& spec, bool affine) {
    const int fraction = spec.depth_fraction();
    if (!affine) {
        const std::int64_t margin = fraction >= 0 ? 1 : std::int64_t{1} << -fraction;
        return {guard_px, guard_px, spec.half_px() + margin};
    }
    const std::int64_t margin = fraction >= 0 ? std::int64_t{1} << fraction : 1;
    return {guard_px * pixel_units, guard_px * pixel_units,
            (spec.depth_offset() + margin) << depth_guard(spec)};
}

bool FacetPolygon::clip(const GuardBand& band, bool& cut) {
    unsigned any = 0, all = ~0u;
    for (std::size_t k = 0; k < count; ++k) {
        const unsigned bits = outside(vertex[k].screen, band);
        any |= bits;
        all &= bits;
    }
    cut = any != 0;
    if (all != 0) return false;
    for (std::size_t plane = 0; cut && plane < planes && count > 0; ++plane)
        *this = cut_by(*this, band, plane);
    return count >= 3;
}

// How much of the sample is each corner's: the edges' values there over the area, in perspective
// each times the other corners' W.
FacetShading::Weights FacetShading::weights(const Sample& s) const {
    const auto& [a, b, c] = triangle_.screen;
    const std::int64_t sign = detail::turn(a, b, c.x, c.y) < 0 ? -1 : 1;
    const auto e = cut_to({sign * detail::turn(b, c, s.x, s.y), sign * detail::turn(c, a, s.x, s.y),
                           sign * detail::turn(a, b, s.x, s.y)},
                          24);
    const auto& v = triangle_.vertex;
    auto w = cut_to({v[0]->screen[3], v[1]->screen[3], v[2]->screen[3]}, 14);
    for (std::int64_t& k : w) k = std::max<std::int64_t>(k, 1);
    const std::int64_t of_a = e[0] * w[1] * w[2], of_b = e[1] * w[2] * w[0],
                       of_c = e[2] * w[0] * w[1];
    const auto part = [&](std::int64_t of) {
        return fixed::round_divide(1024 * of, of_a + of_b + of_c, Rounding::half_up);
    };
    const std::int64_t tb = part(of_b), tc = part(of_c);
    return {1024 - tb - tc, tb, tc};
}

const UnitVector& FacetShading::side() const {
    if (!has_side_)
        side_ = unit_vector(cross(minus(facet_[1], facet_[0]), minus(facet_[2], facet_[0])));
    has_side_ = true;
    return side_;
}

Shades FacetShading::shade(const Sample& s, Shadowed shadowed) const {
    bool to_points = spec_.viewer.to_point;
    for (const ShadingSource& source : std::span(spec_.sources).first(spec_.source_count))
        to_points = to_points || source.toward.to_point;
    if (!flat_ || to_points || shadowed != 0) return shade_sample(s, shadowed, to_points);
    if (!has_lit_) lit_ = shade_sample(s, 0, false);
    has_lit_ = true;
    return lit_;
}

Shades FacetShading::shade_sample(const Sample& s, Shadowed shadowed, bool to_points) const {
    const std::span sources = std::span(spec_.sources).first(spec_.source_count);
    BySource<Cosines> all;
    const std::span used = std::span(all).first(sources.size());
    if (spec_.rule == ShadingRule::none) {
        std::ranges::fill(used, facing_all);
        return raster::shade(used, spec_, material_, shadowed);
    }
    Weights t{1024, 0, 0};
    const auto& v = triangle_.vertex;
    if (!flat_ || to_points) t = weights(s);
    WideVector place{};
    if (to_points) place = weighted(t, v[0]->world, v[1]->world, v[2]->world);
    const UnitVector viewer = direction(spec_.viewer, place);
    const WideVector own = wide(side());
    WideVector n = flat_ ? own : weighted(t, v[0]->normal, v[1]->normal, v[2]->normal);
    // The normal is turned to the facet's side that the viewer sees.
    if ((dot(n, own) < 0) != (dot(own, wide(viewer)) < 0))
        for (std::int64_t& k : n) k = -k;
    for (std::size_t l = 0; l < used.size(); ++l)
        used[l] = cosines(n, direction(sources[l].toward, place), viewer, spec_.rule);
    return raster::shade(used, spec_, material_, shadowed);
}

UnitVector FacetShading::normal(const Sample&) const {
    const WideVector& a = facet_[0];
    return kept_normal(wide(side()),
                       direction(spec_.viewer, {1024 * a[0], 1024 * a[1], 1024 * a[2]}));
}

FacetWalk::FacetWalk(const MachineSpec& spec, const MatrixWords& matrix, WordFormat object,
                     hw::UnitWork work, bool shades, const FacetForm* form)
    : spec_(spec), unit_(spec, matrix, object, work), object_(object), shades_(shades),
      band_(guard_band(spec, matrix.affine)),
      form_(form != nullptr ? *form : fastest_block_form().facets),
      by_lanes_(!matrix.divides() && work == hw::UnitWork{} && make_job()) {}

// An affine view's rows, where they shift and round as the lanes do.
bool FacetWalk::make_job() {
    const bool half_up = spec_.transform_rounding == Rounding::half_up;
    if (!half_up && spec_.transform_rounding != Rounding::floor) return false;
    job_.object_down = world_fraction - object_.fraction;
    const auto limits = cube_limits(spec_);
    for (std::size_t r = 0; r < 3; ++r) {
        const int fraction = r == 2 ? spec_.depth_fraction() + depth_guard(spec_) : raster_fraction;
        VertexRow& row = job_.row[r];
        row.down = hw::affine_shift(unit_.matrix(), static_cast<hw::Row>(r), spec_, object_,
                                    fraction);
        if (row.down < 1 || row.down > 62) return false;
        for (std::size_t c = 0; c < 3; ++c) row.coefficient[c] = unit_.matrix().word[r][c];
        row.constant = std::int64_t{unit_.matrix().word[r][3]} * object_.one_word() +
                       (half_up ? std::int64_t{1} << (row.down - 1) : 0);
        row.edge = limits[r];
        row.band = band_[r];
    }
    return job_.object_down >= 1;
}

void FacetWalk::begin(const Mesh& mesh) {
    mesh_ = mesh;
    ++mesh_number_;
}

const FacetWalk::Seen& FacetWalk::see(std::uint32_t number) {
    Seen& s = seen_[number % seen_.size()];
    if (s.number == number && s.mesh == mesh_number_) return s;
    fixed::require(number < mesh_.vertices.size(), "facet: no such vertex");
    const hw::Words words = to_object_words(mesh_.vertices[number], object_);
    s.number = number;
    s.mesh = mesh_number_;
    s.screen = !unit_.matrix().divides() ? affine_place(unit_, words)
                                     : homogeneous_place(words, unit_.matrix(), spec_, object_);
    s.outside = outside(s.screen, band_);
    s.has_corner = s.outside == 0 && to_corner(s.screen, s.corner);
    if (shades_)
        s.world = {std::int64_t{words.x} * (1 << object_guard),
                   std::int64_t{words.y} * (1 << object_guard),
                   std::int64_t{words.z} * (1 << object_guard)};
    return s;
}

void FacetWalk::fill(const Facet& facet, std::size_t k, const Seen& seen) {
    FacetVertex& v = polygon_.vertex[k];
    v.screen = seen.screen;
    if (!shades_) return;
    v.world = facet_[k] = seen.world;
    if (facet.normal[k] == Facet::flat) return;
    fixed::require(facet.normal[k] < mesh_.normals.size(), "facet: no such normal");
    v.normal = wide(mesh_.normals[facet.normal[k]]);
}

FacetWalk::Outcome FacetWalk::project(const Facet& facet) {
    std::array<Seen, 3> seen;  // copies: two vertices may want the same place
    for (std::size_t k = 0; k < 3; ++k) seen[k] = see(facet.vertex[k]);
    if ((seen[0].outside & seen[1].outside & seen[2].outside) != 0) return Outcome::outside;
    polygon_.count = 3;
    for (std::size_t k = 0; k < 3; ++k) fill(facet, k, seen[k]);
    if ((seen[0].outside | seen[1].outside | seen[2].outside) == 0) {
        for (std::size_t k = 0; k < 3; ++k) {
            if (!seen[k].has_corner) return Outcome::unresolved;
            corner_[k] = seen[k].corner;
        }
        return Outcome::ready;
    }
    bool cut = false;
    if (!polygon_.clip(band_, cut)) return Outcome::outside;
    for (std::size_t k = 0; k < polygon_.count; ++k)
        if (!to_corner(polygon_.vertex[k].screen, corner_[k])) return Outcome::unresolved;
    return Outcome::cut;
}

// Within the band every quotient fits; only W may have none.
bool FacetWalk::to_corner(const ScreenPlace& p, Corner& out) const {
    const auto narrow = [](std::int64_t v) { return static_cast<std::int32_t>(v); };
    if (!unit_.matrix().divides()) {
        out = {narrow(p[0]), narrow(p[1]), narrow(p[2])};
        return true;
    }
    const auto quotient = [&](std::size_t axis, int fraction) {
        return fixed::divide(p[axis], p[3], fraction, 31, Rounding::half_up);
    };
    const fixed::Quotient x = quotient(0, raster_fraction), y = quotient(1, raster_fraction);
    const fixed::Quotient z = quotient(2, spec_.depth_fraction() + depth_guard(spec_));
    for (const fixed::Quotient& q : {x, y, z})
        if (q.status != fixed::DivideStatus::ok) return false;
    out = {narrow(x.value), narrow(y.value), narrow(z.value)};
    return true;
}

void FacetWalk::see_run(std::uint32_t first, SeenVertex* out) {
    const std::size_t count = std::min<std::size_t>(run, mesh_.vertices.size() - first);
    if (!by_lanes_) {
        for (std::uint32_t k = 0; k < count; ++k) out[k] = corner_of(first + k);
        return;
    }
    if (count == run) return form_.see(job_, &mesh_.vertices[first], out);
    std::array<World, run> last{};
    std::copy_n(mesh_.vertices.begin() + first, count, last.begin());
    form_.see(job_, last.data(), out);
}

SeenVertex FacetWalk::corner_of(std::uint32_t number) {
    const Seen& s = see(number);
    if (!s.has_corner) return {0, 0, 0, SeenVertex::beyond_band};
    const auto limits = cube_limits(spec_);
    const std::array<std::int32_t, 3> at{s.corner.x, s.corner.y, s.corner.z};
    SeenVertex out{at[0], at[1], at[2], 0};
    for (std::size_t axis = 0; axis < 3; ++axis)
        out.outside |= (at[axis] < -limits[axis] ? 1u << 2 * axis : 0) |
                       (at[axis] > limits[axis] ? 2u << 2 * axis : 0);
    return out;
}

bool FacetWalk::footprint(Footprint& out) const {
    ScreenBounds bounds{};
    const auto first = corner_.begin(), last = first + polygon_.count;
    const auto hold = [&](Bounds& b, std::int32_t Corner::*member) {
        const auto [min, max] = std::minmax_element(
            first, last, [&](const Corner& p, const Corner& q) { return p.*member < q.*member; });
        b.min = (*min).*member;
        b.max = (*max).*member;
    };
    hold(bounds[0], &Corner::x);
    hold(bounds[1], &Corner::y);
    hold(bounds[2], &Corner::z);
    if (block_action(bounds, spec_) == BlockAction::outside) return false;
    out = raster::footprint(bounds, spec_);
    return true;
}

FacetTriangle FacetWalk::triangle(std::size_t k) const {
    return {{&polygon_.vertex[0], &polygon_.vertex[k + 1], &polygon_.vertex[k + 2]},
            {corner_[0], corner_[k + 1], corner_[k + 2]}};
}

}  // namespace umbra78::raster
