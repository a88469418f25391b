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
static inline void halve(const GridRow& fa, const GridRow& fb, const GridRow& ga,
                         const GridRow& gb, GridRow& __restrict f_mid,
                         GridRow& __restrict g_mid) {
    for (int k = 0; k < grid_stride; ++k) {
        const std::int32_t sum = ga[k] + gb[k];
        f_mid[k] = down(fa[k] + fb[k] - sum + 1, 1);
        g_mid[k] = down(sum + 4, 3);
    }
}

static void subdivide(GridRow* f, GridRow* g) {
    for (int step = leaves; step > 1; step /= 2) {
        for (int a = 0; a < leaves; a += step)
            halve(f[a], f[a + step], g[a], g[a + step], f[a + step / 2], g[a + step / 2]);
        if (step == 2) break;  // the last level: its corrections are not used
        for (int a = 0; a <= leaves; a += step)
            for (int k = 0; k < grid_stride; ++k) g[a][k] = down(g[a][k] + 2, 2);
    }
}

// The three components' f and gv of both edges v = 0 and v = 1 are 12 lanes of a row.
static void expand_block(const Component* block, GridRow (*grid)[corners]) {
    GridRow f[corners] = {}, g[corners] = {};
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
    subdivide(f, g);
    for (int c = 0; c < 3; ++c) {
        GridRow gv[corners];
        for (int i = 0; i < grid_stride; ++i) {  // the padding's lanes are 0 and stay so
            const bool held = i < corners;
            grid[c][0][i] = held ? f[i][4 * c] : 0;
            grid[c][leaves][i] = held ? f[i][4 * c + 1] : 0;
            gv[0][i] = held ? f[i][4 * c + 2] : 0;
            gv[leaves][i] = held ? f[i][4 * c + 3] : 0;
        }
        subdivide(grid[c], gv);
    }
}

static void expand_form(const std::array<Component, 3>& block, Corners& grid) {
    expand_block(block.data(), reinterpret_cast<GridRow(*)[corners]>(&grid));
}

// --- samples at the pixels' centres --------------------------------------------------------------

// A row of corners along one axis: of neighbours the lesser and the greater.
struct Pairs {
    Lanes min, max;
};
static inline void find_pairs(const std::int32_t* left, const std::int32_t* right,
                              Pairs& __restrict p) {
    for (int u = 0; u < leaves; ++u) {
        p.min[u] = least(left[u], right[u]);
        p.max[u] = most(left[u], right[u]);
    }
}

// A row of leaves: the first pixel whose centre a leaf's box, grown by the slack, may hold, and a
// flag a lane: 1 where it holds that one alone, in the frame; 2 where it holds several.
struct RowCentres {
    Lanes px, py;
    std::uint8_t flag[leaves];
};

static inline void find_centres(const Pairs* x, const Pairs* y, std::int32_t half_px,
                                RowCentres& __restrict row) {
    const std::int32_t to_last = half_px * (1 << raster_fraction) -
                                 (1 << (raster_fraction - 1)) + slack;
    const std::int32_t to_first = to_last - 2 * slack + (1 << raster_fraction) - 1;
    const std::uint32_t size_px = 2 * word(half_px);
    for (int u = 0; u < leaves; ++u) {  // & and |: no branches in lanes
        const auto pixel = [](std::int32_t at, std::int32_t to) {
            return down(wrapped(word(at) + word(to)), raster_fraction);
        };
        const std::int32_t x0 = pixel(least(x[0].min[u], x[1].min[u]), to_first);
        const std::int32_t x1 = pixel(most(x[0].max[u], x[1].max[u]), to_last);
        const std::int32_t y0 = pixel(least(y[0].min[u], y[1].min[u]), to_first);
        const std::int32_t y1 = pixel(most(y[0].max[u], y[1].max[u]), to_last);
        const std::uint32_t in_x = word(x0), in_y = word(y0);
        const bool one = (x0 == x1) & (y0 == y1) & (in_x < size_px) & (in_y < size_px);
        const bool more = (x0 <= x1) & (y0 <= y1) & ((x0 < x1) | (y0 < y1));
        row.px[u] = x0;
        row.py[u] = y0;
        row.flag[u] = static_cast<std::uint8_t>((one ? 1 : 0) | (more ? 2 : 0));
    }
}

// Eight lanes' flags as a word, the first lowest.
static inline std::uint64_t flags_of(const std::uint8_t* flag) {
    std::uint64_t flags = 0;
    __builtin_memcpy(&flags, flag, sizeof flags);
#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
    flags = __builtin_bswap64(flags);
#endif
    return flags;
}

// A leaf that holds one centre is, with the slack, less than two pixels wide: its corners' offsets
// are below 2^14, products 2^28, and sums of edge functions 2^31.
static constexpr std::int32_t max_offset = 2 << raster_fraction;
static_assert(max_offset - slack <= max_triangle);
static_assert(std::int64_t{6} * max_offset * max_offset <= INT32_MAX);

// Up to 16 leaves that hold one centre each. Two corners side by side are copied as one word: for
// each axis first 00 and 10, then 01 and 11.
struct Group {
    std::int32_t pair[3][2][leaves][2];
    Lanes x, y;  // of the centre
    std::uint8_t leaf[leaves];
    int count;
};

// Puts lane u of a row of leaves into the group.
static inline void put(const GridRow (*g)[corners], int v, int u, const RowCentres& row,
                       std::int32_t half_px, Group& group) {
    const int k = group.count++;
    for (int axis = 0; axis < 3; ++axis)
        for (int dv = 0; dv < 2; ++dv)
            __builtin_memcpy(group.pair[axis][dv][k], &g[axis][v + dv][u],
                             2 * sizeof(std::int32_t));
    group.x[k] = (2 * (row.px[u] - half_px) + 1) * (1 << (raster_fraction - 1));
    group.y[k] = (2 * (row.py[u] - half_px) + 1) * (1 << (raster_fraction - 1));
    group.leaf[k] = static_cast<std::uint8_t>(leaves * v + u);
}

// The corners of the group's leaves, lane by lane.
struct GroupCorners {
    Lanes at[4][3];  // 00, 10, 01, 11; x, y, z
};
static inline void part(const Group& group, GroupCorners& __restrict c) {
    for (int axis = 0; axis < 3; ++axis)
        for (int dv = 0; dv < 2; ++dv)
            for (int k = 0; k < leaves; ++k) {
                c.at[2 * dv][axis][k] = group.pair[axis][dv][k][0];
                c.at[2 * dv + 1][axis][k] = group.pair[axis][dv][k][1];
            }
}

// Triangles a, b, c, each against the centre of its leaf: the doubled area, the weights of the
// corners (the edges' values), and a number that is negative where the centre is not covered.
struct Triangles {
    Lanes area, of_a, of_b, of_c, out;
};

static inline std::uint32_t magnitude_of(std::uint32_t v) {
    return wrapped(v) < 0 ? 0 - v : v;
}
static inline std::uint32_t grown(std::uint32_t dx, std::uint32_t dy) {
    return slack * (magnitude_of(dx) + magnitude_of(dy));
}
// Negative where an offset lies beyond those of a triangle's corners, 0 among them, and the slack.
static inline std::uint32_t beyond_box(std::int32_t at, std::int32_t b, std::int32_t c) {
    return word(at + slack - least(least(b, c), 0)) | word(most(most(b, c), 0) + slack - at);
}

static inline void weigh(const Group& group, const Lanes* a, const Lanes* b, const Lanes* c,
                         Triangles& __restrict t) {
    for (int k = 0; k < leaves; ++k) {  // by offsets from corner a
        const std::uint32_t x0 = word(a[0][k]), y0 = word(a[1][k]);
        const std::uint32_t dx = word(group.x[k]) - x0, dy = word(group.y[k]) - y0;
        const std::uint32_t px = word(b[0][k]) - x0, py = word(b[1][k]) - y0;
        const std::uint32_t qx = word(c[0][k]) - x0, qy = word(c[1][k]) - y0;
        const std::uint32_t turned = px * qy - py * qx;
        const std::uint32_t sign = word(down(wrapped(turned), 31));  // (v ^ sign) - sign: +-v
        const std::uint32_t area = (turned ^ sign) - sign;
        const std::uint32_t of_b = ((dx * qy - dy * qx) ^ sign) - sign;
        const std::uint32_t of_c = ((px * dy - py * dx) ^ sign) - sign;
        const std::uint32_t of_a = area - of_b - of_c;
        const std::uint32_t out = (of_a + grown(px - qx, py - qy)) | (of_b + grown(qx, qy)) |
                                  (of_c + grown(px, py)) | (area - 1) |
                                  beyond_box(wrapped(dx), wrapped(px), wrapped(qx)) |
                                  beyond_box(wrapped(dy), wrapped(py), wrapped(qy));
        t.area[k] = wrapped(area);
        t.of_a[k] = wrapped(of_a);
        t.of_b[k] = wrapped(of_b);
        t.of_c[k] = wrapped(of_c);
        t.out[k] = wrapped(out);
    }
}

// The depth of a triangle's plane at the centre: lowest + dividend / divisor, in whole numbers. It
// is the mean of the corners' depths over the lowest, weighted, and rounded half up; where the
// centre lies in the slack it is clamped.
struct Depths {
    Lanes lowest;
    std::uint64_t dividend[leaves], divisor[leaves];
};

static inline void find_depths(const Triangles& t, const Lanes& az, const Lanes& bz,
                               const Lanes& cz, Depths& __restrict d) {
    for (int k = 0; k < leaves; ++k) {
        const std::int32_t lowest = least(least(az[k], bz[k]), cz[k]);
        const std::int32_t highest = most(most(az[k], bz[k]), cz[k]);
        const auto share = [&](std::int32_t weight, std::int32_t z) {
            return std::int64_t{weight} * wrapped(word(z) - word(lowest));
        };
        const std::int64_t rise =
            share(t.of_a[k], az[k]) + share(t.of_b[k], bz[k]) + share(t.of_c[k], cz[k]);
        const std::int64_t whole = share(t.area[k], highest);
        const std::int64_t clamped = rise < 0 ? 0 : rise < whole ? rise : whole;
        d.lowest[k] = lowest;
        d.dividend[k] = 2 * static_cast<std::uint64_t>(clamped) + word(t.area[k]);
        d.divisor[k] = 2 * std::uint64_t{word(t.area[k])};
    }
}

// Appends the group's samples at `to` and empties it; returns where the list goes on.
static BlockSample* sample_group(Group& group, BlockSample* to) {
    GroupCorners c;
    Triangles t[2];
    Depths d[2];
    part(group, c);
    weigh(group, c.at[0], c.at[1], c.at[3], t[0]);
    weigh(group, c.at[0], c.at[3], c.at[2], t[1]);
    find_depths(t[0], c.at[0][2], c.at[1][2], c.at[3][2], d[0]);
    find_depths(t[1], c.at[0][2], c.at[3][2], c.at[2][2], d[1]);
    std::uint8_t covered[2][leaves];
    for (int second = 0; second < 2; ++second)
        for (int k = 0; k < leaves; ++k) covered[second][k] = t[second].out[k] >= 0 ? 1 : 0;
    for (int k = group.count; k < leaves; ++k) covered[0][k] = covered[1][k] = 0;
    for (int half = 0; half < leaves; half += 8) {  // leaf by leaf: bit 0, then bit 4 of a byte
        const std::uint64_t all = flags_of(covered[0] + half) | flags_of(covered[1] + half) << 4;
        for (std::uint64_t in = all; in != 0; in &= in - 1) {
            const int bit = __builtin_ctzll(in), lane = half + bit / 8, second = bit / 4 % 2;
            const Depths& depth = d[second];
            const auto over =
                static_cast<std::uint32_t>(depth.dividend[lane] / depth.divisor[lane]);
            *to++ = {group.x[lane], group.y[lane], wrapped(word(depth.lowest[lane]) + over),
                     group.leaf[lane], second != 0};
        }
    }
    group.count = 0;
    return to;
}

static bool centres_form(const Corners& grid, std::int32_t half_px, BlockSamples& out) {
    const auto* g = reinterpret_cast<const GridRow(*)[corners]>(&grid);
    Pairs x[corners], y[corners];
    for (int v = 0; v < corners; ++v) {
        find_pairs(g[0][v], g[0][v] + 1, x[v]);
        find_pairs(g[1][v], g[1][v] + 1, y[v]);
    }
    BlockSample* to = out.sample.data();
    Group group;
    group.count = 0;
    std::uint64_t tested = 0;
    for (int v = 0; v < leaves; ++v) {
        RowCentres row;
        find_centres(x + v, y + v, half_px, row);
        for (int half = 0; half < leaves; half += 8) {
            const std::uint64_t flags = flags_of(row.flag + half);
            if ((flags & 0x0202020202020202) != 0) return false;
            for (std::uint64_t one = flags; one != 0; one &= one - 1) {
                put(g, v, half + __builtin_ctzll(one) / 8, row, half_px, group);
                ++tested;
                if (group.count == leaves) to = sample_group(group, to);
            }
        }
    }
    if (group.count > 0) to = sample_group(group, to);
    out.tested = tested;
    out.count = static_cast<std::size_t>(to - out.sample.data());
    return true;
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
        std::uint8_t seen[leaves];
        for (int c = 0; c < 3; ++c)
            for (int u = 0; u < leaves; ++u)
                mean[c][u] = down(g[c][v][u] + g[c][v][u + 1] + g[c][v + 1][u] +
                                      g[c][v + 1][u + 1] + 2, 2);
        for (int u = 0; u < leaves; ++u) {
            const std::uint32_t x = word(mean[0][u]) + edge, y = word(mean[1][u]) + edge;
            seen[u] = (x < 2 * edge) & (y < 2 * edge) ? 1 : 0;
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

#include "raster/shade_body.hpp"

#endif
