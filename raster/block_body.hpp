// A block's leaves and samples in lanes: a text for fixed/lane_sets.hpp, of raster/block_forms.cpp;
// alone it is empty. Loops of 16 or 24 steps over plain arrays are what compilers make vectors of;
// words wrap, so that lanes whose leaf is not asked for may hold anything.
#ifdef UMBRA78_LANES_TEXT

typedef std::int32_t Lanes[leaves];
typedef std::int32_t GridRow[grid_stride];

static inline std::int32_t down(std::int32_t v, int n) { return fixed::floor_shift(v, n); }
static inline std::int32_t wrapped(std::uint32_t v) { return static_cast<std::int32_t>(v); }
static inline std::uint32_t word(std::int32_t v) { return static_cast<std::uint32_t>(v); }
static inline std::int32_t least(std::int32_t a, std::int32_t b) { return b < a ? b : a; }
static inline std::int32_t most(std::int32_t a, std::int32_t b) { return a < b ? b : a; }

// --- corners -------------------------------------------------------------------------------------

// One halving of rows of f and g, as halve_lanes has it.
static inline void halve(const std::int32_t* fa, const std::int32_t* fb, const std::int32_t* ga,
                         const std::int32_t* gb, std::int32_t* __restrict f_mid,
                         std::int32_t* __restrict g_mid, int lanes) {
    for (int k = 0; k < lanes; ++k) {
        const std::int32_t sum = ga[k] + gb[k];
        f_mid[k] = down(fa[k] + fb[k] - sum + 1, 1);
        g_mid[k] = down(sum + 4, 3);
    }
}

// Rows of `lanes` words each; `lanes` is a constant where this is inlined.
static inline void subdivide(std::int32_t* f, std::int32_t* g, int lanes) {
    for (int step = leaves; step > 1; step /= 2) {
        for (int a = 0; a < leaves; a += step) {
            const int from = a * lanes, mid = from + step / 2 * lanes, to = from + step * lanes;
            halve(f + from, f + to, g + from, g + to, f + mid, g + mid, lanes);
        }
        if (step == 2) break;  // the last level: its corrections are not used
        for (int a = 0; a <= leaves; a += step)
            for (int k = a * lanes; k < (a + 1) * lanes; ++k) g[k] = down(g[k] + 2, 2);
    }
}

static void subdivide_u(Lanes* f, Lanes* g) { subdivide(f[0], g[0], leaves); }
static void subdivide_v(GridRow* f, GridRow* g) { subdivide(f[0], g[0], grid_stride); }

// The three components' f and gv of both edges v = 0 and v = 1 are 12 lanes of a row.
static void expand_block(const Component* block, GridRow (*grid)[corners]) {
    Lanes f[corners], g[corners];
    for (const int row : {0, leaves})
        for (int lane = 12; lane < leaves; ++lane) f[row][lane] = g[row][lane] = 0;
    for (int c = 0; c < 3; ++c) {
        const std::int64_t *value = block[c].f.data(), *in_u = block[c].gu.data();
        const std::int64_t *in_v = block[c].gv.data(), *in_both = block[c].guv.data();
        for (int v = 0; v < 2; ++v) {
            for (int u = 0; u < 2; ++u) {
                const int row = u == 0 ? 0 : leaves, lane = 4 * c + v, corner = 2 * v + u;
                f[row][lane] = static_cast<std::int32_t>(value[corner]);
                g[row][lane] = static_cast<std::int32_t>(in_u[corner]);
                f[row][lane + 2] = static_cast<std::int32_t>(in_v[corner]);
                g[row][lane + 2] = static_cast<std::int32_t>(in_both[corner]);
            }
        }
    }
    subdivide_u(f, g);
    for (int c = 0; c < 3; ++c) {
        GridRow gv[corners];
        for (int i = 0; i < corners; ++i) {
            grid[c][0][i] = f[i][4 * c];
            grid[c][leaves][i] = f[i][4 * c + 1];
            gv[0][i] = f[i][4 * c + 2];
            gv[leaves][i] = f[i][4 * c + 3];
        }
        for (int i = corners; i < grid_stride; ++i)  // halved with the rest
            grid[c][0][i] = grid[c][leaves][i] = gv[0][i] = gv[leaves][i] = 0;
        subdivide_v(grid[c], gv);
    }
}

static void expand_form(const std::array<Component, 3>& block, Corners& grid) {
    expand_block(block.data(), reinterpret_cast<GridRow(*)[corners]>(&grid));
}

// --- samples at the leaves' centres --------------------------------------------------------------

static bool leaves_form(const Corners& grid, std::int32_t half_px, BlockSamples& out) {
    constexpr std::int32_t reach = 1 << 29;  // sums of four fit
    const auto* g = reinterpret_cast<const GridRow(*)[corners]>(&grid);
    std::int32_t far = 0;
    for (int c = 0; c < 3; ++c)
        for (int v = 0; v < corners; ++v)
            for (int u = 0; u < corners; ++u)
                far |= wrapped(word(g[c][v][u]) + word(reach)) & ~(2 * reach - 1);
    if (far != 0) return false;
    const std::uint32_t edge = word(half_px) << raster_fraction;
    BlockSample* at = out.sample.data();
    out.tested = 0;
    for (int v = 0; v < leaves; ++v) {
        Lanes mean[3];
        Lanes seen;
        for (int c = 0; c < 3; ++c)
            for (int u = 0; u < leaves; ++u)
                mean[c][u] = down(g[c][v][u] + g[c][v][u + 1] + g[c][v + 1][u] +
                                      g[c][v + 1][u + 1] + 2, 2);
        for (int u = 0; u < leaves; ++u) {
            const std::uint32_t x = word(mean[0][u]) + edge, y = word(mean[1][u]) + edge;
            seen[u] = ((x < 2 * edge) & (y < 2 * edge)) ? 1 : 0;
        }
        for (int u = 0; u < leaves; ++u) {
            *at = {mean[0][u], mean[1][u], mean[2][u], static_cast<std::uint8_t>(leaves * v + u),
                   false};
            at += seen[u];
        }
    }
    out.count = static_cast<std::size_t>(at - out.sample.data());
    return true;
}

#include "raster/centres_body.hpp"
#include "raster/shade_body.hpp"
#include "raster/facet_body.hpp"

#endif
