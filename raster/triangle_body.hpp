// The samples of a mesh's triangles and their levels in lanes: a part of block_body.hpp's text.
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

// --- shading -------------------------------------------------------------------------------------

// The edges' values at 16 samples, less as many low bits as bring the greatest to 24 bits.
struct SampleEdges {
    std::int64_t of_a[leaves], of_b[leaves], of_c[leaves];
    Lanes a, b, c;
};

// 16 samples: whose they are, and where. A triangle has many that follow each other. The last
// group is filled up with its first.
struct SampleGroup {
    std::uint32_t place[leaves], slot[leaves];
    Lanes x, y;
    bool alike;  // all of one triangle
};

static inline void collect_samples(const FacetSamples& list, std::size_t at, std::size_t count,
                                   std::int32_t half_px, SampleGroup& __restrict g) {
    for (std::size_t k = 0; k < leaves; ++k) g.place[k] = list.place[at + k];
    for (std::size_t k = 0; k < leaves; ++k) g.slot[k] = list.slot[at + k];
    for (std::size_t k = count; k < leaves; ++k) {
        g.place[k] = g.place[0];
        g.slot[k] = g.slot[0];
    }
    g.alike = g.slot[0] == g.slot[count - 1];  // slots do not come back
    find_centres_of(g.place, half_px, g.x, g.y);
}
static inline void take_words(const std::int32_t* from, const SampleGroup& g,
                              Lanes& __restrict to) {
    if (g.alike) {
        for (int k = 0; k < leaves; ++k) to[k] = from[g.slot[0]];
    } else {
        for (int k = 0; k < leaves; ++k) to[k] = from[g.slot[k]];
    }
}

// Shifts v down if it has bits above the lowest `step`, and returns by how much.
static inline std::uint32_t drop(std::uint32_t& v, int step) {
    const std::uint32_t down = (v >> step) != 0 ? static_cast<std::uint32_t>(step) : 0;
    v >>= down;
    return down;
}

static inline void find_edges(const TriangleBatch& t, const SampleGroup& g,
                              SampleEdges& __restrict e) {
    Lanes x[3], y[3];
    for (int c = 0; c < 3; ++c) {
        take_words(t.x[c], g, x[c]);
        take_words(t.y[c], g, y[c]);
        for (int k = 0; k < leaves; ++k) x[c][k] -= g.x[k];
        for (int k = 0; k < leaves; ++k) y[c][k] -= g.y[k];
    }
    for (int k = 0; k < leaves; ++k) {  // about the sample: turn(p, q) is the product of p and q
        e.of_a[k] = times_signed(x[1][k], y[2][k]) - times_signed(x[2][k], y[1][k]);
        e.of_b[k] = times_signed(x[2][k], y[0][k]) - times_signed(x[0][k], y[2][k]);
        e.of_c[k] = times_signed(x[0][k], y[1][k]) - times_signed(x[1][k], y[0][k]);
    }
    for (int k = 0; k < leaves; ++k) {
        const std::int64_t ab = e.of_a[k] < e.of_b[k] ? e.of_b[k] : e.of_a[k];
        const std::int64_t largest = ab < e.of_c[k] ? e.of_c[k] : ab;
        std::uint32_t above = static_cast<std::uint32_t>(
            static_cast<std::uint64_t>(largest) >> 24);  // not negative
        std::uint32_t cut = drop(above, 16);
        cut += drop(above, 8);
        cut += drop(above, 4);
        cut += drop(above, 2);
        cut += drop(above, 1);
        cut += above;  // the last bit
        const auto less = [&](std::int64_t v) {
            return wrapped(static_cast<std::uint32_t>(static_cast<std::uint64_t>(v) >> cut));
        };
        e.a[k] = less(e.of_a[k]);
        e.b[k] = less(e.of_b[k]);
        e.c[k] = less(e.of_c[k]);
    }
}

// half_up(1024 e / whole) for the edges' values b and c. Both sides are made longer alike until
// 2^25 <= whole < 2^26. With w = whole / 2^26 in 1/2 .. 1 and y near 1 / w
//
//   y <- y (2 - w y)      from a line, (48 - 32 w) / 17, within 1/17
//
// 2 steps in words of 16 bits leave 2^-14, so a quotient is within one, which its rest decides.
struct Parts {
    Lanes b, c;
};

static inline std::int32_t exact_part(std::uint32_t e, std::uint32_t whole, std::uint32_t y) {
    const std::uint32_t q = ((e >> 10) * y + (1u << 20)) >> 21;
    const std::int32_t rest = wrapped(2048 * e + whole - 2 * whole * q);  // 0 to 2 whole - 1
    return wrapped(q) - (rest < 0 ? 1 : 0) + (rest >= wrapped(2 * whole) ? 1 : 0);
}

// Shifts `whole` up if its highest bits are 0, and returns by how much.
static inline std::uint32_t lift(std::uint32_t& whole, int step) {
    const std::uint32_t up = whole < 1u << (26 - step) ? static_cast<std::uint32_t>(step) : 0;
    whole <<= up;
    return up;
}

static inline void find_parts(const SampleEdges& e, Parts& __restrict part) {
    for (int k = 0; k < leaves; ++k) {
        std::uint32_t b = word(e.b[k]), c = word(e.c[k]);
        std::uint32_t whole = word(e.a[k]) + b + c;
        std::uint32_t up = lift(whole, 16);
        up += lift(whole, 8);
        up += lift(whole, 4);
        up += lift(whole, 2);
        up += lift(whole, 1);
        b <<= up;
        c <<= up;
        const std::uint32_t w = whole >> 10;                 // Q.16
        const std::uint32_t y0 = 92521 - (w * 61681 >> 16);  // Q.15
        const std::uint32_t y1 = y0 * (65536 - (w * y0 >> 16)) >> 15;
        const std::uint32_t y = y1 * (65536 - (w * y1 >> 16)) >> 15;
        part.b[k] = exact_part(b, whole, y);
        part.c[k] = exact_part(c, whole, y);
    }
}

static void shade_facets_form(const ShadeJob& job, const TriangleBatch& batch,
                              const FacetNormals& normals, std::int32_t half_px,
                              const FacetSamples& list, std::size_t first, std::size_t count,
                              LeafLevels& out) {
    for (std::size_t at = 0; at < count; at += leaves) {
        const std::size_t some = count - at < leaves ? count - at : leaves;
        SampleGroup group;
        SampleEdges edges;
        Parts of;
        Lanes base, to_b, to_c;
        LeafNormals mean;
        std::uint8_t number[leaves];
        collect_samples(list, first + at, some, half_px, group);
        find_edges(batch, group, edges);
        find_parts(edges, of);
        for (int axis = 0; axis < 3; ++axis) {
            take_words(normals.base[axis], group, base);
            take_words(normals.to_b[axis], group, to_b);
            take_words(normals.to_c[axis], group, to_c);
            for (int k = 0; k < leaves; ++k)
                mean.n[axis][k] = base[k] + of.b[k] * to_b[k] + of.c[k] * to_c[k];
        }
        for (int k = 0; k < leaves; ++k)
            number[k] = static_cast<std::uint8_t>(at + static_cast<std::size_t>(k));
        shade_16(job, mean, number, some, out);
    }
}

#endif
