// The levels of a mesh's samples in lanes: a part of block_body.hpp's text.
#ifdef UMBRA78_LANES_TEXT

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
    v = v >> down;
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
    whole = whole << up;
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
        b = b << up;
        c = c << up;
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
