#include "raster/shading.hpp"

#include "fixed/root.hpp"
#include "raster/shade_job.hpp"

#include <algorithm>
#include <bit>

namespace umbra78::raster {
namespace {

using fixed::Rounding;

constexpr std::int64_t one_q14 = std::int64_t{1} << unit_fraction;

// Three times the derivative at one end of a curve with ends a and b:
// 3 f'(0) = 3 (f1 - f0) - 8 g0 - 4 g1,   3 f'(1) = 3 (f1 - f0) + 4 g0 + 8 g1.
std::int64_t tangent(const std::array<std::int64_t, 4>& f, const std::array<std::int64_t, 4>& g,
                     std::size_t a, std::size_t b, bool at_b) {
    const std::int64_t chord = 3 * (f[b] - f[a]);
    return at_b ? chord + 4 * g[a] + 8 * g[b] : chord - 8 * g[a] - 4 * g[b];
}

WideVector tangent_u(const std::array<Component, 3>& w, std::size_t v, std::size_t u) {
    WideVector t{};
    for (std::size_t k = 0; k < 3; ++k) t[k] = tangent(w[k].f, w[k].gu, 2 * v, 2 * v + 1, u == 1);
    return t;
}

WideVector tangent_v(const std::array<Component, 3>& w, std::size_t v, std::size_t u) {
    WideVector t{};
    for (std::size_t k = 0; k < 3; ++k) t[k] = tangent(w[k].f, w[k].gv, u, u + 2, v == 1);
    return t;
}

// Three times the chord from corner a to corner b.
WideVector chord(const std::array<Component, 3>& w, std::size_t a, std::size_t b) {
    WideVector t{};
    for (std::size_t k = 0; k < 3; ++k) t[k] = 3 * (w[k].f[b] - w[k].f[a]);
    return t;
}

// Where an edge is a point (at a sphere's pole) its tangent is 0, and the opposite edge's is taken.
// Where both are 0 because control points coincide, the edge's chord is taken, or if that is 0 the
// opposite edge's.
UnitVector corner_normal(const std::array<Component, 3>& w, std::size_t v, std::size_t u) {
    WideVector tu = tangent_u(w, v, u), tv = tangent_v(w, v, u);
    if (is_zero(tu)) tu = tangent_u(w, 1 - v, u);
    if (is_zero(tu)) tu = chord(w, 2 * v, 2 * v + 1);
    if (is_zero(tu)) tu = chord(w, 2 - 2 * v, 3 - 2 * v);
    if (is_zero(tv)) tv = tangent_v(w, v, 1 - u);
    if (is_zero(tv)) tv = chord(w, u, u + 2);
    if (is_zero(tv)) tv = chord(w, 1 - u, 3 - u);
    return unit_vector(cross(scaled_to(tu, 30), scaled_to(tv, 30)));
}

// The bilinear mean at the centre of leaf (i, j), times 1024.
template <class Corner>
WideVector at_leaf(const std::array<Corner, 4>& c, int i, int j) {
    const std::int64_t u = 2 * i + 1, v = 2 * j + 1;
    WideVector m{};
    for (std::size_t k = 0; k < 3; ++k)
        m[k] = (32 - v) * ((32 - u) * c[0][k] + u * c[1][k]) +
               v * ((32 - u) * c[2][k] + u * c[3][k]);
    return m;
}

std::uint8_t level(std::int64_t sum_q30) {
    return static_cast<std::uint8_t>(
        std::min<std::int64_t>(fixed::round_shift(sum_q30, 30, Rounding::half_up), 255));
}

// The highlight, Q1.14, of a surface that faces the light.
std::int64_t highlight(const Cosines& c, std::int32_t shininess, ShadingRule rule) {
    std::int64_t h = 0;
    int squares = shininess;
    switch (rule) {
        case ShadingRule::phong:
            h = fixed::round_shift(2 * c.n_dot_l * c.n_dot_v, 14, Rounding::floor) - c.l_dot_v;
            break;
        case ShadingRule::blinn:
            h = c.n_dot_h;
            squares += 2;
            break;
        case ShadingRule::lambert:
        case ShadingRule::none: return 0;
    }
    h = std::clamp<std::int64_t>(h, 0, one_q14);
    for (int k = 0; k < squares; ++k) h = fixed::round_shift(h * h, 14, Rounding::half_up);
    return h;
}

// `direction` says where the viewer or a source lies.
template <class Direction>
Shades shade_by(const WideVector& n, const ShadingSpec& spec, const Material& material,
                Shadowed shadowed, Direction&& direction) {
    BySource<Cosines> all;
    const std::span used = std::span(all).first(spec.source_count);
    if (spec.rule == ShadingRule::none) {
        std::ranges::fill(used, facing_all);
        return shade(used, spec, material, shadowed);
    }
    const UnitVector to_viewer = direction(spec.viewer);
    for (std::size_t l = 0; l < used.size(); ++l) {
        used[l] = cosines(n, direction(spec.sources[l].toward), to_viewer, spec.rule);
        if (used[l].n_dot_v < 0) used[l].turn();
    }
    return shade(used, spec, material, shadowed);
}

}  // namespace

WideVector scaled_to(WideVector v, int bits) {
    std::uint64_t largest = 0;
    for (const std::int64_t c : v) largest = std::max(largest, fixed::magnitude(c));
    const int down = static_cast<int>(std::bit_width(largest)) - bits;
    if (down > 0)
        for (std::int64_t& c : v) c = fixed::round_shift(c, down, Rounding::half_up);
    return v;
}

UnitVector unit_vector(WideVector v) {
    v = scaled_to(v, 30);
    const std::int64_t length = fixed::isqrt(static_cast<std::uint64_t>(dot(v, v)));
    if (length == 0) return {};
    UnitVector out{};
    for (std::size_t k = 0; k < 3; ++k)
        out[k] = static_cast<std::int32_t>(
            fixed::round_divide(v[k] * one_q14, length, Rounding::half_up));
    return out;
}

// The eye is target + distance back, rounded half up to Q15.16 and again to the place's format.
Toward toward_eye(const View& view, hw::WordFormat object) {
    Toward t;
    t.to_point = has_eye(view);
    const Axis& back = view.axes.back;
    for (std::size_t k = 0; k < 3; ++k)
        t.direction[k] = static_cast<std::int32_t>(
            fixed::round_shift(back[k], axis_fraction - unit_fraction, Rounding::half_up));
    if (!t.to_point) return t;
    const Vector<std::int32_t> target{view.target.x, view.target.y, view.target.z};
    for (std::size_t k = 0; k < 3; ++k) {
        const std::int64_t eye_q16 =
            target[k] + fixed::round_shift(std::int64_t{view.distance} * back[k], axis_fraction,
                                           Rounding::half_up);
        t.point[k] = fixed::scale_shift(
            eye_q16, world_fraction - object.fraction - object_guard, Rounding::half_up);
    }
    return t;
}

BlockShading::BlockShading(const std::array<Component, 3>& world, const ShadingSpec& spec,
                           const Material& material)
    : spec_(spec), material_(material) {
    if (!spec.makes_normals()) return;
    for (std::size_t v = 0; v < 2; ++v) {
        for (std::size_t u = 0; u < 2; ++u) {
            normal_[2 * v + u] = corner_normal(world, v, u);
            for (std::size_t k = 0; k < 3; ++k) place_[2 * v + u][k] = world[k].f[2 * v + u];
        }
    }
}

UnitVector direction(const Toward& toward, const WideVector& place_1024) {
    if (!toward.to_point) return toward.direction;
    WideVector away{};
    for (std::size_t k = 0; k < 3; ++k) away[k] = 1024 * toward.point[k] - place_1024[k];
    return unit_vector(away);
}

Cosines cosines(const WideVector& n, const UnitVector& to_light, const UnitVector& to_viewer,
                ShadingRule rule) {
    const std::int64_t length =
        std::max<std::int64_t>(fixed::isqrt(static_cast<std::uint64_t>(dot(n, n))), 1);
    const WideVector l = wide(to_light), v = wide(to_viewer);
    const auto cosine = [&](const WideVector& d) {
        return fixed::round_divide(dot(n, d), length, Rounding::floor);
    };
    Cosines c{cosine(l), cosine(v), fixed::round_shift(dot(l, v), 14, Rounding::floor)};
    if (rule == ShadingRule::blinn)
        c.n_dot_h = cosine(wide(unit_vector({l[0] + v[0], l[1] + v[1], l[2] + v[2]})));
    return c;
}

Shades shade(std::span<const Cosines> cosines, const ShadingSpec& spec, const Material& material,
             Shadowed shadowed) {
    const std::size_t channels = std::min(spec.channels, max_channels);
    std::array<std::int64_t, max_channels> sum{};  // Q.30
    Shades shades{};
    for (std::size_t k = 0; k < channels; ++k) {
        sum[k] = material.diffuse[k] * spec.ambient_q8 * one_q14 * 256;
        shades[k].intensity = level(sum[k]);
    }
    for (std::size_t l = 0; l < cosines.size(); ++l) {
        if (cosines[l].n_dot_l <= 0 || (shadowed >> l & 1u) != 0) continue;
        const std::int64_t shine = highlight(cosines[l], material.shininess, spec.rule) * 256;
        for (std::size_t k = 0; k < channels; ++k) {
            sum[k] += spec.sources[l].level_q8[k] *
                      (material.diffuse[k] * (256 - spec.ambient_q8) * cosines[l].n_dot_l +
                       material.specular[k] * shine);
            const std::uint8_t with = level(sum[k]);
            shades[k].direct[l] = static_cast<std::uint8_t>(with - shades[k].intensity);
            shades[k].intensity = with;
        }
    }
    return shades;
}

UnitVector BlockShading::toward(const Toward& to, int i, int j) const {
    return to.to_point ? direction(to, at_leaf(place_, i, j)) : to.direction;
}

UnitVector kept_normal(const WideVector& n, const UnitVector& to_viewer) {
    const std::int32_t sign = dot(n, wide(to_viewer)) < 0 ? -1 : 1;
    UnitVector kept{};
    for (std::size_t k = 0; k < 3; ++k) kept[k] = sign * static_cast<std::int32_t>(n[k]);
    return kept;
}

UnitVector BlockShading::normal(const Sample& s) const {
    return kept_normal(scaled_to(at_leaf(normal_, s.leaf_i, s.leaf_j), kept_bits),
                       toward(spec_.viewer, s.leaf_i, s.leaf_j));
}

bool shade_job(const ShadingSpec& spec, const Material& material, ShadeJob& out) {
    bool covers = spec.rule != ShadingRule::none && !spec.viewer.to_point;
    for (std::size_t l = 0; l < spec.source_count; ++l)
        covers = covers && !spec.sources[l].toward.to_point;
    if (!covers) return false;
    out.sources = spec.source_count;
    out.channels = std::min(spec.channels, max_channels);
    out.ambient_q8 = spec.ambient_q8;
    out.by_halfway = spec.rule == ShadingRule::blinn;
    out.highlights = out.by_halfway || spec.rule == ShadingRule::phong;
    out.two_sided = false;
    out.squares = material.shininess + (out.by_halfway ? 2 : 0);
    for (std::size_t c = 0; c < out.channels; ++c) {
        out.diffuse[c] = material.diffuse[c];
        out.specular[c] = material.specular[c];
    }
    const UnitVector& v = spec.viewer.direction;
    for (std::size_t k = 0; k < 3; ++k) out.viewer[k] = v[k];
    for (std::size_t s = 0; s < out.sources; ++s) {
        ShadeSource& source = out.source[s];
        const UnitVector& l = spec.sources[s].toward.direction;
        UnitVector halfway{};
        if (out.by_halfway) halfway = unit_vector({l[0] + v[0], l[1] + v[1], l[2] + v[2]});
        for (std::size_t k = 0; k < 3; ++k) {
            source.toward[k] = l[k];
            source.halfway[k] = halfway[k];
        }
        source.l_dot_v = static_cast<std::int32_t>(
            fixed::round_shift(dot(wide(l), wide(v)), unit_fraction, Rounding::floor));
        for (std::size_t c = 0; c < out.channels; ++c)
            source.level_q8[c] = spec.sources[s].level_q8[c];
    }
    return true;
}

bool BlockShading::turns_little() const {
    for (std::size_t a = 0; a < 4; ++a)
        for (std::size_t b = 0; b < a; ++b)
            if (dot(wide(normal_[a]), wide(normal_[b])) < one_q14 * one_q14 / 2) return false;
    return true;
}

bool BlockShading::job(ShadeJob& out) const {
    if (!turns_little()) return false;
    if (!shade_job(spec_, material_, out)) return false;
    out.two_sided = true;
    for (std::size_t corner = 0; corner < 4; ++corner)
        for (std::size_t k = 0; k < 3; ++k) out.normal[corner][k] = normal_[corner][k];
    return true;
}

Shades BlockShading::kept_levels(const Sample& s) const {
    return levels_->of(leaf_number(s), std::min(spec_.channels, max_channels), spec_.source_count);
}

WideVector BlockShading::mean_normal(int i, int j) const { return at_leaf(normal_, i, j); }

Shades BlockShading::shade(int i, int j, Shadowed shadowed) const {
    return shade_by(mean_normal(i, j), spec_, material_, shadowed,
                    [&](const Toward& to) { return toward(to, i, j); });
}

Shades shade_normal(const WideVector& normal, const ShadingSpec& spec, const Material& material) {
    return shade_by(normal, spec, material, 0, [](const Toward& to) { return to.direction; });
}

}  // namespace umbra78::raster
