// Crow's third class: shadow volumes (Crow 1977, "Shadow Algorithms for Computer Graphics").
//
// Behind each facet, away from the light, is a volume in shadow. Its sides are quadrangles that
// begin at an edge and never end: {a + s (b - a) - t L, 0 <= s <= 1, t > 0}. Between the eye and
// the point that a pixel shows, each side that is crossed leads into a volume or out of one; the
// sum is the number of surfaces between the point and the light. The facets themselves are the
// volumes' caps, and since the point is visible none of them lies before it.
//
// Sides of facets that share an edge cancel. What remains of an edge is its multiplicity
//
//   m = sum over its facets of (1 from low to high vertex, else -1) (side of the light)
//
// 0 within a surface that faces the light on both sides of the edge, 1 or -1 at a border, 2 or -2
// at the contour of a closed mesh, and whatever a non-manifold edge has. Winding need not be
// consistent (general form: Kim, Kim & Turk 2008). The sum does not depend on the order in which
// the sides are met, so it is taken a side at a time.
//
// Crow's own order and the frame store's count are ordered_volumes.hpp and stencil.hpp.
//
// If the eye is in a volume the count begins there. Of the volumes on whose border the eye lies
// exactly, that is decided for each pixel, as for a point of its ray just before the eye.
#pragma once

#include "shadow/rivals/brute.hpp"

#include <cstdint>
#include <span>

namespace umbra78::shadow::rivals {

struct ContourEdge {
    std::uint32_t edge;
    std::int32_t multiplicity;
};

std::int32_t multiplicity(const Setting& setting, const Edge& edge);

// Writes the edges whose multiplicity is not 0, as many as fit. Returns how many there are.
std::size_t find_contour(const Setting& setting, std::span<ContourEdge> out);

// The side of a volume at an edge, as the eye sees it.
class ShadowSide {
public:
    ShadowSide(const Setting& setting, const ContourEdge& edge);

    // Seen edge-on it hides nothing and is never crossed.
    bool is_seen() const { return eye_side_ != 0; }
    const SeenPlane& plane() const { return plane_; }
    // The columns of a row that it covers.
    Run covered_run(const Space& space, int row) const;
    // What crossing it adds, to points of a facet's plane at which `crossed` has crossed_sign().
    std::int32_t change() const { return change_; }
    ScreenLine crossed(const SeenPlane& on) const { return meet(on, plane_); }
    int crossed_sign() const { return -eye_side_; }

private:
    SeenPlane plane_;                      // through the light and the edge
    std::array<ScreenLine, 3> bounds_;     // the edge and the two rays, as the eye sees them
    std::array<int, 3> inside_;
    int eye_side_;
    std::int32_t change_;
};

struct VolumeCounts {
    std::uint64_t facets = 0, edges = 0;  // classified
    std::uint64_t contour = 0;            // edges with a side
    std::uint64_t sides = 0;              // that are not seen edge-on
    std::uint64_t rows = 0;               // of sides: three crossings each
    std::uint64_t fills = 0;              // pixels of sides
    std::uint64_t tests = 0;              // of them, where there is a surface
    std::uint64_t updates = 0;            // of the counter
    std::uint64_t start_tests = 0;        // of facets, for the count at the eye
};

// Writes in how many volumes the eye is, as each pixel's ray leaves it; 0 where nothing is seen.
// Returns how many facets were asked.
std::uint64_t count_at_eye(const Setting& setting, std::span<const std::uint32_t> shown,
                           std::span<std::int32_t> surfaces);

// `surfaces`: how many lie between each pixel's point and the light; 0 where nothing is seen. Has
// space.pixels() numbers. A pixel is dark if the number is not 0 or its facet is attached.
void count_volumes(const Setting& setting, std::span<const std::uint32_t> shown,
                   std::span<const ContourEdge> contour, std::span<std::int32_t> surfaces,
                   VolumeCounts& counts);

// The mask of such numbers.
void mask_of_counts(const Setting& setting, std::span<const std::uint32_t> shown,
                    std::span<const std::int32_t> surfaces, std::span<std::uint8_t> mask);

}  // namespace umbra78::shadow::rivals
