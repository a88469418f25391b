// A block's samples at the pixels' centres in lanes: a part of block_body.hpp's text.
//
//   list     the leaves whose box, grown by the slack, holds a centre
//   collect  16 of them, with their corners
//   weigh    both triangles of such a leaf, by offsets from its corner 00
//   depth    of the one that covers the centre; where both do, the second's in a list of its own
#ifdef UMBRA78_LANES_TEXT

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

// By rows of leaves: the first pixel whose centre a leaf's box, grown by the slack, may hold, and a
// flag: 1 where it holds that one alone, in the frame; 2 where it holds several.
struct Centres {
    Lanes px[leaves], py[leaves], flag[leaves];
};

static inline void find_centres(const Pairs* x, const Pairs* y, std::int32_t half_px,
                                Lanes& __restrict px, Lanes& __restrict py,
                                Lanes& __restrict flag) {
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
        px[u] = x0;
        py[u] = y0;
        flag[u] = (one ? 1 : 0) | (more ? 2 : 0);
    }
}

// Numbers of leaves, in a list that is filled without a branch: what a leaf holds is hard to
// predict.
struct LeafList {
    std::uint8_t number[leaves * leaves + leaves];  // the last group of 16 is filled up with 0
    int count = 0;

    // Those of 16 leaves whose flag is 1. The count is kept out of the memory that bytes go to.
    void add(const std::uint8_t* leaf, const std::int32_t* flag, int leaf_count) {
        int n = count;
        for (int k = 0; k < leaf_count; ++k) {
            number[n] = leaf[k];
            n += flag[k];
        }
        count = n;
    }
    void fill_up() {
        for (int k = 0; k < leaves; ++k) number[count + k] = 0;
    }
};

// The leaves that hold one centre; false if one holds several.
static bool list_centres(const GridRow (*g)[corners], std::int32_t half_px,
                         Centres& __restrict c, LeafList& __restrict list) {
    Pairs x[corners], y[corners];
    for (int v = 0; v < corners; ++v) {
        find_pairs(g[0][v], g[0][v] + 1, x[v]);
        find_pairs(g[1][v], g[1][v] + 1, y[v]);
    }
    for (int v = 0; v < leaves; ++v)
        find_centres(x + v, y + v, half_px, c.px[v], c.py[v], c.flag[v]);
    std::int32_t any = 0;
    for (int v = 0; v < leaves; ++v)
        for (int u = 0; u < leaves; ++u) any |= c.flag[v][u];
    if ((any & 2) != 0) return false;
    for (int v = 0; v < leaves; ++v) {
        std::uint8_t row[leaves];
        for (int u = 0; u < leaves; ++u) row[u] = static_cast<std::uint8_t>(leaves * v + u);
        list.add(row, c.flag[v], leaves);
    }
    list.fill_up();
    return true;
}

// A leaf that holds one centre is, with the slack, less than two pixels wide: its corners' offsets
// are below 2^14, products 2^28, and sums of edge functions 2^31.
static constexpr std::int32_t max_offset = 2 << raster_fraction;
static_assert(max_offset - slack <= max_triangle);
static_assert(std::int64_t{6} * max_offset * max_offset <= INT32_MAX);

// 16 leaves that hold one centre each. Two corners side by side are copied as one word: for each
// axis first 00 and 10, then 01 and 11.
struct Group {
    std::int32_t pair[3][2][leaves][2];
    Lanes corner[4][3];  // 00, 10, 01, 11; x, y, z
    Lanes x, y;          // of the centre
};

static inline void collect(const GridRow (*g)[corners], const Centres& c,
                           const std::uint8_t* number, std::int32_t half_px,
                           Group& __restrict group) {
    for (int k = 0; k < leaves; ++k) {
        const int v = static_cast<int>(number[k] / 16u), u = number[k] & 15;
        for (int axis = 0; axis < 3; ++axis)
            for (int dv = 0; dv < 2; ++dv)
                __builtin_memcpy(group.pair[axis][dv][k], &g[axis][v + dv][u],
                                 2 * sizeof(std::int32_t));
        group.x[k] = (2 * (c.px[v][u] - half_px) + 1) * (1 << (raster_fraction - 1));
        group.y[k] = (2 * (c.py[v][u] - half_px) + 1) * (1 << (raster_fraction - 1));
    }
    for (int axis = 0; axis < 3; ++axis)
        for (int dv = 0; dv < 2; ++dv)
            for (int k = 0; k < leaves; ++k) {
                group.corner[2 * dv][axis][k] = group.pair[axis][dv][k][0];
                group.corner[2 * dv + 1][axis][k] = group.pair[axis][dv][k][1];
            }
}

// Of each leaf the first of its triangles that covers the centre: the doubled area, the weights of
// its corners (the edges' values) and their depths. `covers`: one does; `second`: it is the second
// triangle; `both`: the second does, too.
struct Covered {
    Lanes area, of_a, of_b, of_c, az, bz, cz;
    Lanes covers, second, both;
};

static inline std::uint32_t magnitude_of(std::uint32_t v) {
    return wrapped(v) < 0 ? 0 - v : v;
}
static inline std::uint32_t grown(std::uint32_t dx, std::uint32_t dy) {
    return slack * (magnitude_of(dx) + magnitude_of(dy));
}
// Negative where an offset lies beyond those of a triangle's corners, 0 among them, and the slack.
static inline std::uint32_t beyond_box(std::uint32_t at, std::uint32_t b, std::uint32_t c) {
    const std::int32_t low = least(least(wrapped(b), wrapped(c)), 0);
    const std::int32_t high = most(most(wrapped(b), wrapped(c)), 0);
    return (at + slack - word(low)) | (word(high) + slack - at);
}

// By offsets from corner 00: p, q, r to the corners 10, 11, 01 and d to the centre.
static inline void weigh(const Group& group, bool only_second, Covered& __restrict t) {
    const auto& at = group.corner;
    const std::uint32_t passed = only_second ? 0xffffffff : 0;
    for (int k = 0; k < leaves; ++k) {
        const std::uint32_t x0 = word(at[0][0][k]), y0 = word(at[0][1][k]);
        const std::uint32_t dx = word(group.x[k]) - x0, dy = word(group.y[k]) - y0;
        const std::uint32_t px = word(at[1][0][k]) - x0, py = word(at[1][1][k]) - y0;
        const std::uint32_t qx = word(at[3][0][k]) - x0, qy = word(at[3][1][k]) - y0;
        const std::uint32_t rx = word(at[2][0][k]) - x0, ry = word(at[2][1][k]) - y0;
        const std::uint32_t pq = px * qy - py * qx, qr = qx * ry - qy * rx;
        const std::uint32_t dq = dx * qy - dy * qx, grown_q = grown(qx, qy);
        const std::uint32_t s = word(down(wrapped(pq), 31)), t1 = word(down(wrapped(qr), 31));
        const auto turned = [](std::uint32_t v, std::uint32_t sign) {  // v or -v
            return (v ^ sign) - sign;
        };
        const std::uint32_t area0 = turned(pq, s), b0 = turned(dq, s);
        const std::uint32_t c0 = turned(px * dy - py * dx, s), a0 = area0 - b0 - c0;
        const std::uint32_t area1 = turned(qr, t1), c1 = turned(0 - dq, t1);
        const std::uint32_t b1 = turned(dx * ry - dy * rx, t1), a1 = area1 - b1 - c1;
        const std::uint32_t out0 = (a0 + grown(px - qx, py - qy)) | (b0 + grown_q) |
                                   (c0 + grown(px, py)) | (area0 - 1) |
                                   beyond_box(dx, px, qx) | beyond_box(dy, py, qy);
        const std::uint32_t out1 = (a1 + grown(qx - rx, qy - ry)) | (c1 + grown_q) |
                                   (b1 + grown(rx, ry)) | (area1 - 1) |
                                   beyond_box(dx, qx, rx) | beyond_box(dy, qy, ry);
        const bool first = wrapped(out0 | passed) >= 0, second = wrapped(out1) >= 0;
        t.area[k] = wrapped(first ? area0 : area1);
        t.of_a[k] = wrapped(first ? a0 : a1);
        t.of_b[k] = wrapped(first ? b0 : b1);
        t.of_c[k] = wrapped(first ? c0 : c1);
        t.az[k] = at[0][2][k];
        t.bz[k] = first ? at[1][2][k] : at[3][2][k];
        t.cz[k] = first ? at[3][2][k] : at[2][2][k];
        t.covers[k] = (first | second) ? 1 : 0;
        t.second[k] = first ? 0 : 1;
        t.both[k] = (first & second) ? 1 : 0;
    }
}

// The depth of a triangle's plane at the centre: lowest + dividend / divisor, in whole numbers. It
// is the mean of the corners' depths over the lowest, weighted, and rounded half up; where the
// centre lies in the slack it is clamped.
struct Depths {
    Lanes lowest;
    std::uint64_t dividend[leaves], divisor[leaves];
};

static inline void find_depths(const Covered& t, Depths& __restrict d) {
    for (int k = 0; k < leaves; ++k) {
        const std::int32_t lowest = least(least(t.az[k], t.bz[k]), t.cz[k]);
        const std::int32_t highest = most(most(t.az[k], t.bz[k]), t.cz[k]);
        const auto share = [&](std::int32_t weight, std::int32_t z) {
            return static_cast<std::uint64_t>(std::int64_t{weight} *
                                              wrapped(word(z) - word(lowest)));
        };
        const auto rise = static_cast<std::int64_t>(
            share(t.of_a[k], t.az[k]) + share(t.of_b[k], t.bz[k]) + share(t.of_c[k], t.cz[k]));
        const auto whole = static_cast<std::int64_t>(share(t.area[k], highest));
        const std::int64_t clamped = rise < 0 ? 0 : rise < whole ? rise : whole;
        d.lowest[k] = lowest;
        d.dividend[k] = 2 * static_cast<std::uint64_t>(clamped) + word(t.area[k]);
        d.divisor[k] = 2 * std::uint64_t{word(most(t.area[k], 1))};
    }
}

// Appends the samples of a list's leaves at `to`, and to `again` the leaves whose second triangle
// covers the centre beside the first; without `again` it is the second that is sampled. Returns
// where the samples go on.
static BlockSample* sample_list(const GridRow (*g)[corners], const Centres& c,
                                const LeafList& list, std::int32_t half_px, LeafList* again,
                                BlockSample* to) {
    for (int at = 0; at < list.count; at += leaves) {
        const std::uint8_t* number = list.number + at;
        const int count = least(list.count - at, leaves);
        Group group;
        Covered t;
        Depths d;
        collect(g, c, number, half_px, group);
        weigh(group, again == nullptr, t);
        find_depths(t, d);
        for (int k = 0; k < count; ++k) {
            const auto over = static_cast<std::uint32_t>(d.dividend[k] / d.divisor[k]);
            *to = {group.x[k], group.y[k], wrapped(word(d.lowest[k]) + over), number[k],
                   t.second[k] != 0};
            to += t.covers[k];
        }
        if (again != nullptr) again->add(number, t.both, count);
    }
    return to;
}

static bool centres_form(const Corners& grid, std::int32_t half_px, BlockSamples& out) {
    const auto* g = reinterpret_cast<const GridRow(*)[corners]>(&grid);
    Centres c;
    LeafList list, again;
    if (!list_centres(g, half_px, c, list)) return false;
    BlockSample* to = sample_list(g, c, list, half_px, &again, out.sample.data());
    again.fill_up();
    to = sample_list(g, c, again, half_px, nullptr, to);
    out.tested = static_cast<std::uint64_t>(list.count);
    out.count = static_cast<std::size_t>(to - out.sample.data());
    return true;
}

#endif
