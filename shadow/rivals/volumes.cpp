#include "shadow/rivals/volumes.hpp"

namespace umbra78::shadow::rivals {
namespace {

// The plane through the eye and the light's ray at a vertex.
ScreenLine ray_line(const Centre& light, const Centre& eye, const Point& v) {
    const auto from = [&](const Centre& o) {
        const std::int64_t w = o.w;
        return raster::WideVector{o.x - w * v.x, o.y - w * v.y, o.z - w * v.z};
    };
    return line_of(seen(detail::plane_at(v, raster::cross(from(light), from(eye))), eye));
}

// Whether the eye is in a facet's volume.
enum class EyeInside : std::uint8_t { no, yes, on_border };

EyeInside eye_inside(const Setting& s, std::size_t f) {
    const int side = s.light.sides[f];
    if (side == 0) return EyeInside::no;
    EyeInside inside = EyeInside::yes;
    const auto ask = [&](const Sum& at_eye, int wanted) {
        const int is = sign(at_eye);
        if (is == 0 && inside == EyeInside::yes) inside = EyeInside::on_border;
        if (is == -wanted) inside = EyeInside::no;
    };
    ask(s.planes[f].e, -side);
    for (std::size_t k = 0; k < 3; ++k)
        ask(s.light.edge(s.mesh, f, k).e, s.light.inside(s.mesh, f, k));
    return inside;
}

// The same just before the eye toward a point: what is 0 at the eye is as at the point.
bool inside_toward(const Setting& s, std::size_t f, std::uint32_t on, std::int32_t px,
                   std::int32_t py) {
    const auto agrees = [&](const SeenPlane& plane, int wanted) {
        return !plane.e.is_zero() || meet(s.planes[on], plane).sign_at(px, py) == wanted;
    };
    bool inside = agrees(s.planes[f], -s.light.sides[f]);
    for (std::size_t k = 0; k < 3 && inside; ++k)
        inside = agrees(s.light.edge(s.mesh, f, k), s.light.inside(s.mesh, f, k));
    return inside;
}

}  // namespace

std::int32_t multiplicity(const Setting& setting, const Edge& edge) {
    std::int32_t m = 0;
    for (const HalfEdge& side : setting.mesh.half_edges.subspan(edge.first, edge.count))
        m += (side.forward ? 1 : -1) * setting.light.sides[side.facet];
    return m;
}

std::size_t find_contour(const Setting& setting, std::span<ContourEdge> out) {
    std::size_t count = 0;
    for (std::uint32_t e = 0; e < setting.mesh.edges.size(); ++e) {
        const std::int32_t m = multiplicity(setting, setting.mesh.edges[e]);
        if (m == 0) continue;
        if (count < out.size()) out[count] = {e, m};
        ++count;
    }
    return count;
}

ShadowSide::ShadowSide(const Setting& setting, const ContourEdge& edge)
    : plane_(setting.light.edges[edge.edge]), eye_side_(sign(plane_.e)),
      change_(edge.multiplicity * eye_side_) {
    const Edge& e = setting.mesh.edges[edge.edge];
    const Centre &light = setting.light.centre, &eye = setting.eye.centre;
    bounds_ = {line_of(setting.eye.edges[edge.edge]),
               ray_line(light, eye, setting.mesh.vertices[e.low]),
               ray_line(light, eye, setting.mesh.vertices[e.high])};
    inside_ = {eye_side_, eye_side_, -eye_side_};
}

Run ShadowSide::covered_run(const Space& space, int row) const {
    Run run = whole_row(space);
    for (std::size_t k = 0; k < 3 && !run.empty(); ++k)
        run = run & run_of(bounds_[k], inside_[k], space, row);
    return run;
}

std::uint64_t count_at_eye(const Setting& s, std::span<const std::uint32_t> shown,
                           std::span<std::int32_t> surfaces) {
    std::int32_t all = 0;
    for (std::size_t f = 0; f < s.mesh.facets.size(); ++f)
        all += eye_inside(s, f) == EyeInside::yes ? 1 : 0;
    std::uint64_t asked = s.mesh.facets.size();
    for (std::size_t at = 0; at < surfaces.size(); ++at)
        surfaces[at] = shown[at] == nothing_seen ? 0 : all;
    for (std::size_t f = 0; f < s.mesh.facets.size(); ++f) {
        if (eye_inside(s, f) != EyeInside::on_border) continue;
        std::size_t at = 0;
        for (int row = 0; row < s.space.size_px(); ++row)
            for (int column = 0; column < s.space.size_px(); ++column, ++at)
                if (shown[at] != nothing_seen) {
                    ++asked;
                    surfaces[at] += inside_toward(s, f, shown[at], s.space.centre(column),
                                                  s.space.centre(row)) ? 1 : 0;
                }
    }
    return asked;
}

void count_volumes(const Setting& setting, std::span<const std::uint32_t> shown,
                   std::span<const ContourEdge> contour, std::span<std::int32_t> surfaces,
                   VolumeCounts& counts) {
    const Space& space = setting.space;
    counts.facets += setting.mesh.facets.size();
    counts.edges += setting.mesh.edges.size();
    counts.contour += contour.size();
    counts.start_tests += count_at_eye(setting, shown, surfaces);
    for (const ContourEdge& edge : contour) {
        const ShadowSide side(setting, edge);
        if (!side.is_seen()) continue;
        ++counts.sides;
        std::uint32_t on = nothing_seen;
        ScreenLine line;
        for (int row = 0; row < space.size_px(); ++row) {
            const Run run = side.covered_run(space, row);
            ++counts.rows;
            for (int column = run.from; column < run.to; ++column) {
                const std::size_t at = static_cast<std::size_t>(row) *
                                           static_cast<std::size_t>(space.size_px()) +
                                       static_cast<std::size_t>(column);
                ++counts.fills;
                if (shown[at] == nothing_seen) continue;
                if (shown[at] != on) {
                    on = shown[at];
                    line = side.crossed(setting.planes[on]);
                }
                ++counts.tests;
                if (line.sign_at(space.centre(column), space.centre(row)) != side.crossed_sign())
                    continue;
                ++counts.updates;
                surfaces[at] += side.change();
            }
        }
    }
}

void mask_of_counts(const Setting& setting, std::span<const std::uint32_t> shown,
                    std::span<const std::int32_t> surfaces, std::span<std::uint8_t> mask) {
    for (std::size_t at = 0; at < mask.size(); ++at) {
        const bool is_dark = shown[at] != nothing_seen &&
                             (surfaces[at] != 0 || setting.attached(shown[at]));
        mask[at] = is_dark ? dark : lit;
    }
}

}  // namespace umbra78::shadow::rivals
