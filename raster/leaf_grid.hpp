// The 16 x 16 leaves of a block: four breadth-first halvings in u, then four in v.
//
// All leaves of a block share a depth, so each halving is one straight loop over lanes: in u the
// lanes are the components' four (f, gv) pairs of both v edges, in v they are the 17 columns.
// The rounding is block.hpp's, in the same order, so a leaf corner is what repeated split_u and
// then split_v would give (tests compare the two). A corner differs from the exact surface of the
// block by at most max_corner_error units.
#pragma once

#include "raster/block.hpp"

#include <array>
#include <cstdint>

namespace umbra78::raster {

inline constexpr int leaf_levels = 4;
inline constexpr int leaves = 1 << leaf_levels;  // a side
inline constexpr int corners = leaves + 1;       // a side
inline constexpr int grid_stride = 24;           // corners, padded to whole vectors

// Each halving rounds half up once and passes its operands' errors on (block.hpp's formulas, with
// absolute values): 3.8 units of f after four in u, and 8.8 more after four in v.
inline constexpr int max_corner_error = 13;

// corner[j][i] is the surface at u = i / 16, v = j / 16.
template <class Int>
using CornerGrid = std::array<std::array<Int, grid_stride>, corners>;

namespace detail {

template <class Int, std::size_t Lanes>
using LaneRows = std::array<std::array<Int, Lanes>, corners>;

// One halving between rows a and b of f and g; the rows' own g are divided by the caller, once a
// level. The middle rows are none of the others, so the compiler can use whole vectors.
template <class Int, std::size_t Lanes>
void halve_lanes(const std::array<Int, Lanes>& fa, const std::array<Int, Lanes>& fb,
                 const std::array<Int, Lanes>& ga, const std::array<Int, Lanes>& gb,
                 std::array<Int, Lanes>& __restrict f_mid,
                 std::array<Int, Lanes>& __restrict g_mid) {
    for (std::size_t k = 0; k < Lanes; ++k) {
        const Int sum = ga[k] + gb[k];
        f_mid[k] = half_up<Int>(fa[k] + fb[k] - sum, 1);
        g_mid[k] = half_up<Int>(sum, 3);
    }
}

template <class Int, std::size_t Lanes>
void subdivide_lanes(LaneRows<Int, Lanes>& f, LaneRows<Int, Lanes>& g) {
    for (std::size_t step = leaves; step > 1; step /= 2) {
        for (std::size_t a = 0; a < leaves; a += step) {
            const std::size_t mid = a + step / 2, b = a + step;
            halve_lanes(f[a], f[b], g[a], g[b], f[mid], g[mid]);
        }
        if (step == 2) break;  // the last level: its corrections are not used
        for (std::size_t a = 0; a <= leaves; a += step)
            for (std::size_t k = 0; k < Lanes; ++k) g[a][k] = half_up<Int>(g[a][k], 2);
    }
}

}  // namespace detail

// The corners of all leaves. Int holds twice the block's values and corrections.
template <class Int, std::size_t Components>
void expand(const std::array<Component, Components>& block,
            std::array<CornerGrid<Int>, Components>& grid) {
    constexpr std::size_t lanes = 4 * Components;
    std::array<std::array<Int, lanes>, corners> f{}, g{};
    for (std::size_t c = 0; c < Components; ++c) {
        for (std::size_t v = 0; v < 2; ++v) {
            for (std::size_t u = 0; u < 2; ++u) {
                const std::size_t row = u == 0 ? 0 : leaves;
                f[row][4 * c + v] = static_cast<Int>(block[c].f[2 * v + u]);
                g[row][4 * c + v] = static_cast<Int>(block[c].gu[2 * v + u]);
                f[row][4 * c + 2 + v] = static_cast<Int>(block[c].gv[2 * v + u]);
                g[row][4 * c + 2 + v] = static_cast<Int>(block[c].guv[2 * v + u]);
            }
        }
    }
    detail::subdivide_lanes(f, g);
    for (std::size_t c = 0; c < Components; ++c) {
        CornerGrid<Int> gv{};
        for (std::size_t i = 0; i < corners; ++i) {
            grid[c][0][i] = f[i][4 * c];
            grid[c][leaves][i] = f[i][4 * c + 1];
            gv[0][i] = f[i][4 * c + 2];
            gv[leaves][i] = f[i][4 * c + 3];
        }
        // The padding's lanes are halved with the rest: what the memory held could overflow.
        for (std::size_t i = corners; i < grid_stride; ++i)
            grid[c][0][i] = grid[c][leaves][i] = 0;
        detail::subdivide_lanes(grid[c], gv);
    }
}

}  // namespace umbra78::raster
