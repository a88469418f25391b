#include "shadow/rivals/links.hpp"

#include <algorithm>

namespace umbra78::shadow::rivals {

void Links::find_extents(const Setting& setting) {
    const LightPicture& picture = grid_.picture();
    std::size_t at = 0;
    for (std::size_t f = 0; f < setting.mesh.facets.size(); ++f) {
        const std::array<Point, 3> corners = setting.mesh.corners(f);
        for (int face = 0; face < picture.faces(); ++face, ++at) {
            Extent& e = extents_[at];
            if (setting.light.sides[f] == 0 || !picture.box(corners, face, e.box)) {
                e.box.face = -1;
                continue;
            }
            e.least = INT64_MAX, e.greatest = INT64_MIN;
            for (const Point& corner : corners) {
                const std::int64_t depth = picture.depth(corner, face);
                e.least = std::min(e.least, depth);
                e.greatest = std::max(e.greatest, depth);
            }
        }
    }
}

void Links::find_receivers(const Setting& setting, std::span<const std::uint32_t> shown,
                           bool visible_only) {
    const auto seen_lit = [&](std::size_t f) {
        return setting.light.sides[f] != 0 && !setting.attached(f) ? std::uint8_t{1}
                                                                   : std::uint8_t{0};
    };
    std::fill(is_receiver_.begin(), is_receiver_.end(), 0);
    if (visible_only) {
        for (const std::uint32_t f : shown)
            if (f != nothing_seen) is_receiver_[f] = seen_lit(f);
    } else {
        for (std::size_t f = 0; f < is_receiver_.size(); ++f) is_receiver_[f] = seen_lit(f);
    }
}

bool Links::linked_on(int face, std::uint32_t receiver, std::uint32_t facet) const {
    const Extent &r = extent(receiver, face), &f = extent(facet, face);
    return r.box.face >= 0 && f.box.face >= 0 && r.box.overlaps(f.box) && f.least < r.greatest;
}

namespace {

bool is_before_plane(const Setting& s, std::uint32_t receiver, std::uint32_t facet) {
    const Plane plane = s.mesh.plane(receiver);
    for (const Point& corner : s.mesh.corners(facet))
        if (sign(plane.at(corner)) == s.light.sides[receiver]) return true;
    return false;
}

}  // namespace

template <class Visit>
void Links::for_links_of(std::uint32_t receiver, LinkCounts& counts, Visit&& visit) const {
    for (int face = 0; face < picture().faces(); ++face) {
        const Extent& r = extent(receiver, face);
        if (r.box.face < 0) continue;
        grid_.for_cells(r.box, [&](std::size_t cell) {
            for (const std::uint32_t f : grid_.facets_in(cell)) {
                if (f == receiver) continue;
                const Extent& caster = extent(f, face);
                ++counts.box_tests;
                if (!r.box.overlaps(caster.box)) continue;
                const LightPlace lower{face, std::max(r.box.u0, caster.box.u0),
                                       std::max(r.box.v0, caster.box.v0)};
                if (grid_.cell_at(lower) != cell) continue;
                ++counts.depth_tests;
                if (caster.least >= r.greatest) continue;
                bool linked_before = false;
                for (int g = 0; g < face && !linked_before; ++g)
                    linked_before = linked_on(g, receiver, f);
                if (!linked_before) visit(f);
            }
        });
    }
}

LinkStatus Links::build(const Setting& setting, std::span<const std::uint32_t> shown,
                        const LinkOptions& options, std::span<std::byte> memory,
                        std::size_t& needed, LinkCounts& counts) {
    const std::size_t facets = setting.mesh.facets.size();
    const auto faces =
        static_cast<std::size_t>(LightPicture(setting.light.centre).faces());
    Carver carver(memory);
    extents_ = carver.take<Extent>(facets * faces);
    is_receiver_ = carver.take<std::uint8_t>(facets);
    starts_ = carver.take<std::uint32_t>(facets + 1);
    std::size_t grid_bytes = 0;
    grid_.build(setting, options.cells, {}, grid_bytes);
    const std::span grid_memory = carver.take<std::byte>(grid_bytes);
    needed = carver.used();
    if (!carver.fits() || !grid_.build(setting, options.cells, grid_memory, grid_bytes))
        return LinkStatus::no_room;
    find_extents(setting);
    find_receivers(setting, shown, options.visible_only);
    counts.entries += grid_.entries();
    for (std::size_t cell = 0; cell < grid_.cells(); ++cell)
        counts.sectors += grid_.facets_in(cell).empty() ? 0 : 1;

    Carver rest(memory);
    rest.take<std::byte>(carver.used());
    rest.take<std::uint32_t>(0);
    const std::size_t room = (memory.size() - std::min(memory.size(), rest.used())) / 4;
    items_ = rest.take<std::uint32_t>(room);
    std::size_t links = 0;
    for (std::uint32_t f = 0; f < facets; ++f) {
        starts_[f] = static_cast<std::uint32_t>(links);
        if (is_receiver_[f] == 0) continue;
        ++counts.receivers;
        for_links_of(f, counts, [&](std::uint32_t caster) {
            if (options.before_plane) {
                ++counts.plane_tests;
                if (!is_before_plane(setting, f, caster)) return;
            }
            if (links < items_.size()) items_[links] = caster;
            ++links;
        });
        counts.longest = std::max<std::uint64_t>(counts.longest, links - starts_[f]);
    }
    starts_[facets] = static_cast<std::uint32_t>(links);
    counts.links += links;
    carver.take<std::uint32_t>(links);
    needed = carver.used();
    return links <= items_.size() ? LinkStatus::ok : LinkStatus::no_room;
}

}  // namespace umbra78::shadow::rivals
