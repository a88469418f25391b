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
    bool four = false, window = false, percentage = false;  // none: nearest
    bool whole = false, dithered = false;
    constexpr bool fine() const { return four || window; }  // places keep their fractions
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
                             k.fine() ? s.shift : s.shift_to_texel);
    }
    const Word result = split_result(s, z, x);
    const Word place = k.dithered ? result + dither : result;
    return k.fine() ? place : down(place, s.fraction_bits);
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

// Texels are read four at a time, in two words of 64-bit lanes. The last four of a window's line
// end with it, and may begin before it: what is before it or is counted already has the weight 0.
constexpr int quad = 4;
UMBRA78_LANES Word weights_of_last(int side) {
    alignas(64) std::uint32_t weights[lanes];
    const std::uint64_t four = 0x0001000100010001u << 16 * ((4 * quad - side) % quad);
    for (int i = 0; i < lanes; ++i)
        weights[i] = static_cast<std::uint32_t>(i % 2 == 0 ? four : four >> 32);
    return load(weights);
}

// What the lanes compare with.
struct Limits {
    Word side;         // of the map, a power of 2, in the unit of the places
    Word background;   // as a code
    Word last_texel;   // its address
    Word last_corner;  // the last X or Y, half a texel back, that has four texels
    Word half, fraction, one, offset;  // half a texel
    Word before, last_first;  // from a window's first texel to its middle; the last first texel
    Word least_address, last_weights;
    Count f, xy, twice_f;
    const hw::Depth16* texels;
    int width;
};
UMBRA78_LANES Limits limits_of(const RowLine& line, bool fine) {
    const int f = line.fraction_bits, width = line.size, side = line.window_side;
    Limits l{};
    l.side = all(fine ? width << f : width);
    l.background = all(line.background);
    l.last_texel = all(width * width - 1);
    l.last_corner = all(((width - 1) << f) - 1);
    l.half = all((1 << f) / 2);
    l.fraction = all((1 << f) - 1);
    l.one = all(1 << f);
    l.offset = all(1 << 15);
    l.before = all((side - 1) * (1 << f) / 2);
    l.last_first = all(width - side);
    l.least_address = all(quad - side);
    l.last_weights = weights_of_last(side);
    l.f = count(f);
    l.xy = count(line.xy_bits);
    l.twice_f = count(2 * f);
    l.texels = line.texels;
    l.width = width;
    return l;
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

// The darkness of lanes some of whose texels are not on the map.
UMBRA78_APART Word at_edge(const RowLine& line, const Place& p, Mask some) {
    alignas(64) std::int32_t x[lanes], y[lanes], code[lanes], dark[lanes];
    const std::int32_t edge = line.size / 2 << line.fraction_bits;
    store(x, p.x);
    store(y, p.y);
    store(code, p.code);
    store(dark, keep(all(-1), some));
    for (int i = 0; i < lanes; ++i)
        if (dark[i] != 0)
            dark[i] = row_pixel_darkness(line, x[i] - edge, y[i] - edge, code[i] - line.offset);
    return load(dark);
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
    if (!any(without(visible, some))) [[likely]] return dark;
    const Mask others = without(both(visible, inside_map(p, l, k)), some);
    if (any(others)) [[unlikely]]
        return either(dark, less(all(0), at_edge(line, p, others)));
    return dark;
}

// --- a window of texels -------------------------------------------------------------------------

// The number of texels that are nearer than the point, or the sum of all, less 2^15 each.
UMBRA78_LANES Word over_taps(const RowLine& line, const Limits& l, Word address, Word code,
                             Mask some, bool percentage) {
    const int side = line.window_side;
    const Word ones = all(0x10001);
    Word codes[2], sum[2] = {};
    widen(signed_halves(up16(code) + low_half(code)), codes);
    const auto add_four = [&](int from, Word weights) UMBRA78_INLINE {
        Word texels[2];
        quads(l.texels, address + all(from), some, texels);
        for (int k = 0; k < 2; ++k) {
            const Word four = signed_halves(texels[k]);
            sum[k] = percentage ? add_where_greater(sum[k], codes[k], four, weights)
                                : add_products(sum[k], four, weights);
        }
    };
    for (int j = 0; j < side; ++j) {
        const int from = j * line.size;
        for (int i = 0; i + quad < side; i += quad) add_four(from + i, ones);
        add_four(from + side - quad, l.last_weights);
    }
    for (int k = 0; percentage && k < 2; ++k) sum[k] = sum_of_products(sum[k], ones);
    return narrow(sum);
}

UMBRA78_LANES Word share_of_dark(const RowLine& line, Word dark) {
    return down_unsigned(product(dark, all(line.share_scale)) + all(line.share_offset), count(20));
}

UMBRA78_LANES Word window_darkness(const RowLine& line, const Place& p, Mask visible,
                                   const Limits& l, Kind k) {
    const Word x = down(p.x - l.before, l.f), y = down(p.y - l.before, l.f);
    const Mask inside =
        both(both(visible, inside_map(p, l, k)), in_range(p.code, l.background));
    const Word address = address_of(x, y, l);
    const Mask some = both(inside, not_negative(x | y | (l.last_first - x) | (l.last_first - y) |
                                                (address - l.least_address)));
    const int taps = line.window_side * line.window_side;
    const Word found = over_taps(line, l, address, p.code, some, k.percentage);
    const Word dark =
        k.percentage
            ? keep(share_of_dark(line, found), some)
            : keep(all(255), both(some, less(found, product(p.code - l.offset, all(taps)))));
    const Mask others = without(inside, some);
    if (any(others)) [[unlikely]]
        return dark | at_edge(line, p, others);
    return dark;
}

#include "shadow/row_noise.hpp"

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
    const Limits limits = limits_of(line, kind.fine());
    Counter visible{}, shadowed{};
    for (; x < end; x += block) {
        Codes c[parts];
        Mask dark[parts] = {};
        Word darkness[parts] = {};
        if (read_codes(depth + x, rule, c)) {
#pragma GCC unroll 4
            for (int i = 0; i < parts; ++i) {
                const Mask drawn = c[i].visible;
                const Place p = place_of(shares, c[i].z, m, x + i * lanes, kind);
                if (kind.window) {
                    darkness[i] = window_darkness(line, p, drawn, limits, kind);
                    dark[i] = less(all(0), darkness[i]);
                } else {
                    dark[i] = kind.four ? bilinear(line, p, drawn, limits, kind)
                                        : nearest(p, drawn, limits, kind);
                }
                add(visible, drawn);
                add(shadowed, dark[i]);
            }
        }
        if (kind.window) store_bytes(mask + x, darkness);
        else store_masks(mask + x, dark);
    }
    return {total(visible), total(shadowed)};
}

UMBRA78_LANES RowCounts run_lookup(const RowLine& line, RowMemory& m, Kind k) {
    if (line.uniforms > 0)
        return line.whole ? run_line(line, m, {k.four, k.window, k.percentage, true, true})
                          : run_line(line, m, {k.four, k.window, k.percentage, false, true});
    return line.whole ? run_line(line, m, {k.four, k.window, k.percentage, true, false})
                      : run_line(line, m, {k.four, k.window, k.percentage, false, false});
}
// Each lookup's loops by themselves, which takes the compiler less time and fewer registers.
UMBRA78_APART RowCounts run_nearest(const RowLine& line, RowMemory& m) {
    return run_lookup(line, m, {});
}
UMBRA78_APART RowCounts run_bilinear(const RowLine& line, RowMemory& m) {
    return run_lookup(line, m, {.four = true});
}
UMBRA78_APART RowCounts run_percentage(const RowLine& line, RowMemory& m) {
    return run_lookup(line, m, {.window = true, .percentage = true});
}
UMBRA78_APART RowCounts run_filtered_depth(const RowLine& line, RowMemory& m) {
    return run_lookup(line, m, {.window = true});
}
static RowCounts run(const RowLine& line, RowMemory& m) {
    if (line.window_side > 0)
        return line.percentage ? run_percentage(line, m) : run_filtered_depth(line, m);
    return line.bilinear ? run_bilinear(line, m) : run_nearest(line, m);
}

static void find_drawn(const hw::Depth16* codes, std::size_t words, hw::Depth16 none,
                       std::uint64_t* drawn) {
    for (std::size_t w = 0; w < words; ++w) drawn[w] = drawn_of_64(codes + 64 * w, none);
}

#undef UMBRA78_NO_DEPENDENCE
#endif
