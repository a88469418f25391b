// A mesh's vertices and triangles in lanes: a part of block_body.hpp's text. facet_form.hpp says
// what each does.
#ifdef UMBRA78_LANES_TEXT

static inline std::int64_t down_wide(std::int64_t v, int n) { return fixed::floor_shift(v, n); }
static inline std::int32_t narrow(std::int64_t v) { return static_cast<std::int32_t>(v); }

// --- vertices ------------------------------------------------------------------------------------

static inline void see_row(const VertexRow& row, int axis, const Lanes* word_of,
                           Lanes& __restrict at, Lanes& __restrict outside) {
    for (int k = 0; k < leaves; ++k) {
        const std::int64_t v = down_wide(times_signed(row.coefficient[0], word_of[0][k]) +
                                             times_signed(row.coefficient[1], word_of[1][k]) +
                                             times_signed(row.coefficient[2], word_of[2][k]) +
                                             row.constant,
                                         row.down);
        at[k] = narrow(v);
        outside[k] |= (v < -row.edge ? 1 << 2 * axis : 0) | (v > row.edge ? 2 << 2 * axis : 0) |
                      (((v < -row.band) | (v > row.band)) ? 1 << 6 : 0);
    }
}

static void see_form(const VertexJob& job, const World* first, SeenVertex* out) {
    Lanes words[3], at[3], outside;
    const std::uint32_t half = 1u << (job.object_down - 1);
    for (int k = 0; k < leaves; ++k) {
        words[0][k] = down(wrapped(word(first[k].x) + half), job.object_down);
        words[1][k] = down(wrapped(word(first[k].y) + half), job.object_down);
        words[2][k] = down(wrapped(word(first[k].z) + half), job.object_down);
        outside[k] = 0;
    }
    for (int axis = 0; axis < 3; ++axis)
        see_row(job.row[axis], axis, words, at[axis], outside);
    for (int k = 0; k < leaves; ++k)
        out[k] = {at[0][k], at[1][k], at[2][k], word(outside[k])};
}

// --- triangles -----------------------------------------------------------------------------------

static inline std::int32_t first_of(std::int32_t a, std::int32_t b, std::int32_t c) {
    return least(least(a, b), c);
}
static inline std::int32_t last_of(std::int32_t a, std::int32_t b, std::int32_t c) {
    return most(most(a, b), c);
}

// The corners in clockwise order.
struct Ordered {
    Lanes x[3], y[3], z[3], sign;  // of the area as it was
    std::int64_t area[leaves];
};

static inline void order_corners(const SeenVertex* a, const SeenVertex* b, const SeenVertex* c,
                                 Ordered& __restrict t) {
    for (int k = 0; k < leaves; ++k) {
        const std::int32_t ax = a[k].x, ay = a[k].y;
        const std::int64_t area = times_signed(b[k].x - ax, c[k].y - ay) -
                                  times_signed(c[k].x - ax, b[k].y - ay);
        const bool back = area < 0;
        t.area[k] = back ? -area : area;
        t.sign[k] = area > 0 ? 1 : back ? -1 : 0;
        t.x[0][k] = ax;
        t.y[0][k] = ay;
        t.z[0][k] = a[k].z;
        t.x[1][k] = back ? c[k].x : b[k].x;
        t.y[1][k] = back ? c[k].y : b[k].y;
        t.z[1][k] = back ? c[k].z : b[k].z;
        t.x[2][k] = back ? b[k].x : c[k].x;
        t.y[2][k] = back ? b[k].y : c[k].y;
        t.z[2][k] = back ? b[k].z : c[k].z;
    }
}

struct CentreBoxes {
    Lanes x0, x1, y0, y1, wide, deep;
};

// Along one axis, as centre_box has it: the last pixel of a column is that of `max`, of a line that
// of max - 1.
static inline void find_box(const Lanes* at, std::int32_t half_px, std::int32_t below,
                            Lanes& __restrict from, Lanes& __restrict to,
                            Lanes& __restrict wide) {
    const std::int32_t end = 2 * half_px - 1;
    const std::int32_t to_last = half_px * (1 << raster_fraction) - (1 << (raster_fraction - 1));
    const std::int32_t to_first = to_last + (1 << raster_fraction) - 1;
    for (int k = 0; k < leaves; ++k) {
        const std::int32_t low = first_of(at[0][k], at[1][k], at[2][k]);
        const std::int32_t high = last_of(at[0][k], at[1][k], at[2][k]);
        from[k] = most(down(low + to_first, raster_fraction), 0);
        to[k] = least(down(high - below + to_last, raster_fraction), end);
        wide[k] = most(wide[k], high - low);
    }
}

static inline void find_kinds(const MeasureJob& job, const Ordered& t, const CentreBoxes& box,
                              Lanes& __restrict kind) {
    const auto number = [](TriangleKind k) { return static_cast<std::int32_t>(k); };
    // By sign: 1, 0, -1.
    const std::int32_t clockwise = job.clockwise ? 1 : 0, on = job.edge_on ? 1 : 0;
    const std::int32_t counter = job.counter_clockwise ? 1 : 0;
    for (int k = 0; k < leaves; ++k) {
        const std::int32_t columns = box.x1[k] - box.x0[k] + 1, lines = box.y1[k] - box.y0[k] + 1;
        std::int32_t v = number(TriangleKind::wide);
        v = most(box.wide[k] - max_tiled, box.deep[k] - max_tiled_depth) <= 0
                ? number(TriangleKind::tiled) : v;
        v = most(box.wide[k] - max_few, columns * lines - most_few) <= 0
                ? number(TriangleKind::few) : v;
        v = least(columns, lines) <= 0 ? number(TriangleKind::empty) : v;
        v = t.sign[k] == 0 ? number(TriangleKind::empty) : v;
        const std::int32_t drawn = t.sign[k] > 0 ? clockwise : t.sign[k] < 0 ? counter : on;
        kind[k] = drawn != 0 ? v : number(TriangleKind::turned);
    }
}

static inline void find_less(const Ordered& t, int p, int q, std::int32_t* __restrict less) {
    for (int k = 0; k < leaves; ++k) {
        const bool up = t.y[q][k] < t.y[p][k];
        const bool level = (t.y[q][k] == t.y[p][k]) & (t.x[q][k] > t.x[p][k]);
        less[k] = (up | level) ? 0 : 1;
    }
}

static inline void keep_lanes(const Lanes& from, std::int32_t* __restrict to) {
    for (int k = 0; k < leaves; ++k) to[k] = from[k];
}

static void measure_16(const MeasureJob& job, std::size_t at, TriangleBatch& b) {
    Ordered t;
    CentreBoxes box;
    Lanes kind, depth[2];
    order_corners(b.seen[0] + at, b.seen[1] + at, b.seen[2] + at, t);
    for (int k = 0; k < leaves; ++k) box.wide[k] = box.deep[k] = 0;
    find_box(t.x, job.half_px, 0, box.x0, box.x1, box.wide);
    find_box(t.y, job.half_px, 1, box.y0, box.y1, box.wide);
    find_box(t.z, job.half_px, 0, depth[0], depth[1], box.deep);
    find_kinds(job, t, box, kind);
    for (int c = 0; c < 3; ++c) {
        keep_lanes(t.x[c], b.x[c] + at);
        keep_lanes(t.y[c], b.y[c] + at);
        keep_lanes(t.z[c], b.z[c] + at);
        find_less(t, (c + 1) % 3, (c + 2) % 3, b.less[c] + at);
    }
    keep_lanes(box.x0, b.x0 + at);
    keep_lanes(box.x1, b.x1 + at);
    keep_lanes(box.y0, b.y0 + at);
    keep_lanes(box.y1, b.y1 + at);
    for (std::size_t k = 0; k < leaves; ++k) {
        b.area[at + k] = t.area[k];
        b.exchanged[at + k] = static_cast<std::uint8_t>(word(t.sign[k]) / 2 % 2);  // of -1
        b.kind[at + k] = static_cast<std::uint8_t>(kind[k]);
    }
}

static void measure_form(const MeasureJob& job, TriangleBatch& batch) {
    for (int c = 0; c < 3; ++c)
        for (std::size_t k = batch.count; k % leaves != 0; ++k) batch.seen[c][k] = {0, 0, 0, 0};
    for (std::size_t at = 0; at < batch.count; at += leaves) measure_16(job, at, batch);
}

#include "raster/triangle_body.hpp"
#include "raster/facet_shade_body.hpp"

#endif
