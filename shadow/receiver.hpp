// The receiver's plane: a pixel's depth in the light's view, continued to the place where the map
// is sampled (Dou et al. 2014; hw/MACHINE.md, section 24).
//
//   u, v     the results of two neighbours less the pixel's
//   D        = u.x v.y - v.x u.y
//   slope_x  = (u.z v.y - v.z u.y) / D     slope_y = (v.z u.x - u.z v.x) / D
//   change   = slope_x (to_x - x) + slope_y (to_y - y), at most the limit
//
// The neighbours are those in X and in Y whose codes differ less from the pixel's, so that a pixel
// at a silhouette takes its plane from its own side. No normal is kept.
// In: results of the transform unit: X and Y with F fraction bits, Z in quanta. Out: quanta.
// Slopes are words of 40 bits with 12 fraction bits: quanta for a step of X or Y.
#pragma once

#include "fixed/divide.hpp"
#include "fixed/overflow.hpp"
#include "hw/frame_store.hpp"
#include "hw/transform_unit.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace umbra78::shadow {

inline constexpr int slope_fraction = 12, slope_bits = 40, step_bits = 31;

struct ReceiverPlane {
    hw::Point at{};                       // the pixel's results
    std::int64_t slope_x = 0, slope_y = 0;
    std::int64_t limit = INT64_MAX;       // quanta

    // To a place given in half steps of X and Y, so that a texel's centre is one.
    constexpr std::int64_t change(std::int64_t x2, std::int64_t y2) const {
        const std::int64_t moved = slope_x * (x2 - 2 * at.x) + slope_y * (y2 - 2 * at.y);
        return std::clamp(
            fixed::round_shift(moved, slope_fraction + 1, fixed::Rounding::half_up), -limit, limit);
    }
};

// The neighbours' results less the pixel's; not known where a result or a step is out of range.
struct NeighbourSteps {
    bool known = false;
    std::array<std::int64_t, 3> u{}, v{};
};

constexpr NeighbourSteps neighbour_steps(const hw::Point& at, const hw::Point& beside,
                                         const hw::Point& below) {
    for (const hw::Point* p : {&at, &beside, &below})
        if (p->status != hw::DivideStatus::ok) return {};
    const NeighbourSteps steps{true,
                               {beside.x - at.x, beside.y - at.y, beside.z - at.z},
                               {below.x - at.x, below.y - at.y, below.z - at.z}};
    for (std::size_t k = 0; k < 3; ++k)
        if (!fixed::fits(steps.u[k], step_bits) || !fixed::fits(steps.v[k], step_bits)) return {};
    return steps;
}

// The plane through three results; without one, level.
constexpr ReceiverPlane receiver_plane(const hw::Point& at, const hw::Point& beside,
                                       const hw::Point& below, std::int64_t limit) {
    ReceiverPlane plane{at, 0, 0, limit};
    const NeighbourSteps steps = neighbour_steps(at, beside, below);
    if (!steps.known) return plane;
    const auto [ux, uy, uz] = steps.u;
    const auto [vx, vy, vz] = steps.v;
    const std::int64_t d = ux * vy - vx * uy;
    if (d == 0) return plane;
    const std::int64_t sign = d < 0 ? -1 : 1;
    const auto slope = [&](std::int64_t rise) {
        return fixed::divide(sign * rise, sign * d, slope_fraction, slope_bits).value;
    };
    plane.slope_x = slope(uz * vy - vz * uy);
    plane.slope_y = slope(vz * ux - uz * vx);
    return plane;
}

// The neighbour in a direction, (1, 0) or (0, 1), of which a pixel's plane is taken; false if there
// is none.
template <class Depth>
bool nearer_neighbour(const hw::FrameStore<const Depth>& store, std::uint32_t background, int x,
                      int y, int dx, int dy, int& to_x, int& to_y) {
    const std::int64_t own = store.depth[store.address(x, y)];
    std::int64_t least = -1;
    for (const int way : {-1, 1}) {
        const int nx = x + way * dx, ny = y + way * dy;
        if (nx < 0 || ny < 0 || nx >= store.size_px() || ny >= store.size_px()) continue;
        const std::uint32_t code = store.depth[store.address(nx, ny)];
        if (code == background) continue;
        const std::int64_t off = code < own ? own - code : code - own;
        if (least >= 0 && off >= least) continue;
        least = off;
        to_x = nx;
        to_y = ny;
    }
    return least >= 0;
}

}  // namespace umbra78::shadow
