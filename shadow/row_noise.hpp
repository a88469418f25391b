// A scan line's dither words in lanes: a part of shadow/row_body.hpp; alone it is empty.
#ifdef UMBRA78_LANES

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

// The first block of lanes may reach into the second, whose place is whole cache lines, and the
// last begins before the one before it ends: some words are written twice.
UMBRA78_LANES void draw_words(const std::uint32_t* back31, const std::uint32_t* back28, int count,
                              std::uint32_t* out) {
    if (count < lanes) {
        for (int i = 0; i < count; ++i) out[i] = back31[i] ^ back28[i];
        return;
    }
    const auto draw = [&](int at) { store(out + at, load(back31 + at) ^ load(back28 + at)); };
    draw(0);
    const auto place = reinterpret_cast<std::uintptr_t>(out) / sizeof(std::uint32_t);
    int i = lanes - static_cast<int>(place % static_cast<std::uintptr_t>(lanes));
    for (; i <= count - lanes; i += lanes) draw(i);
    draw(count - lanes);
}

// The same of words in three planes, by their numbers modulo 3: the words of a sum of twelve bytes
// then have one place. 31 and 28 steps back lie in one plane, for 31 - 28 is 3, and not in the one
// that is written; a step ends before it would read what it writes.
static void draw_planes(const RowLine& line, int plane, std::uint32_t* bits) {
    const int words = 3 * plane;
    std::uint32_t first[32];
    start_row_noise(line, first);
    for (int n = 0; n < 31; ++n) bits[n % 3 * plane + n / 3] = first[n];
    for (int known = 31, end, step = 1; known < words; known = end) {
        while (62 * step <= known) step *= 2;
        end = known + 28 * step < words ? known + 28 * step : words;
        for (int r = 0; r < 3; ++r) {
            const int from = (known - r + 2) / 3, to = (end - r + 2) / 3;
            const int back = (r + 2 * step) % 3;  // the plane of r - step
            const std::uint32_t* back31 = bits + back * plane + from - (31 * step + back - r) / 3;
            draw_words(back31, back31 + step, to - from, bits + r * plane + from);
        }
    }
}

// The planes of the line after the one whose planes are there: a word follows from words that lie
// 31 and 28 times `step` back, and all of a line lies 48 times back. A line has 6 words a pixel, so
// `step` is an eighth of its pixels, and the new words take the places of the old ones. What a
// quarter reads it does not write.
static void next_planes(int step, std::uint32_t* bits) {
    const int limits[] = {0, 17 * step, 28 * step, 31 * step, 48 * step};
    for (int part = 0; part < 4; ++part) {
        const int back31 = part < 3 ? 17 * step : -31 * step;  // of the line before, or of this
        const int back28 = part < 2 ? 20 * step : -28 * step;
        for (int r = 0; r < 3; ++r) {
            const int from = (limits[part] - r + 2) / 3, to = (limits[part + 1] - r + 2) / 3;
            const int back = (r + 2 * step) % 3;
            const std::uint32_t* plane = bits + back * 16 * step;
            draw_words(plane + from + (back31 + r - back) / 3,
                       plane + from + (back28 + r - back) / 3, to - from,
                       bits + r * 16 * step + from);
        }
    }
}

// Words of twelve bytes a sum: of the whole line where the next one may follow from it.
static int draw_twelve(const RowLine& line, int end, RowMemory& m) {
    const bool whole = line.width == line.size;
    const int plane = 2 * (whole ? line.size : end);
    if (whole && *line.noise_line == line.y - 1) {
        next_planes(line.size / 8, m.noise_bits);
    } else {
        draw_planes(line, plane, m.noise_bits);
    }
    *line.noise_line = whole ? line.y : RowLine::no_line;
    return plane;
}

// The sums of the bytes of each half word, and the bytes.
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

// (2 sum - mean) amplitude + 2^15, less its low half, is scale sum + offset.
struct NoiseScale {
    std::int32_t scale, offset;
};
static NoiseScale noise_scale(const RowLine& line) {
    return {2 * line.amplitude, (1 << 15) - 255 * line.uniforms * line.amplitude};
}

// Dither words of 1 or 2 bytes from their sums.
static void scale_sums(const std::uint16_t* __restrict sum, int count, const NoiseScale& s,
                       std::int16_t* __restrict noise) {
    for (int i = 0; i < count; ++i) {
        const std::uint32_t scaled = sum[i] * static_cast<std::uint32_t>(s.scale) +
                                     static_cast<std::uint32_t>(s.offset);
        noise[i] = static_cast<std::int16_t>(scaled >> 16);
    }
}
// And of 4 or 12 from the words that hold them, of one plane or of three.
UMBRA78_LANES void scale_words(const std::uint32_t* bits, int planes, int plane, int count,
                               const NoiseScale& s, std::int16_t* noise) {
    const Word scale = all(s.scale), offset = all(s.offset);
    for (int i = 0; i < count; i += lanes) {
        Word sum = add_bytes(Word{}, load(bits + i));
        for (int r = 1; r < planes; ++r)
            sum = add_bytes(sum, load(bits + r * plane + i));
        store_high_halves(noise + i, product(sum, scale) + offset);
    }
}

// Dither words of the pixels from x to end: X in the low half, Y in the high one.
static void draw_noise(const RowLine& line, int x, int end, RowMemory& m) {
    const int k = line.uniforms, words = (end - x) * k / 2, sums = 2 * (end - x);
    const NoiseScale scale = noise_scale(line);
    std::int16_t* noise = m.noise + 2 * x;
    if (k == 12) {
        const int plane = draw_twelve(line, end, m);
        scale_words(m.noise_bits + 2 * x, 3, plane, sums, scale, noise);
        return;
    }
    draw_bits(line, end * k / 2, m.noise_bits);
    const std::uint32_t* bits = m.noise_bits + x * k / 2;
    if (k == 4) {
        scale_words(bits, 1, 0, sums, scale, noise);
        return;
    }
    k == 1 ? take_bytes(bits, words, m.noise_sums) : add_pairs(bits, words, m.noise_sums);
    scale_sums(m.noise_sums, sums, scale, noise);
}

#endif
