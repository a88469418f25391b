// The samples of a mesh's triangles in lanes: a part of block_body.hpp's text.
// facet_form.hpp says what each does.
#ifdef UMBRA78_LANES_TEXT

// --- samples -------------------------------------------------------------------------------------

// The centres of 16 pixels.
static inline void find_centres_of(const std::uint32_t* place, std::int32_t half_px,
                                   Lanes& __restrict x, Lanes& __restrict y) {
    for (int k = 0; k < leaves; ++k) {
        const std::int32_t px = wrapped(place[k] % 65536), py = wrapped(place[k] / 65536);
        x[k] = (2 * (px - half_px) + 1) * (1 << (raster_fraction - 1));
        y[k] = (2 * (py - half_px) + 1) * (1 << (raster_fraction - 1));
    }
}

// 16 triangles with a centre each.
struct FewGroup {
    Lanes ax, ay, az, bx, by, bz, cx, cy, cz, area, less[3], x, y;
};

static inline void collect_few(const TriangleBatch& t, const CentreList& list, std::size_t at,
                               std::int32_t half_px, FewGroup& __restrict g) {
    for (int k = 0; k < leaves; ++k) {
        const std::size_t n = at + static_cast<std::size_t>(k), s = list.slot[n];
        g.ax[k] = t.x[0][s];
        g.ay[k] = t.y[0][s];
        g.az[k] = t.z[0][s];
        g.bx[k] = t.x[1][s];
        g.by[k] = t.y[1][s];
        g.bz[k] = t.z[1][s];
        g.cx[k] = t.x[2][s];
        g.cy[k] = t.y[2][s];
        g.cz[k] = t.z[2][s];
        g.area[k] = narrow(t.area[s]);
        for (int c = 0; c < 3; ++c) g.less[c][k] = t.less[c][s];
    }
    find_centres_of(list.place + at, half_px, g.x, g.y);
}

// What covers(), and the depth over the lowest corner's as a dividend.
struct FewDepths {
    Lanes covers, lowest;
    std::uint64_t dividend[leaves];
};

static inline void find_few(const FewGroup& g, FewDepths& __restrict d) {
    for (int k = 0; k < leaves; ++k) {
        const auto less = [](std::int32_t a, std::int32_t b) { return word(a) - word(b); };
        const std::uint32_t x = less(g.x[k], g.ax[k]), y = less(g.y[k], g.ay[k]);
        const std::uint32_t bx = less(g.bx[k], g.ax[k]), by = less(g.by[k], g.ay[k]);
        const std::uint32_t cx = less(g.cx[k], g.ax[k]), cy = less(g.cy[k], g.ay[k]);
        const std::uint32_t of_c = bx * y - x * by, of_b = x * cy - cx * y;
        const std::uint32_t of_a = word(g.area[k]) - of_b - of_c;
        const std::uint32_t out = (of_a - word(g.less[0][k])) | (of_b - word(g.less[1][k])) |
                                  (of_c - word(g.less[2][k]));
        const std::int32_t lowest = first_of(g.az[k], g.bz[k], g.cz[k]);
        const std::uint64_t rise = times(of_a, less(g.az[k], lowest)) +
                                   times(of_b, less(g.bz[k], lowest)) +
                                   times(of_c, less(g.cz[k], lowest));
        d.covers[k] = wrapped(out) >= 0 ? 1 : 0;
        d.lowest[k] = lowest;
        d.dividend[k] = 2 * rise + word(g.area[k]);
    }
}

// The code of a depth: 0 to background - 1, or greater where there is none.
static inline std::uint32_t code_of(std::int32_t z, const CodePlane& plane) {
    const std::int32_t half = 1 << (plane.guard - 1);
    const std::uint32_t c = word(down(wrapped(word(z) + word(half)), plane.guard)) +
                            word(plane.offset);
    return c - (c == word(plane.background) ? 1 : 0);
}

// What is behind the last sample becomes one, or is put into the plane.
static inline void put_sample(const CodePlane& plane, FacetSamples& out) {
    const std::size_t at = out.count;
    if (plane.codes == nullptr) {
        out.count = at + 1;
        return;
    }
    const std::uint32_t code = code_of(out.z[at], plane), place = out.place[at];
    if (code >= word(plane.background)) return;
    ++out.coded;
    std::uint16_t& kept =
        plane.codes[(std::size_t{place / 65536} << plane.xy_bits) + place % 65536];
    if (plane.depth_alone) {
        kept = static_cast<std::uint16_t>(code < kept ? code : kept);
        return;
    }
    out.z[at] = wrapped(code);
    out.count = at + (code <= kept ? 1 : 0);
}
static void put_form(const CodePlane& plane, FacetSamples& out) { put_sample(plane, out); }

static void few_form(const TriangleBatch& batch, CentreList& list, std::int32_t half_px,
                     const CodePlane& plane, FacetSamples& out) {
    for (std::size_t k = list.count; k % leaves != 0; ++k)
        list.slot[k] = 0, list.place[k] = 0;
    for (std::size_t at = 0; at < list.count; at += leaves) {
        FewGroup group;
        FewDepths d;
        collect_few(batch, list, at, half_px, group);
        find_few(group, d);
        const std::size_t count = list.count - at < leaves ? list.count - at : leaves;
        for (std::size_t k = 0; k < count; ++k) {
            if (d.covers[k] == 0) continue;
            const std::uint64_t over = d.dividend[k] / (2 * std::uint64_t{word(group.area[k])});
            out.z[out.count] = wrapped(word(d.lowest[k]) + static_cast<std::uint32_t>(over));
            out.place[out.count] = list.place[at + k];
            out.slot[out.count] = list.slot[at + k];
            put_sample(plane, out);
        }
    }
}

// A tile's state on a line.
struct TileLine {
    std::int32_t e0, e1, e2, value;
    std::int64_t rest;

    void next(const Tile& t) {
        e0 += t.down[0];
        e1 += t.down[1];
        e2 += t.down[2];
        rest += t.down_remainder;
        const bool carries = rest >= t.area;
        rest -= carries ? t.area : 0;
        value = wrapped(word(value) + word(t.down_quotient) + (carries ? 1u : 0u));
    }
};

// The depths of a line's columns. `columns` is a constant where these are inlined.
static inline void find_depths_of(const Tile& t, const TileColumns& at, const TileLine& line,
                                  int columns, std::int32_t* __restrict z) {
    for (int k = 0; k < columns; ++k)
        z[k] = wrapped(word(line.value) + word(at.quotient[k]) +
                       (line.rest + at.remainder[k] >= t.area ? 1u : 0u));
}
// All ones where a centre is covered.
static inline void find_covered(const TileColumns& at, const TileLine& line, int columns,
                                Lanes& __restrict covered) {
    for (int k = 0; k < columns; ++k)
        covered[k] = at.taken[k] & ~down((line.e0 + at.edge[0][k]) | (line.e1 + at.edge[1][k]) |
                                             (line.e2 + at.edge[2][k]),
                                         31);
}
// Depths to codes; leaves those in `covered` that have one, and counts them in `coded`.
static inline void find_codes(const CodePlane& plane, int columns, std::int32_t* __restrict z,
                              Lanes& __restrict covered, Lanes& __restrict coded) {
    for (int k = 0; k < columns; ++k) {
        const std::uint32_t code = code_of(z[k], plane);
        z[k] = wrapped(code);
        covered[k] &= code < word(plane.background) ? -1 : 0;
        coded[k] -= covered[k];
    }
}
// A row's codes as words of the lanes' width: by whole vectors, so that they can be read as such.
typedef std::uint16_t Codes8 __attribute__((vector_size(16)));
typedef std::uint16_t Codes16 __attribute__((vector_size(32)));
typedef std::int32_t Words8 __attribute__((vector_size(32)));
typedef std::int32_t Words16 __attribute__((vector_size(64)));

static inline void get_codes(const std::uint16_t* row, int columns, Lanes& __restrict kept) {
    if (columns == 8) {
        Codes8 codes;
        __builtin_memcpy(&codes, row, sizeof codes);
        const Words8 words = __builtin_convertvector(codes, Words8);
        __builtin_memcpy(kept, &words, sizeof words);
    } else {
        Codes16 codes;
        __builtin_memcpy(&codes, row, sizeof codes);
        const Words16 words = __builtin_convertvector(codes, Words16);
        __builtin_memcpy(kept, &words, sizeof words);
    }
}
static inline std::uint64_t sum_of(const Lanes& v, int columns) {
    std::uint32_t sum = 0;
    for (int k = 0; k < columns; ++k) sum += word(v[k]);
    return sum;
}

// Into a plane of depth alone.
static inline void draw_tile(const Tile& t, const TileColumns& at, const CodePlane& plane,
                             int columns, FacetSamples& out) {
    TileLine line{t.edge[0], t.edge[1], t.edge[2], t.value, t.rest};
    std::uint16_t* row = plane.codes + (std::size_t{t.py} << plane.xy_bits) + t.px;
    Lanes coded = {};
    for (int n = 0; n < t.lines; ++n, row += std::size_t{1} << plane.xy_bits) {
        Lanes z, covered, kept;
        find_depths_of(t, at, line, columns, z);
        find_covered(at, line, columns, covered);
        find_codes(plane, columns, z, covered, coded);
        get_codes(row, columns, kept);
        for (int k = 0; k < columns; ++k) {
            const std::int32_t nearer = least(z[k], kept[k]);
            row[k] = static_cast<std::uint16_t>(covered[k] != 0 ? nearer : kept[k]);
        }
        line.next(t);
    }
    out.coded += sum_of(coded, columns);
}

// A bit for each column.
static inline std::uint32_t bits_of(const Lanes& mask, int columns) {
    std::uint32_t bits = 0;
    for (int k = 0; k < columns; ++k) bits |= word(mask[k]) & (1u << k);
    return bits;
}

// Writes `columns` samples of which the first ones are a run.
static inline void append_run(const std::int32_t* z, std::uint32_t place, std::uint16_t slot,
                              int columns, FacetSamples& out, std::size_t at) {
    for (int k = 0; k < columns; ++k) out.z[at + word(k)] = z[k];
    for (int k = 0; k < columns; ++k) out.place[at + word(k)] = place + word(k);
    for (int k = 0; k < columns; ++k) out.slot[at + word(k)] = slot;
}

// Into the list: those that do not lie behind what the plane has, or all if there is none.
static inline void list_tile(const Tile& t, const TileColumns& at, const CodePlane& plane,
                             int columns, FacetSamples& out) {
    TileLine line{t.edge[0], t.edge[1], t.edge[2], t.value, t.rest};
    const std::uint16_t* row = plane.codes;
    if (row != nullptr) row += (std::size_t{t.py} << plane.xy_bits) + t.px;
    Lanes coded = {};
    std::size_t to = out.count;
    std::int32_t z[2 * leaves] = {};
    for (int n = 0; n < t.lines; ++n) {
        Lanes covered, kept;
        find_depths_of(t, at, line, columns, z);
        find_covered(at, line, columns, covered);
        if (row != nullptr) {
            find_codes(plane, columns, z, covered, coded);
            get_codes(row, columns, kept);
            for (int k = 0; k < columns; ++k) covered[k] &= z[k] <= kept[k] ? -1 : 0;
            row += std::size_t{1} << plane.xy_bits;
        }
        const std::uint32_t place = place_of(t.px, static_cast<std::uint16_t>(t.py + n));
        std::uint32_t rest = bits_of(covered, columns);
        while (rest != 0) {  // as a rule one run
            const int from = __builtin_ctz(rest), end = __builtin_ctz(~rest >> from) + from;
            append_run(z + from, place + word(from), t.slot, columns, out, to);
            to += static_cast<std::size_t>(end - from);
            rest &= ~0u << end;
        }
        line.next(t);
    }
    out.coded += sum_of(coded, columns);
    out.count = to;
}

static void tile_form(const Tile& tile, const TileColumns& at, const CodePlane& plane,
                      FacetSamples& out) {
    constexpr int half = TileColumns::most / 2;
    if (plane.codes != nullptr && plane.depth_alone) {
        if (tile.columns == half) return draw_tile(tile, at, plane, half, out);
        return draw_tile(tile, at, plane, TileColumns::most, out);
    }
    if (tile.columns == half) return list_tile(tile, at, plane, half, out);
    list_tile(tile, at, plane, TileColumns::most, out);
}

#endif
