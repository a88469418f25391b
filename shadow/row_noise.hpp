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

// The sums of the bytes of each word, of each half word, and the bytes.
static void add_fours(const std::uint32_t* bits, int words, std::uint16_t* sum) {
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

// (2 sum - mean) amplitude + 2^15, less its low half, is scale sum + offset.
struct NoiseScale {
    std::int32_t scale, offset;
};
static NoiseScale noise_scale(const RowLine& line) {
    return {2 * line.amplitude, (1 << 15) - 255 * line.uniforms * line.amplitude};
}

// Dither words from their sums.
static void scale_sums(const std::uint16_t* __restrict sum, int count, const NoiseScale& s,
                       std::int16_t* __restrict noise) {
    for (int i = 0; i < count; ++i) {
        const std::uint32_t scaled = sum[i] * static_cast<std::uint32_t>(s.scale) +
                                     static_cast<std::uint32_t>(s.offset);
        noise[i] = static_cast<std::int16_t>(scaled >> 16);
    }
}
// Those of four bytes from the words that hold them.
UMBRA78_LANES void scale_words(const std::uint32_t* bits, int count, const NoiseScale& s,
                               std::int16_t* noise) {
    const Word scale = all(s.scale), offset = all(s.offset);
    for (int i = 0; i < count; i += lanes) {
        const Word sum = add_bytes(Word{}, load(bits + i));
        store_high_halves(noise + i, product(sum, scale) + offset);
    }
}

// Dither words of the pixels from x to end, in whole blocks: X in the low half, Y in the high one.
static void draw_noise(const RowLine& line, int x, int end, RowMemory& m) {
    const int k = line.uniforms, words = (end - x) * k / 2, sums = 2 * (end - x);
    const NoiseScale scale = noise_scale(line);
    std::int16_t* noise = m.noise + 2 * x;
    draw_bits(line, end * k / 2, m.noise_bits);
    const std::uint32_t* bits = m.noise_bits + x * k / 2;
    if (k == 4) return scale_words(bits, sums, scale, noise);
    std::uint16_t* sum = m.noise_sums;
    if (k == 1) take_bytes(bits, words, sum);
    if (k == 2) add_pairs(bits, words, sum);
    if (k == 12) {
        add_fours(bits, words, sum);
        add_threes(sum, sums, m.noise_threes);
        sum = m.noise_threes;
    }
    scale_sums(sum, sums, scale, noise);
}

#endif
