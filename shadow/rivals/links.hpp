// Links: to each facet the facets that can shadow it.
//
// The pre-process of Bouknight & Kelley ("An algorithm for producing half-tone computer graphics
// presentations with shadows and movable light sources", 1970), as Crow describes it ("Shadow
// Algorithms for Computer Graphics", 1977, section V). Facet F is linked to receiver R if, in the
// light's picture (light_grid.hpp),
//
//   their boxes overlap, borders included, and
//   F's least depth from the light is below R's greatest,
//
// on a face of the picture at least; F is not R, and the light does not see it edge-on. A facet
// that shadows a point of R has both, so no shadow is lost; most links cast none.
//
// Neither condition knows R's plane, and on a curved surface most links are to neighbours that lie
// behind it. The variant `before_plane` asks for a vertex of F strictly on the light's side of R's
// plane, too: one without shadows nothing of R. It is not Bouknight & Kelley's.
//
// Without sectors every receiver is tested with every facet. Sectors are the cells of a grid over
// the picture. A facet enters each cell that its box touches, and only facets of one cell are
// tested. A pair that meets in several cells is tested in each; the cell of the lower corner of
// what their boxes share makes the link, so that it is made once.
#pragma once

#include "shadow/rivals/visible.hpp"
#include "shadow/rivals/light_grid.hpp"

#include <cstdint>
#include <span>

namespace umbra78::shadow::rivals {

struct LinkOptions {
    // The side of a face's grid, a power of two; 0: by the number of facets.
    int cells = 0;
    // Receivers are the facets that are shown, else all whose seen side is lit.
    bool visible_only = true;
    // Links only facets with a vertex strictly on the light's side of the receiver's plane.
    bool before_plane = false;
};

struct LinkCounts {
    std::uint64_t receivers = 0;    // facets with a list
    std::uint64_t sectors = 0;      // cells with a facet
    std::uint64_t entries = 0;      // of facets in cells
    std::uint64_t box_tests = 0;    // of a receiver and a facet in a cell
    std::uint64_t depth_tests = 0;  // of pairs whose boxes overlap, each once a face
    std::uint64_t plane_tests = 0;  // of a pair with the receiver's plane (before_plane)
    std::uint64_t links = 0;        // made
    std::uint64_t longest = 0;      // list
};

enum class LinkStatus : std::uint8_t {
    ok,
    no_room,  // `needed` says how many bytes to come back with; see there
};

class Links {
public:
    // `shown`: of each pixel (visible.hpp); it may be empty if options.visible_only is not set.
    // `needed` is what a refused call lacked: at first what is there before the links, and with
    // that, or more, all of it. The second call may so be refused, the third is not.
    LinkStatus build(const Setting& setting, std::span<const std::uint32_t> shown,
                     const LinkOptions& options, std::span<std::byte> memory, std::size_t& needed,
                     LinkCounts& counts);

    // The facets that can shadow a facet; none if it is no receiver.
    std::span<const std::uint32_t> of(std::size_t facet) const {
        return items_.subspan(starts_[facet], starts_[facet + 1] - starts_[facet]);
    }
    const LightPicture& picture() const { return grid_.picture(); }

private:
    // A facet in the light's picture, on one face; face -1 if it is not there.
    struct Extent {
        LightBox box;
        std::int64_t least, greatest;  // depth
    };

    void find_extents(const Setting& setting);
    void find_receivers(const Setting& setting, std::span<const std::uint32_t> shown,
                        bool visible_only);
    template <class Visit>
    void for_links_of(std::uint32_t receiver, LinkCounts& counts, Visit&& visit) const;
    const Extent& extent(std::uint32_t facet, int face) const {
        return extents_[facet * static_cast<std::size_t>(picture().faces()) +
                        static_cast<std::size_t>(face)];
    }
    bool linked_on(int face, std::uint32_t receiver, std::uint32_t facet) const;

    LightGrid grid_;
    std::span<Extent> extents_;
    std::span<std::uint8_t> is_receiver_;
    std::span<std::uint32_t> starts_, items_;
};

}  // namespace umbra78::shadow::rivals
