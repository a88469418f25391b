// The samples of a mesh's triangles and their levels in lanes: a part of block_body.hpp's text.
// facet_form.hpp says what each does.
#ifdef UMBRA78_LANES_TEXT

// --- samples -------------------------------------------------------------------------------------

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
        g.x[k] = (2 * (list.px[n] - half_px) + 1) * (1 << (raster_fraction - 1));
        g.y[k] = (2 * (list.py[n] - half_px) + 1) * (1 << (raster_fraction - 1));
    }
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

// Appends the sample, or puts it into the plane.
static inline FacetSample* put_sample(FacetSample s, const CodePlane& plane, FacetSamples& out,
                                      FacetSample* to) {
    if (plane.codes == nullptr) {
        *to = s;
        return to + 1;
    }
    const std::uint32_t code = code_of(s.z, plane);
    if (code >= word(plane.background)) return to;
    ++out.coded;
    std::uint16_t& kept = plane.codes[(std::size_t{s.py} << plane.xy_bits) + s.px];
    if (plane.depth_alone) {
        kept = static_cast<std::uint16_t>(code < kept ? code : kept);
        return to;
    }
    s.z = wrapped(code);
    *to = s;
    return to + (code <= kept ? 1 : 0);
}

static void put_form(const CodePlane& plane, FacetSamples& out) {
    FacetSample* const at = out.sample + out.count;
    out.count = static_cast<std::size_t>(put_sample(*at, plane, out, at) - out.sample);
}

static void few_form(const TriangleBatch& batch, CentreList& list, std::int32_t half_px,
                     const CodePlane& plane, FacetSamples& out) {
    for (std::size_t k = list.count; k % leaves != 0; ++k)
        list.slot[k] = list.px[k] = list.py[k] = 0;
    FacetSample* to = out.sample + out.count;
    for (std::size_t at = 0; at < list.count; at += leaves) {
        FewGroup group;
        FewDepths d;
        collect_few(batch, list, at, half_px, group);
        find_few(group, d);
        const std::size_t count = list.count - at < leaves ? list.count - at : leaves;
        for (std::size_t k = 0; k < count; ++k) {
            if (d.covers[k] == 0) continue;
            const std::uint64_t over = d.dividend[k] / (2 * std::uint64_t{word(group.area[k])});
            to = put_sample({wrapped(word(d.lowest[k]) + static_cast<std::uint32_t>(over)),
                             list.slot[at + k], list.px[at + k], list.py[at + k]},
                            plane, out, to);
        }
    }
    out.count = static_cast<std::size_t>(to - out.sample);
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

// The depths of a line's columns, or their codes; -1 where there is no sample. `columns` is a
// constant where this is inlined.
static inline void sample_line(const Tile& t, const TileColumns& at, const TileLine& line,
                               int columns, Lanes& __restrict z) {
    for (int k = 0; k < columns; ++k)
        z[k] = wrapped(word(line.value) + word(at.quotient[k]) +
                       (line.rest + at.remainder[k] >= t.area ? 1u : 0u));
}
static inline std::int32_t uncovered(const TileColumns& at, const TileLine& line, int k) {
    return (line.e0 + at.edge[0][k]) | (line.e1 + at.edge[1][k]) | (line.e2 + at.edge[2][k]);
}

// Into a plane of depth alone. Tiles are functions of their own: what they read by columns stays in
// memory, from where it comes as vectors.
static inline void draw_tile(const Tile& t, const TileColumns& at, const CodePlane& plane,
                             int columns, FacetSamples& out) {
    TileLine line{t.edge[0], t.edge[1], t.edge[2], t.value, t.rest};
    std::uint16_t* row = plane.codes + (std::size_t{t.py} << plane.xy_bits) + t.px;
    Lanes coded;
    for (int k = 0; k < columns; ++k) coded[k] = 0;
    for (int n = 0; n < t.lines; ++n, row += std::size_t{1} << plane.xy_bits) {
        Lanes z;
        sample_line(t, at, line, columns, z);
        for (int k = 0; k < columns; ++k) {
            const std::uint32_t code = code_of(z[k], plane), kept = row[k];
            const std::int32_t sample = uncovered(at, line, k) >= 0 &&
                                                code < word(plane.background)
                                            ? at.taken[k] : 0;
            coded[k] += sample;
            row[k] = static_cast<std::uint16_t>(sample != 0 && code < kept ? code : kept);
        }
        line.next(t);
    }
    for (int k = 0; k < columns; ++k) out.coded += word(coded[k]);
}

// Into the list: those that do not lie behind what the plane has, or all if there is none.
static inline void list_tile(const Tile& t, const TileColumns& at, const CodePlane& plane,
                             int columns, FacetSamples& out) {
    TileLine line{t.edge[0], t.edge[1], t.edge[2], t.value, t.rest};
    const std::uint16_t* row = plane.codes;
    if (row != nullptr) row += (std::size_t{t.py} << plane.xy_bits) + t.px;
    Lanes coded;
    for (int k = 0; k < columns; ++k) coded[k] = 0;
    FacetSample* to = out.sample + out.count;
    for (int n = 0; n < t.lines; ++n) {
        Lanes z;
        std::uint32_t samples = 0;
        sample_line(t, at, line, columns, z);
        if (row == nullptr) {
            for (int k = 0; k < columns; ++k)
                samples |= (uncovered(at, line, k) >= 0 ? word(at.taken[k]) : 0) << k;
        } else {
            for (int k = 0; k < columns; ++k) {
                const std::uint32_t code = code_of(z[k], plane), kept = row[k];
                const std::uint32_t sample = uncovered(at, line, k) >= 0 &&
                                                     code < word(plane.background)
                                                 ? word(at.taken[k]) : 0;
                coded[k] += wrapped(sample);
                samples |= (code <= kept ? sample : 0) << k;
                z[k] = wrapped(code);
            }
            row += std::size_t{1} << plane.xy_bits;
        }
        for (; samples != 0; samples &= samples - 1) {
            const int k = __builtin_ctz(samples);
            *to++ = {z[k], t.slot, static_cast<std::uint16_t>(t.px + k),
                     static_cast<std::uint16_t>(t.py + n)};
        }
        line.next(t);
    }
    for (int k = 0; k < columns; ++k) out.coded += word(coded[k]);
    out.count = static_cast<std::size_t>(to - out.sample);
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

// 16 samples: whose they are, and where. A triangle has many that follow each other.
struct SampleGroup {
    Lanes x, y;
    std::size_t slot[leaves];
    bool alike;  // all of one triangle
};

static inline void collect_samples(const FacetSample* list, std::size_t count,
                                   std::int32_t half_px, SampleGroup& __restrict g) {
    g.alike = list[0].slot == list[count - 1].slot;  // slots do not come back
    for (std::size_t k = 0; k < leaves; ++k) {       // the last group is filled up with its first
        const FacetSample& s = list[k < count ? k : 0];
        g.x[k] = (2 * (s.px - half_px) + 1) * (1 << (raster_fraction - 1));
        g.y[k] = (2 * (s.py - half_px) + 1) * (1 << (raster_fraction - 1));
        g.slot[k] = s.slot;
    }
}
static inline void take_words(const std::int32_t* from, const SampleGroup& g,
                              Lanes& __restrict to) {
    if (g.alike) {
        for (int k = 0; k < leaves; ++k) to[k] = from[g.slot[0]];
    } else {
        for (int k = 0; k < leaves; ++k) to[k] = from[g.slot[k]];
    }
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
        std::uint32_t cut = 0;
        for (std::uint32_t step = 16; step > 0; step /= 2) {
            const std::uint32_t much = (above >> step) != 0 ? step : 0;
            above >>= much;
            cut += much;
        }
        cut += above;  // the last bit
        e.a[k] = wrapped(static_cast<std::uint32_t>(static_cast<std::uint64_t>(e.of_a[k]) >> cut));
        e.b[k] = wrapped(static_cast<std::uint32_t>(static_cast<std::uint64_t>(e.of_b[k]) >> cut));
        e.c[k] = wrapped(static_cast<std::uint32_t>(static_cast<std::uint64_t>(e.of_c[k]) >> cut));
    }
}

// half_up(1024 of / whole), digit by digit: of <= whole < 2^27.
static inline void find_part(const Lanes& of, const SampleEdges& e, Lanes& __restrict part) {
    for (int k = 0; k < leaves; ++k) {
        const std::uint32_t whole = word(e.a[k]) + word(e.b[k]) + word(e.c[k]);
        std::uint32_t rest = word(of[k]), digits = 0;
        for (int digit = 0; digit <= 10; ++digit) {
            const bool one = rest >= whole;
            rest = 2 * (one ? rest - whole : rest);
            digits = 2 * digits + (one ? 1 : 0);
        }
        part[k] = wrapped(digits + (rest >= whole ? 1 : 0));
    }
}

static void shade_facets_form(const ShadeJob& job, const TriangleBatch& batch,
                              const FacetNormals& normals, std::int32_t half_px,
                              const FacetSample* samples, std::size_t count,
                              LeafLevels& out) {
    for (std::size_t at = 0; at < count; at += leaves) {
        const std::size_t some = count - at < leaves ? count - at : leaves;
        SampleGroup group;
        SampleEdges edges;
        Lanes of_b, of_c, base, to_b, to_c;
        LeafNormals mean;
        std::uint8_t number[leaves];
        collect_samples(samples + at, some, half_px, group);
        find_edges(batch, group, edges);
        find_part(edges.b, edges, of_b);
        find_part(edges.c, edges, of_c);
        for (int axis = 0; axis < 3; ++axis) {
            take_words(normals.base[axis], group, base);
            take_words(normals.to_b[axis], group, to_b);
            take_words(normals.to_c[axis], group, to_c);
            for (int k = 0; k < leaves; ++k)
                mean.n[axis][k] = base[k] + of_b[k] * to_b[k] + of_c[k] * to_c[k];
        }
        for (int k = 0; k < leaves; ++k)
            number[k] = static_cast<std::uint8_t>(at + static_cast<std::size_t>(k));
        shade_16(job, mean, number, some, out);
    }
}

#endif
