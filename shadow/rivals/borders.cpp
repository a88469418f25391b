#include "shadow/rivals/borders.hpp"

#include <algorithm>

namespace umbra78::shadow::rivals {
namespace {

// On which side of a receiver's plane vertices are: 1 on the light's.
class SideOf {
public:
    SideOf(const Setting& s, std::uint32_t receiver, BorderCounts& counts)
        : mesh_(s.mesh), plane_(s.mesh.plane(receiver)), toward_(s.light.sides[receiver]),
          counts_(counts) {}
    int operator()(std::uint32_t vertex) const {
        ++counts_.signs;
        return sign(plane_.at(mesh_.vertices[vertex])) * toward_;
    }

private:
    const Mesh& mesh_;
    Plane plane_;
    int toward_;
    BorderCounts& counts_;
};

bool boxes_overlap(const Setting& s, const LightPicture& picture, std::uint32_t receiver,
                   const Edge& edge) {
    const Point &a = s.mesh.vertices[edge.low], &b = s.mesh.vertices[edge.high];
    LightBox of_edge{}, of_receiver{};
    for (int face = 0; face < picture.faces(); ++face)
        if (picture.box({a, b, b}, face, of_edge) &&
            picture.box(s.mesh.corners(receiver), face, of_receiver) &&
            of_edge.overlaps(of_receiver))
            return true;
    return false;
}

// Whether an edge of a facet lies in the receiver's plane and is none of the receiver's own. No run
// on the receiver crosses those.
bool touches_inside(const Setting& s, std::uint32_t receiver, std::uint32_t facet,
                    const std::array<int, 3>& at) {
    const auto& own = s.mesh.sides[receiver];
    for (std::size_t k = 0; k < 3; ++k) {
        if (at[k] != 0 || at[(k + 1) % 3] != 0) continue;
        const std::uint32_t e = s.mesh.sides[facet][k] / 2;
        if (e != own[0] / 2 && e != own[1] / 2 && e != own[2] / 2) return true;
    }
    return false;
}

// visit(border) of each border of a receiver that is at, or is, a facet linked to it.
template <class Visit>
void for_borders_at(const Setting& s, const LightPicture& picture, std::uint32_t receiver,
                    std::uint32_t facet, std::span<std::uint32_t> last_receiver,
                    BorderCounts& counts, Visit&& visit) {
    const SideOf side_of(s, receiver, counts);
    const auto& vertex = s.mesh.facets[facet].vertex;
    const std::array<int, 3> at{side_of(vertex[0]), side_of(vertex[1]), side_of(vertex[2])};
    if (std::max({at[0], at[1], at[2]}) <= 0) return;
    const bool through = std::min({at[0], at[1], at[2]}) < 0;
    if (through || touches_inside(s, receiver, facet, at)) {
        ++counts.facets;
        visit(Border{facet, -s.light.sides[facet], Border::own_plane, false});
    }
    for (std::uint8_t k = 0; k < 3; ++k) {
        const int a = at[k], b = at[(k + 1) % 3];
        const std::uint32_t e = s.mesh.sides[facet][k] / 2;
        if (std::max(a, b) <= 0 || last_receiver[e] == receiver) continue;
        last_receiver[e] = receiver;
        const std::int32_t m = multiplicity(s, s.mesh.edges[e]);
        if (m == 0) continue;
        ++counts.box_tests;
        if (!boxes_overlap(s, picture, receiver, s.mesh.edges[e])) continue;
        ++counts.edges;
        visit(Border{facet, -m, k, a > 0 && b > 0});
    }
}

}  // namespace

bool Borders::build(const Setting& setting, const Links& links, std::span<std::byte> memory,
                    std::size_t& needed, BorderCounts& counts) {
    const std::size_t facets = setting.mesh.facets.size();
    Carver carver(memory);
    starts_ = carver.take<std::uint32_t>(facets + 1);
    last_receiver_ = carver.take<std::uint32_t>(setting.mesh.edges.size());
    needed = carver.used();
    if (!carver.fits()) return false;
    std::fill(last_receiver_.begin(), last_receiver_.end(), UINT32_MAX);
    Carver rest(memory);
    rest.take<std::byte>(carver.used());
    rest.take<Border>(0);
    items_ = rest.take<Border>((memory.size() - std::min(memory.size(), rest.used())) /
                               sizeof(Border));
    std::size_t count = 0;
    for (std::uint32_t r = 0; r < facets; ++r) {
        starts_[r] = static_cast<std::uint32_t>(count);
        for (const std::uint32_t f : links.of(r))
            for_borders_at(setting, links.picture(), r, f, last_receiver_, counts,
                           [&](const Border& border) {
                               if (count < items_.size()) items_[count] = border;
                               ++count;
                           });
        counts.longest = std::max<std::uint64_t>(counts.longest, count - starts_[r]);
    }
    starts_[facets] = static_cast<std::uint32_t>(count);
    carver.take<Border>(count);
    needed = carver.used();
    return count <= items_.size();
}

bool crosses(const Setting& s, std::uint32_t on, const Border& border, int row, const Run& run,
             BorderCrossing& out, CrossingCounts& counts) {
    const std::uint32_t f = border.facet;
    const auto project = [&](const SeenPlane& plane) {
        ++counts.projected;
        return RowLine(meet(s.planes[on], plane), s.space, row);
    };
    const bool own = border.side == Border::own_plane;
    const RowLine line = project(own ? s.planes[f] : s.light.edge(s.mesh, f, border.side));
    const Crossing at = crossing_in(line, run, s.space, row);
    if (at.column == run.to) return false;
    // Inside the facet's other edges. An edge in the plane of `on` is crossed where the facet's own
    // plane is; its sign is 0 there, and is not asked for.
    for (std::uint8_t k = 0; k < 3; ++k) {
        if (k == border.side) continue;
        ++counts.tests;
        const int is = sign_where(line, project(s.light.edge(s.mesh, f, k)));
        if (is == -s.light.inside(s.mesh, f, k)) return false;
    }
    if (!own && !border.wholly_before) {
        ++counts.tests;
        if (sign_where(line, project(s.planes[f])) != -s.light.sides[f]) return false;
    }
    ++counts.crossings;
    out = {at.column, at.up ? border.change : -border.change, line};
    return true;
}

}  // namespace umbra78::shadow::rivals
