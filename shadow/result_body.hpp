// A scan line's transform in wide lanes, 16 pixels after 16: a text for fixed/lane_sets.hpp, of
// shadow/result_forms.cpp; alone it is empty.
#ifdef UMBRA78_LANES_TEXT

constexpr int result_lanes = 16;
typedef std::int32_t Lane32[result_lanes];
typedef std::uint32_t Lane32u[result_lanes];
typedef std::int64_t Lane64[result_lanes];

static inline std::int64_t times(std::int32_t a, std::int32_t b) { return std::int64_t{a} * b; }
static inline std::uint64_t times_unsigned(std::uint64_t a, std::uint64_t b) {  // of 32 bits
    return std::uint64_t{static_cast<std::uint32_t>(a)} * static_cast<std::uint32_t>(b);
}
static inline std::uint64_t bits_of(std::int64_t v) { return static_cast<std::uint64_t>(v); }
static inline std::int32_t floor_half(std::int32_t v) { return fixed::floor_shift(v, 1); }
// The floor, for any v of at least -2^62.
static inline std::int64_t down(std::int64_t v, int n) {
    const std::uint64_t above = std::uint64_t{1} << 62;
    return static_cast<std::int64_t>((bits_of(v) + above) >> n) -
           static_cast<std::int64_t>(above >> n);
}

static inline void find_sums(const ResultRow& row, const std::int64_t* column, const Lane32& z,
                             Lane64& __restrict sum) {
    for (int k = 0; k < result_lanes; ++k)
        sum[k] = column[k] + row.line + times(row.z_coefficient, z[k]);
}

static inline void shift_sums(const ResultRow& row, const Lane64& sum,
                              std::int32_t* __restrict out) {
    Lane64 result;
    for (int k = 0; k < result_lanes; ++k) {
        const std::int64_t v = down(sum[k], row.shift);
        const std::int64_t low = v < no_result ? v : no_result;
        result[k] = low > -no_result ? low : -no_result;
    }
    for (int k = 0; k < result_lanes; ++k) out[k] = static_cast<std::int32_t>(result[k]);
}

// sum_w = 2^cut_w n 2^-up, less what the cut loses, with 2^31 <= n < 2^32; y is about 2^62 / n.
// A product of 31 bits and y is wrong by less than `error`.
struct Reciprocals {
    Lane32 up, y, positive;
    Lane32 coarse;  // where the bits of sum_w that are left are too few
    std::uint64_t error[result_lanes];
};

// Shifts n up if its highest bits are 0, and returns by how much.
static inline std::uint32_t lift(std::uint32_t& n, int step) {
    const std::uint32_t up = n < 1u << (32 - step) ? static_cast<std::uint32_t>(step) : 0;
    n = n << up;
    return up;
}

static inline void find_reciprocals(const ResultLine& line, const Lane64& sum_w,
                                    Reciprocals& __restrict r) {
    const std::uint32_t least = line.cut_w > 0 ? 1u << 20 : 1;
    Lane32u normal, near;
    Lane32 high;
    for (int k = 0; k < result_lanes; ++k)
        normal[k] = static_cast<std::uint32_t>(bits_of(sum_w[k]) >> line.cut_w);
    for (int k = 0; k < result_lanes; ++k)
        high[k] = static_cast<std::int32_t>(bits_of(sum_w[k]) >> 32);
    for (int k = 0; k < result_lanes; ++k) {
        std::uint32_t n = normal[k];
        r.positive[k] = high[k] < 0 ? 0 : 1;
        r.coarse[k] = n < least ? r.positive[k] : 0;
        n |= n == 0 ? 1 : 0;
        std::uint32_t up = lift(n, 16);
        up += lift(n, 8);
        up += lift(n, 4);
        up += lift(n, 2);
        up += lift(n, 1);
        const std::uint32_t w = n >> 16;                    // 1 / w from a line within 1/17 of
        const std::uint32_t y0 = 92521 - (w * 61681 >> 16);  // it, Q.15, and 2 steps
        const std::uint32_t y1 = y0 * (65536 - (w * y0 >> 16)) >> 15;
        const std::uint32_t y = y1 * (65536 - (w * y1 >> 16)) >> 15;
        normal[k] = n;
        r.up[k] = static_cast<std::int32_t>(up);
        near[k] = y;
    }
    for (int k = 0; k < result_lanes; ++k) {  // one more: 2^-27.8
        const std::uint64_t y = std::uint64_t{near[k]} << 15;
        const std::uint64_t two_less = (std::uint64_t{1} << 63) - times_unsigned(normal[k], y);
        const std::uint64_t better = times_unsigned(y, two_less >> 31) >> 31;
        r.y[k] = static_cast<std::int32_t>(better < INT32_MAX ? better : INT32_MAX);
    }
    const std::uint64_t cut = line.cut_w > 0 ? std::uint64_t{1} << 32 : 0;
    for (int k = 0; k < result_lanes; ++k) {
        const auto up = static_cast<std::uint32_t>(r.up[k]);
        r.error[k] = (std::uint64_t{1} << 35) + (cut << up);
    }
}

// Quotients of a row's sums, or no_result, by a sum's highest 31 bits and the reciprocal. Where the
// error could round to another quotient, and where the highest bits are too few, `unsure` says so.
static inline void divide_sums(const ResultLine& line, const ResultRow& row, const Lane64& sum,
                               const Reciprocals& r, std::int32_t* __restrict out,
                               Lane32& __restrict unsure) {
    constexpr std::uint64_t above = std::uint64_t{1} << 62;
    constexpr std::int32_t least = 36, most = 62;  // so that twice a quotient has 1 to 27 bits
    const std::int32_t end = 1 << (row.bits - 1), half = line.half_up ? 1 : 0;
    const std::int32_t down_to = 62 - row.cut - row.shift + line.cut_w;
    Lane32 top;
    Lane32u low, high, n;
    for (int k = 0; k < result_lanes; ++k)
        top[k] = static_cast<std::int32_t>(bits_of(sum[k]) >> row.cut);
    for (int k = 0; k < result_lanes; ++k) {
        const std::int32_t wanted = down_to - r.up[k];
        const std::int32_t at_least = wanted < least ? least : wanted;
        const std::int32_t shift = at_least < most ? at_least : most;
        n[k] = static_cast<std::uint32_t>(shift - 1);
        unsure[k] = shift != wanted ? r.positive[k] : r.coarse[k];
    }
    for (int k = 0; k < result_lanes; ++k)
        low[k] = static_cast<std::uint32_t>(
            (bits_of(times(top[k], r.y[k])) + above - r.error[k]) >> n[k]);
    for (int k = 0; k < result_lanes; ++k)
        high[k] = static_cast<std::uint32_t>(
            (bits_of(times(top[k], r.y[k])) + above + r.error[k]) >> n[k]);
    for (int k = 0; k < result_lanes; ++k) {
        const std::uint32_t from = 1u << (62 - n[k]);  // what `above` has become
        const std::int32_t q = floor_half(static_cast<std::int32_t>(low[k] - from) + half);
        const std::int32_t q_high = floor_half(static_cast<std::int32_t>(high[k] - from) + half);
        unsure[k] |= q == q_high ? 0 : r.positive[k];
        std::int32_t v = q < end ? q : no_result;
        v = q < -end ? no_result : v;
        out[k] = r.positive[k] != 0 ? v : no_result;
    }
}

static inline bool find_words(const ResultLine& line, const hw::Depth16* depth,
                              Lane32& __restrict z) {
    std::uint32_t any = 0;
    for (int k = 0; k < result_lanes; ++k)
        any |= static_cast<std::uint32_t>(depth[k]) ^ static_cast<std::uint32_t>(line.background);
    for (int k = 0; k < result_lanes; ++k)
        z[k] = (depth[k] - line.offset) * (1 << line.z_up);
    return any != 0;
}

// X, Y and Z of the 16 pixels from x on, divided by W.
static inline void divide_16(const ResultLine& line, const Lane32& z, int x, RowMemory& m) {
    Lane64 sum, sum_w;
    Lane32 unsure;
    Reciprocals r;
    find_sums(line.row[3], m.column_wide[3] + x, z, sum_w);
    find_reciprocals(line, sum_w, r);
    for (int row = 0; row < 3; ++row) {
        std::int32_t* out = m.column_high[row] + x;
        find_sums(line.row[row], m.column_wide[row] + x, z, sum);
        divide_sums(line, line.row[row], sum, r, out, unsure);
        std::int32_t any = 0;
        for (int k = 0; k < result_lanes; ++k) any |= unsure[k];
        for (int k = 0; any != 0 && k < result_lanes; ++k)
            if (unsure[k] != 0) out[k] = quotient_of(line, line.row[row], sum[k], sum_w[k]);
    }
}

static void results_form(const ResultLine& line, const hw::Depth16* depth, RowMemory& m) {
    for (int x = 0; x < line.width; x += result_lanes) {
        Lane32 z;
        Lane64 sum;
        if (!find_words(line, depth + x, z)) continue;
        if (line.divides) {
            divide_16(line, z, x, m);
            continue;
        }
        for (int row = 0; row < 3; ++row) {
            find_sums(line.row[row], m.column_wide[row] + x, z, sum);
            shift_sums(line.row[row], sum, m.column_high[row] + x);
        }
    }
}

#endif
