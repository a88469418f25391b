// A scan line of the post-process in the lanes of a processor. shadow/row_forms.cpp includes this
// text once for each instruction set, in a namespace that says what a Word of `lanes` numbers is
// and names the set's operations; alone it is empty. The arithmetic is that of
// shadow/post_process_rows.cpp, 16 pixels after 16; 16 that are all background are lit at once.
// Not written with templates of other headers, nor with operator >>, whose meaning on lanes depends
// on their type: `down` is the floor of v / 2^n.
#ifdef UMBRA78_LANES
#ifdef __clang__
#define UMBRA78_NO_DEPENDENCE _Pragma("clang loop vectorize(assume_safety)")
#else
#define UMBRA78_NO_DEPENDENCE _Pragma("GCC ivdep")
#endif

constexpr int block = 16, parts = block / lanes;

// A row of the matrix, in all lanes. Its results count from `origin`, the map's corner.
struct Share {
    Word high, low, coefficient;
    Count shift, shift_to_texel, fraction_bits;
    const std::int32_t *column_high, *column_low;
};
UMBRA78_LANES Share share_of(const RowLine& line, const RowMemory& m, int row,
                             std::int32_t origin) {
    const RowShare& s = line.share[row];
    const std::int32_t coefficient = s.z_coefficient & 0xffff;  // beside 0 of the other half
    const std::uint32_t from = line.whole ? static_cast<std::uint32_t>(origin) << s.shift : 0;
    const auto low = static_cast<std::int32_t>(static_cast<std::uint32_t>(s.low) + from);
    const int f = line.fraction_bits;
    return {all(s.high + origin), all(low), all(coefficient), count(s.shift),
            count(s.shift + f), count(f), m.column_high[row], m.column_low[row]};
}

// What the loop is compiled for.
struct Kind {
    bool whole, four, dithered;
};

UMBRA78_LANES Word sum_at(const Share& s, Word z, int x) {
    return load(s.column_low + x) + add_products(s.low, z, s.coefficient);
}
UMBRA78_LANES Word split_result(const Share& s, Word z, int x) {
    return load(s.column_high + x) + s.high + down(sum_at(s, z, x), s.shift);
}
// X or Y, dithered; for nearest lookup the texel alone. Where the sum is modulo 2^32 the dither
// comes before its last bits are rounded off, and all bits below the texel's go at once.
UMBRA78_LANES Word coordinate(const Share& s, Word z, int x, Word dither, Kind k) {
    if (k.whole) {
        const Word sum = sum_at(s, z, x);
        return down_unsigned(k.dithered ? sum + up(dither, s.shift) : sum,
                             k.four ? s.shift : s.shift_to_texel);
    }
    const Word result = split_result(s, z, x);
    const Word place = k.dithered ? result + dither : result;
    return k.four ? place : down(place, s.fraction_bits);
}

struct Place {
    Word x, y;  // from the map's upper left corner
    Word code;
};
UMBRA78_LANES Place place_of(const Share* s, Word z, const RowMemory& m, int x, Kind k) {
    const Word noise = k.dithered ? load(m.noise + 2 * x) : Word{};
    const Word code =
        k.whole ? down_unsigned(sum_at(s[2], z, x), s[2].shift) : split_result(s[2], z, x);
    return {coordinate(s[0], z, x, down16(up16(noise)), k),
            coordinate(s[1], z, x, down16(noise), k), code};
}

// What the lanes compare with.
struct Limits {
    Word side;         // of the map, a power of 2, in the unit of the places
    Word background;   // as a code
    Word last_texel;   // its address
    Word last_corner;  // the last X or Y, half a texel back, that has four texels
    Word half, fraction, one, offset;  // half a texel
    Count f, xy, twice_f;
    const hw::Depth16* texels;
    int width;
};
UMBRA78_LANES Limits limits_of(const RowLine& line, bool four) {
    const int f = line.fraction_bits, width = line.size;
    return {all(four ? width << f : width), all(line.background), all(width * width - 1),
            all(((width - 1) << f) - 1), all((1 << f) / 2), all((1 << f) - 1), all(1 << f),
            all(1 << 15), count(f), count(line.xy_bits), count(2 * f), line.texels, width};
}

// Of two numbers below a power of 2 the bits together are below it, too.
UMBRA78_LANES Mask inside_map(const Place& p, const Limits& l, Kind k) {
    return k.whole ? less(p.x | p.y, l.side) : in_range(p.x | p.y, l.side);
}
UMBRA78_LANES Word address_of(Word x, Word y, const Limits& l) { return up(y, l.xy) + x; }

// A read takes a texel and the one after it, so the last one of the map is read by itself.
UMBRA78_LANES Word one_by_one(const hw::Depth16* texels, Word address, Mask some) {
    alignas(64) std::int32_t at[lanes];
    store(at, keep(address, some));
    for (int i = 0; i < lanes; ++i) at[i] = texels[at[i]];
    return load(at);
}
UMBRA78_LANES Mask nearest(const Place& p, Mask visible, const Limits& l, Kind k) {
    const Mask some = both(visible, inside_map(p, l, k));
    const Mask before_background = both(some, less(p.code, l.background));
    const Word address = address_of(p.x, p.y, l);
    Word texel;
    if (any_of_both(some, equal(address, l.last_texel))) [[unlikely]]
        texel = one_by_one(l.texels, address, some);
    else
        texel = low_half(pairs(l.texels, address, some));
    return both(before_background, less(texel, p.code));  // a code below 0 is greater than none
}

// Lanes whose four texels are not all on the map.
UMBRA78_LANES Mask at_edge(const RowLine& line, const Place& p, Mask some) {
    alignas(64) std::int32_t x[lanes], y[lanes], code[lanes], dark[lanes];
    const std::int32_t edge = line.size / 2 << line.fraction_bits;
    store(x, p.x);
    store(y, p.y);
    store(code, p.code);
    store(dark, keep(all(-1), some));
    for (int i = 0; i < lanes; ++i)
        if (dark[i] != 0 &&
            !row_pixel_in_shadow(line, x[i] - edge, y[i] - edge, code[i] - line.offset))
            dark[i] = 0;
    return less(load(dark), all(0));
}

// blend = 2^F u + fy (l - u) with u and l along x. Products take signed halves, so every texel is
// 2^15 less, which makes the blend 2^15 2^(2 F) less; so is the code.
UMBRA78_LANES Mask bilinear(const RowLine& line, const Place& p, Mask visible, const Limits& l,
                            Kind k) {
    const Word x = p.x - l.half, y = p.y - l.half;
    const Mask some =
        both(visible, not_negative(x | y | (l.last_corner - x) | (l.last_corner - y)));
    const Word address = address_of(down(x, l.f), down(y, l.f), l);
    const Word fx = x & l.fraction, fy = y & l.fraction;
    const Word weights = up16(fx) + (l.one - fx);
    const Word upper = sum_of_products(signed_halves(pairs(l.texels, address, some)), weights);
    const Word lower =
        sum_of_products(signed_halves(pairs(l.texels + l.width, address, some)), weights);
    const Word blend = up(upper, l.f) + product(lower - upper, fy);
    const Mask dark = both(both(some, less(blend, up(p.code - l.offset, l.twice_f))),
                           in_range(p.code, l.background));
    if (!any(without(visible, some))) return dark;
    const Mask others = without(both(visible, inside_map(p, l, k)), some);
    return any(others) ? either(dark, at_edge(line, p, others)) : dark;
}

// --- noise --------------------------------------------------------------------------------------

// The noise register's recurrence b[n] = b[n-31] ^ b[n-28] holds for whole words, too: over GF(2)
// the power 32 of its polynomial has as many terms, 32 times as far apart; and so on for each power
// of 2. Longer steps read what was written long before.
static void draw_bits(const RowLine& line, int words, std::uint32_t* bits) {
    start_row_noise(line, bits);
    for (int step = 1; 31 * step < words; step *= 2) {
        const int end = 62 * step < words ? 62 * step : words;
        const std::uint32_t *back31 = bits, *back28 = bits + 3 * step;
        std::uint32_t* out = bits + 31 * step;
        UMBRA78_NO_DEPENDENCE
        for (int i = 0; i < end - 31 * step; ++i) out[i] = back31[i] ^ back28[i];
    }
}

// The sums of the bytes of each word, of each half word, and the bytes.
static void add_bytes(const std::uint32_t* bits, int words, std::uint16_t* sum) {
    for (int i = 0; i < words; ++i) {
        const std::uint32_t pairs_sum = (bits[i] & 0x00ff00ff) + (bits[i] >> 8 & 0x00ff00ff);
        sum[i] = static_cast<std::uint16_t>((pairs_sum & 0xffff) + (pairs_sum >> 16));
    }
}
static void add_pairs(const std::uint32_t* bits, int words, std::uint16_t* sum) {
    for (int i = 0; i < words; ++i) {
        const std::uint32_t pairs_sum = (bits[i] & 0x00ff00ff) + (bits[i] >> 8 & 0x00ff00ff);
        sum[2 * i] = static_cast<std::uint16_t>(pairs_sum);
        sum[2 * i + 1] = static_cast<std::uint16_t>(pairs_sum >> 16);
    }
}
static void take_bytes(const std::uint32_t* bits, int words, std::uint16_t* sum) {
    for (int i = 0; i < 4 * words; ++i) sum[i] = bits[i / 4] >> (i % 4 * 8) & 255u;
}
static void add_threes(const std::uint16_t* __restrict sum, int count,
                       std::uint16_t* __restrict threes) {
    for (int i = 0; i < count; ++i)
        threes[i] = static_cast<std::uint16_t>(sum[3 * i] + sum[3 * i + 1] + sum[3 * i + 2]);
}

// Dither words of the pixels from x to end: X in the low half, Y in the high one.
static void draw_noise(const RowLine& line, int x, int end, RowMemory& m) {
    const int k = line.uniforms, words = (end - x) * k / 2, sums = 2 * (end - x);
    std::uint16_t* sum = m.noise_sums;
    draw_bits(line, end * k / 2, m.noise_bits);
    const std::uint32_t* bits = m.noise_bits + x * k / 2;
    if (k == 1) take_bytes(bits, words, sum);
    if (k == 2) add_pairs(bits, words, sum);
    if (k >= 4) add_bytes(bits, words, sum);
    if (k == 12) {
        add_threes(sum, sums, m.noise_threes);
        sum = m.noise_threes;
    }
    std::int16_t* noise = m.noise + 2 * x;
    const std::int32_t amplitude = line.amplitude, mean = 255 * k;
    for (int i = 0; i < sums; ++i) {
        const std::uint32_t scaled =
            static_cast<std::uint32_t>((2 * sum[i] - mean) * amplitude + (1 << 15));
        noise[i] = static_cast<std::int16_t>(scaled >> 16);
    }
}

// --- the line -----------------------------------------------------------------------------------

UMBRA78_LANES bool all_background(const hw::Depth16* depth, const CodeRule& rule) {
    Codes c[parts];
    return !read_codes(depth, rule, c);
}

// Inlined with a constant kind, for each of which the loop is compiled by itself.
UMBRA78_LANES RowCounts run_line(const RowLine& line, RowMemory& m, Kind kind) {
    const hw::Depth16* depth = line.depth;
    std::uint8_t* mask = line.mask;
    const CodeRule rule = code_rule(line);
    int x = 0, end = line.width;
    if (kind.dithered) {
        while (x < end && all_background(depth + x, rule)) x += block;
        while (end > x && all_background(depth + end - block, rule)) end -= block;
        if (x < end) draw_noise(line, x, end, m);
        for (int i = 0; i < x; ++i) mask[i] = 0;
        for (int i = end; i < line.width; ++i) mask[i] = 0;
    }
    const std::int32_t edge = line.size / 2 << line.fraction_bits;
    const Share shares[3] = {share_of(line, m, 0, edge), share_of(line, m, 1, edge),
                             share_of(line, m, 2, line.offset)};
    const Limits limits = limits_of(line, kind.four);
    Counter visible{}, shadowed{};
    for (; x < end; x += block) {
        Codes c[parts];
        Mask dark[parts] = {};
        if (read_codes(depth + x, rule, c)) {
#pragma GCC unroll 4
            for (int i = 0; i < parts; ++i) {
                const Mask drawn = c[i].visible;
                const Place p = place_of(shares, c[i].z, m, x + i * lanes, kind);
                dark[i] = kind.four ? bilinear(line, p, drawn, limits, kind)
                                    : nearest(p, drawn, limits, kind);
                add(visible, drawn);
                add(shadowed, dark[i]);
            }
        }
        store_masks(mask + x, dark);
    }
    return {total(visible), total(shadowed)};
}

UMBRA78_LANES RowCounts run_lookup(const RowLine& line, RowMemory& m, bool four) {
    if (line.uniforms > 0)
        return line.whole ? run_line(line, m, {true, four, true})
                          : run_line(line, m, {false, four, true});
    return line.whole ? run_line(line, m, {true, four, false})
                      : run_line(line, m, {false, four, false});
}
static RowCounts run(const RowLine& line, RowMemory& m) {
    return line.bilinear ? run_lookup(line, m, true) : run_lookup(line, m, false);
}

#undef UMBRA78_NO_DEPENDENCE
#endif
