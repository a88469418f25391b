// Levels in lanes, of 16 leaves or samples at a time (hw/MACHINE.md, section 9). The second
// part of block_body.hpp's text.
//
// Lengths and quotients come from one reciprocal root: Newton's steps without a division, then the
// exact integer by comparison. With s = |n|^2 / 2^48 in 1/2 .. 1 and y near 1 / sqrt(s)
//
//   y <- y (3 - s y^2) / 2      from a line, 1.788 - 0.81 s, within 2.3 % : 3 steps leave 2^-28
//
// so the root and each cosine are within one of the floor, which two comparisons decide.
#ifdef UMBRA78_LANES_TEXT

typedef std::uint64_t Wide[leaves];

static inline std::uint64_t times(std::uint64_t a, std::uint64_t b) {  // of 32 bits
    return std::uint64_t{static_cast<std::uint32_t>(a)} * static_cast<std::uint32_t>(b);
}
static inline std::int64_t times_signed(std::int32_t a, std::int32_t b) {
    return std::int64_t{a} * b;
}

// Normals of lengths from about 2^23.5 to 2^24, those lengths and about their reciprocals, Q.30 of
// 2^24.
struct LeafNormals {
    Lanes n[3];
    Wide length, reciprocal;
};

// The bilinear mean of a block's normals at the leaves' centres.
static inline void find_normals(const ShadeJob& job, const std::uint8_t* leaf, LeafNormals& out) {
    for (int k = 0; k < 3; ++k) {
        const std::int32_t a = job.normal[0][k], b = job.normal[1][k];
        const std::int32_t c = job.normal[2][k], d = job.normal[3][k];
        for (int i = 0; i < leaves; ++i) {
            const std::int32_t u = 2 * (leaf[i] & 15) + 1;
            const std::int32_t v = 2 * static_cast<std::int32_t>(leaf[i] / 16u) + 1;
            out.n[k][i] = (32 - v) * ((32 - u) * a + u * b) + v * ((32 - u) * c + u * d);
        }
    }
}

static inline void find_lengths(LeafNormals& __restrict out) {
    for (int i = 0; i < leaves; ++i) {
        const auto square = static_cast<std::uint64_t>(times_signed(out.n[0][i], out.n[0][i]) +
                                                       times_signed(out.n[1][i], out.n[1][i]) +
                                                       times_signed(out.n[2][i], out.n[2][i]));
        const std::uint64_t s = square >> 18;                 // Q.30
        std::uint64_t y = 1919850381 - (times(s, 869730877) >> 30);  // the line, Q.30
        for (int step = 0; step < 3; ++step) {
            const std::uint64_t syy = times(s, times(y, y) >> 30) >> 30;
            y = times(y, (std::uint64_t{3} << 30) - syy) >> 31;
        }
        std::uint64_t root = times(s, y) >> 36;
        root -= times(root, root) > square ? 1 : 0;
        root += times(root + 1, root + 1) <= square ? 1 : 0;
        out.length[i] = root;
        out.reciprocal[i] = y;
    }
}

// floor(n . d / |n|) for a direction d. Words are made positive before they are shifted.
static inline void find_cosines(const LeafNormals& l, const std::int32_t* d,
                                Lanes& __restrict out) {
    for (int i = 0; i < leaves; ++i) {
        const std::int64_t dot = times_signed(l.n[0][i], d[0]) + times_signed(l.n[1][i], d[1]) +
                                 times_signed(l.n[2][i], d[2]);
        const auto high = static_cast<std::int32_t>(
            static_cast<std::uint32_t>(static_cast<std::uint64_t>(dot) >> 8));
        const std::int64_t scaled =
            times_signed(high, static_cast<std::int32_t>(l.reciprocal[i]));
        const std::uint64_t quotient =
            (static_cast<std::uint64_t>(scaled) + (std::uint64_t{1} << 62)) >> 46;
        std::int64_t q = static_cast<std::int64_t>(quotient) - (1 << 16);
        const auto length = static_cast<std::int64_t>(l.length[i]);
        const std::int64_t rest =
            dot - times_signed(static_cast<std::int32_t>(q), static_cast<std::int32_t>(length));
        q -= rest < 0 ? 1 : 0;
        q += rest >= length ? 1 : 0;
        out[i] = static_cast<std::int32_t>(q);
    }
}

// The highlight of leaves that face the light, Q1.14.
static inline void find_highlights(const ShadeJob& job, const ShadeSource& source, const Lanes& n_l,
                                   const Lanes& n_v, const Lanes& n_h, Lanes& __restrict out) {
    for (int i = 0; i < leaves; ++i) {
        const std::int32_t h = job.by_halfway ? n_h[i]
                                              : down(2 * n_l[i] * n_v[i], 14) - source.l_dot_v;
        out[i] = least(most(h, 0), 1 << unit_fraction);
    }
    for (int k = 0; k < job.squares; ++k)
        for (int i = 0; i < leaves; ++i)
            out[i] = down(out[i] * out[i] + (1 << 13), unit_fraction);
}

static inline void turn(const Lanes& n_v, Lanes& __restrict cosine) {
    for (int i = 0; i < leaves; ++i) cosine[i] = n_v[i] < 0 ? -cosine[i] : cosine[i];
}

// level() of shading.cpp.
static inline std::uint32_t level_of(std::uint64_t sum) {
    const std::uint64_t rounded = (sum + (std::uint64_t{1} << 29)) >> 30;
    return static_cast<std::uint32_t>(rounded < 255 ? rounded : 255);
}

struct ChannelLevels {
    Wide sum;  // Q.30
    std::uint32_t intensity[leaves];
    std::uint32_t direct[leaves];  // of the source last added
};

// A source's share: the diffuse and specular sums of a unit level fit 31 bits, for a cosine is at
// most 2^14 + 2.
static_assert((std::int64_t{2} << 14) * 255 * 256 + 2 * 255 * 256 < INT32_MAX);
static inline void add_source(const ShadeJob& job, const ShadeSource& source, int channel,
                              const Lanes& n_l, const Lanes& shine,
                              ChannelLevels& __restrict c) {
    const std::int32_t diffuse = job.diffuse[channel] * (256 - job.ambient_q8);
    const std::int32_t specular = job.specular[channel] * 256;
    const auto level = static_cast<std::uint32_t>(source.level_q8[channel]);
    for (int i = 0; i < leaves; ++i) {
        const std::int32_t one = diffuse * n_l[i] + specular * shine[i];
        c.sum[i] += times(n_l[i] > 0 ? word(one) : 0, level);
        const std::uint32_t with = level_of(c.sum[i]);
        c.direct[i] = with - c.intensity[i];
        c.intensity[i] = with;
    }
}

static inline void put(const std::uint8_t* leaf, std::size_t count, const std::uint32_t* levels,
                       std::uint8_t* plane) {
    for (std::size_t i = 0; i < count; ++i) plane[leaf[i]] = static_cast<std::uint8_t>(levels[i]);
}

// The levels of `count` leaves or samples with these normals, by their numbers.
static void shade_measured(const ShadeJob& job, const LeafNormals& normals, const Lanes& n_v,
                           const std::uint8_t* leaf, std::size_t count, LeafLevels& out) {
    Lanes n_l, n_h = {}, shine = {};
    ChannelLevels channels[max_channels];
    for (std::size_t c = 0; c < job.channels; ++c) {
        const std::uint64_t ambient = times(word(job.diffuse[c] * job.ambient_q8), 1 << 22);
        for (int i = 0; i < leaves; ++i) {
            channels[c].sum[i] = ambient;
            channels[c].intensity[i] = level_of(ambient);
        }
    }
    const std::size_t planes = 1 + job.sources;
    for (std::size_t l = 0; l < job.sources; ++l) {
        const ShadeSource& source = job.source[l];
        find_cosines(normals, source.toward, n_l);
        if (job.by_halfway) find_cosines(normals, source.halfway, n_h);
        Lanes facing;
        for (int i = 0; i < leaves; ++i) facing[i] = n_v[i];
        if (job.two_sided) {
            turn(n_v, n_l);
            turn(n_v, n_h);
            turn(n_v, facing);
        }
        if (job.highlights) find_highlights(job, source, n_l, facing, n_h, shine);
        for (std::size_t c = 0; c < job.channels; ++c) {
            add_source(job, source, static_cast<int>(c), n_l, shine, channels[c]);
            put(leaf, count, channels[c].direct, out.level[c * planes + 1 + l]);
        }
    }
    for (std::size_t c = 0; c < job.channels; ++c)
        put(leaf, count, channels[c].intensity, out.level[c * planes]);
}

static void shade_16(const ShadeJob& job, LeafNormals& normals, const std::uint8_t* leaf,
                     std::size_t count, LeafLevels& out) {
    Lanes n_v;
    find_lengths(normals);
    find_cosines(normals, job.viewer, n_v);
    shade_measured(job, normals, n_v, leaf, count, out);
}

static void shade_form(const ShadeJob& job, std::uint8_t* numbers, std::size_t count,
                       LeafLevels& out) {
    for (std::size_t k = 0; k < leaves; ++k)  // the last lanes hold a leaf's number, too
        if (k + 1 < leaves) numbers[count + k] = 0;
    for (std::size_t k = 0; k < count; k += leaves) {
        LeafNormals normals;
        find_normals(job, numbers + k, normals);
        shade_16(job, normals, numbers + k, count - k < leaves ? count - k : leaves, out);
    }
}

static void measure_normals_form(const ShadeJob& job, SampleNormals& __restrict given) {
    LeafNormals normals;
    Lanes n_v;
    for (int k = 0; k < 3; ++k)
        for (int i = 0; i < leaves; ++i) normals.n[k][i] = given.n[k][i];
    find_lengths(normals);
    find_cosines(normals, job.viewer, n_v);
    for (int i = 0; i < leaves; ++i) {
        given.length[i] = static_cast<std::uint32_t>(normals.length[i]);
        given.reciprocal[i] = static_cast<std::uint32_t>(normals.reciprocal[i]);
        given.n_dot_v[i] = n_v[i];
    }
}

static void shade_normals_form(const ShadeJob& job, const SampleNormals& given, std::size_t count,
                               LeafLevels& out) {
    LeafNormals normals;
    Lanes n_v;
    std::uint8_t number[leaves];
    for (int k = 0; k < 3; ++k)
        for (int i = 0; i < leaves; ++i) normals.n[k][i] = given.n[k][i];
    for (int i = 0; i < leaves; ++i) {
        number[i] = static_cast<std::uint8_t>(i);
        normals.length[i] = given.length[i];
        normals.reciprocal[i] = given.reciprocal[i];
        n_v[i] = given.n_dot_v[i];
    }
    shade_measured(job, normals, n_v, number, count, out);
}

#endif
