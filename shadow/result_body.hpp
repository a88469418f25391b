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
struct Reciprocals {
    Lane64 w, positive;  // 1 where it is not positive; whether it is
    Lane32 up, coarse, y;
};

// Shifts n up if its highest bits are 0, and returns by how much.
static inline std::uint32_t lift(std::uint32_t& n, int step) {
    const std::uint32_t up = n < 1u << (32 - step) ? static_cast<std::uint32_t>(step) : 0;
    n <<= up;
    return up;
}

static inline void find_reciprocals(const ResultLine& line, const Lane64& sum_w,
                                    Reciprocals& __restrict r) {
    const std::uint32_t least = line.cut_w > 0 ? 1u << 20 : 1;
    Lane32u normal, near;
    for (int k = 0; k < result_lanes; ++k) {
        const bool positive = sum_w[k] > 0;
        r.w[k] = positive ? sum_w[k] : 1;
        r.positive[k] = positive ? 1 : 0;
        normal[k] = static_cast<std::uint32_t>(bits_of(r.w[k]) >> line.cut_w);
    }
    for (int k = 0; k < result_lanes; ++k) {
        std::uint32_t n = normal[k];
        r.coarse[k] = n < least ? 1 : 0;
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
    for (int k = 0; k < result_lanes; ++k) {  // one more: 2^-28
        const std::uint64_t y = std::uint64_t{near[k]} << 15;
        const std::uint64_t two_less = (std::uint64_t{1} << 63) - times_unsigned(normal[k], y);
        const std::uint64_t better = times_unsigned(y, two_less >> 31) >> 31;
        r.y[k] = static_cast<std::int32_t>(better < INT32_MAX ? better : INT32_MAX);
    }
}

// Estimates of a row's quotients, within one where `coarse` does not say otherwise.
static inline void estimate(const ResultLine& line, const ResultRow& row, const Lane64& sum,
                            const Reciprocals& r, Lane64& __restrict q,
                            Lane32& __restrict coarse) {
    Lane32 top;
    Lane32u n;
    const std::int32_t least = row.cut > 0 ? 32 : 0;
    const std::int32_t shift = 62 - row.cut - row.shift + line.cut_w;
    for (int k = 0; k < result_lanes; ++k) {
        const std::int32_t wanted = shift - r.up[k], at_least = wanted < 0 ? 0 : wanted;
        n[k] = static_cast<std::uint32_t>(at_least < 63 ? at_least : 63);
        coarse[k] = wanted < least ? 1 : r.coarse[k];
    }
    for (int k = 0; k < result_lanes; ++k)
        top[k] = static_cast<std::int32_t>(down(sum[k], row.cut));
    for (int k = 0; k < result_lanes; ++k) {  // as in down(), in one shift
        const std::uint64_t above = bits_of(times(top[k], r.y[k])) + (std::uint64_t{1} << 62);
        q[k] = static_cast<std::int64_t>(above >> n[k]);
    }
    for (int k = 0; k < result_lanes; ++k) {
        const std::uint64_t one = (r.y[k] > 0 ? std::uint64_t{1} : 0) << 62;
        q[k] -= static_cast<std::int64_t>(one >> n[k]);
    }
}

// Quotients of a row's sums, or no_result.
static inline void divide_sums(const ResultLine& line, const ResultRow& row, const Lane64& sum,
                               const Reciprocals& r, std::int32_t* __restrict out,
                               Lane32& __restrict coarse) {
    const std::int64_t end = std::int64_t{1} << (row.bits - 1);
    const int up = row.shift > 0 ? row.shift : 0, up_w = row.shift < 0 ? -row.shift : 0;
    const std::uint64_t half = line.half_up ? ~std::uint64_t{0} : 0;
    Lane64 q;
    estimate(line, row, sum, r, q, coarse);
    for (int k = 0; k < result_lanes; ++k) {
        const std::uint64_t w = bits_of(r.w[k]) << up_w;
        const auto rest = static_cast<std::int64_t>(
            2 * ((bits_of(sum[k]) << up) - bits_of(q[k]) * w) + (w & half));
        const std::int64_t estimated = q[k];
        const std::int64_t more = rest >= static_cast<std::int64_t>(2 * w) ? 1 : 0;
        const std::int64_t exact = estimated + more - (rest < 0 ? 1 : 0);
        // A far estimate's rest is none; what is near is checked exactly.
        std::int64_t v = exact < end ? exact : no_result;
        v = exact < -end ? no_result : v;
        v = estimated > 2 * end ? no_result : v;
        v = estimated < -2 * end ? no_result : v;
        q[k] = r.positive[k] != 0 ? v : no_result;
    }
    for (int k = 0; k < result_lanes; ++k) out[k] = static_cast<std::int32_t>(q[k]);
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

static void results_form(const ResultLine& line, const hw::Depth16* depth, RowMemory& m) {
    for (int x = 0; x < line.width; x += result_lanes) {
        Lane32 z, coarse;
        Lane64 sum, sum_w = {};
        Reciprocals r = {};
        if (!find_words(line, depth + x, z)) continue;
        if (line.divides) {
            find_sums(line.row[3], m.column_wide[3] + x, z, sum_w);
            find_reciprocals(line, sum_w, r);
        }
        for (int row = 0; row < 3; ++row) {
            std::int32_t* out = m.column_high[row] + x;
            find_sums(line.row[row], m.column_wide[row] + x, z, sum);
            if (!line.divides) {
                shift_sums(line.row[row], sum, out);
                continue;
            }
            divide_sums(line, line.row[row], sum, r, out, coarse);
            std::int32_t any = 0;
            for (int k = 0; k < result_lanes; ++k) any |= coarse[k];
            for (int k = 0; any != 0 && k < result_lanes; ++k)
                if (coarse[k] != 0) out[k] = quotient_of(line, line.row[row], sum[k], sum_w[k]);
        }
    }
}

#endif
