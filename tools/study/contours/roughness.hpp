// How rough the contour of a drawn shadow is, beside the exact edge.
//
//   length ratio  the drawn contour's length over the exact edge's: 1 for a smooth contour
//   roughness     rms distance of the contour from a straight line fitted to it in windows of 16
//                 pixels along the exact edge. Distances are measured from the exact edge, so its
//                 own bend counts as straight, and a contour that is merely displaced or turned
//                 is not rough.
//   displacement  of the same windows: the mean distance, positive where the shadow is too large
//
// The part of the contour that is nearer to a cast shadow's edge than to a surface's own shadow
// line is counted apart from the other.
#pragma once

#include "tools/truth/shadow_edge.hpp"

#include <array>

namespace umbra78::tools::study {

inline constexpr double window_px = 16;
// Contours farther than this from any edge are stray: acne or leaks, not a rough edge.
inline constexpr double reach_px = 24;

struct EdgeRoughness {
    double exact_px = 0;      // length of the exact edge
    double drawn_px = 0;      // of the contour nearest to it
    double length_ratio = 0;  // drawn_px / exact_px
    double rms_px = 0;        // roughness
    double displacement_px = 0, displacement_rms_px = 0;  // over windows: mean, and rms
    double max_px = 0;        // greatest distance of the contour from the exact edge
};

struct Roughness {
    std::array<EdgeRoughness, 2> of;  // by EdgeKind
    double stray_px = 0;              // length of the contours beyond reach of every edge
    const EdgeRoughness& operator[](EdgeKind kind) const {
        return of[static_cast<std::size_t>(kind)];
    }
};

Roughness roughness(std::span<const ShadowEdge> exact, std::span<const Contour> drawn, int size);

}  // namespace umbra78::tools::study
