// Borders: where, on a facet's plane, the number of surfaces before it changes.
//
// Let n be the number of facets between the light and a point of receiver R's plane, for a point
// that moves along a row of the screen on R. A facet F counts while the point is inside F (as the
// light sees it) and behind F's plane. So n changes in two ways only.
//
// At an edge. The point passes the plane through the light and edge e, between e's ends, and e is
//   before the point. Each facet at e then comes or goes, and as they lie before the point
//   together, what is left is e's multiplicity m (volumes.hpp): n changes by -m toward the
//   positive side of e's plane, by m the other way. Only contour edges (m not 0) change anything:
//   Crow's advice.
// At a facet. The point passes the plane of a facet that goes through R's plane, inside the facet:
//   n changes by 1. So surfaces behind the point are told from those before it.
//
// An edge that lies in R's plane is a case of the second kind: of its facets those that rise from
// R's plane toward the light shadow R on their side of the edge, the others never do, and the
// facet's plane and the edge's plane cross R in the one line. So
//
//   an edge is a border of R if m is not 0, an end of it lies strictly on the light's side of R's
//   plane, and its box in the light's picture overlaps R's;
//   a facet is a border of R if it is linked to R, has a vertex strictly on the light's side, and
//   another strictly on the far side, or an edge in R's plane that is no edge of R.
//
// A row meets no vertex, as the pixels' centres are moved (row.hpp), and whether the crossing is
// between an edge's ends is asked where the lines cross, exactly.
#pragma once

#include "shadow/rivals/links.hpp"
#include "shadow/rivals/row.hpp"
#include "shadow/rivals/volumes.hpp"

#include <cstdint>
#include <span>

namespace umbra78::shadow::rivals {

struct Border {
    std::uint32_t facet;  // one at the edge, or the facet itself
    std::int32_t change;  // of n, where the border's plane becomes positive
    std::uint8_t side;    // the edge's in that facet; own_plane: the facet's plane
    bool wholly_before;   // an edge whose ends are both strictly on the light's side

    static constexpr std::uint8_t own_plane = 3;
};

struct BorderCounts {
    std::uint64_t signs = 0;      // of a vertex against a receiver's plane
    std::uint64_t box_tests = 0;  // of contour edges
    std::uint64_t edges = 0;      // that are borders, over all receivers
    std::uint64_t facets = 0;     // that are borders, over all receivers
    std::uint64_t longest = 0;    // list of a receiver
};

class Borders {
public:
    // False if the memory is too small; `needed` is as for Links::build.
    bool build(const Setting& setting, const Links& links, std::span<std::byte> memory,
               std::size_t& needed, BorderCounts& counts);

    std::span<const Border> of(std::size_t facet) const {
        return items_.subspan(starts_[facet], starts_[facet + 1] - starts_[facet]);
    }

private:
    std::span<std::uint32_t> starts_, last_receiver_;
    std::span<Border> items_;
};

// A border's crossing of a row on a facet's plane.
struct BorderCrossing {
    int column;           // the first that n is changed at
    std::int32_t change;  // of n, from left to right
    RowLine line;         // the border, on the plane
};

struct CrossingCounts {
    std::uint64_t projected = 0;  // planes cut with a facet's plane and the row
    std::uint64_t tests = 0;      // of a line where another crosses the row
    std::uint64_t crossings = 0;  // that change the number
};

// Whether n changes at a border between the first and the last pixel of a run on facet `on`.
bool crosses(const Setting& setting, std::uint32_t on, const Border& border, int row,
             const Run& run, BorderCrossing& out, CrossingCounts& counts);

}  // namespace umbra78::shadow::rivals
