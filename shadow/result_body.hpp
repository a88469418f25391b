// A scan line's transform in wide lanes, 16 pixels after 16: a text for fixed/lane_sets.hpp, of
// shadow/result_forms.cpp; alone it is empty.
#ifdef UMBRA78_LANES_TEXT

constexpr int result_lanes = 16;
typedef std::int32_t Lane32[result_lanes];
typedef std::uint32_t Lane32u[result_lanes];
typedef std::int64_t Lane64[result_lanes];

static inline std::int64_t times(std::int32_t a, std::int32_t b) { return std::int64_t{a} * b; }
static inline std::uint64_t bits_of(std::int64_t v) { return static_cast<std::uint64_t>(v); }
// The floor, for any v of at least -2^62.
static inline std::int64_t down(std::int64_t v, int n) {
    const std::uint64_t above = std::uint64_t{1} << 62;
    return static_cast<std::int64_t>((bits_of(v) + above) >> n) -
           static_cast<std::int64_t>(above >> n);
}

static inline void find_sums(const ResultRow& row, const std::int64_t* column,
                             const std::int32_t* z, Lane64& __restrict sum) {
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

// Shifts n up if its highest bits are 0, and returns by how much.
static inline std::uint32_t lift(std::uint32_t& n, int step) {
    const std::uint32_t up = n < 1u << (32 - step) ? static_cast<std::uint32_t>(step) : 0;
    n = n << up;
    return up;
}

// y of n. All 2^31 of them are within 15 of 2^62 / n (tests/proofs/forms.cpp).
static inline std::int32_t reciprocal_of(std::uint32_t n) {
    const std::uint32_t w = n >> 16;                    // 1 / w from a line within 1/17 of it,
    const std::uint32_t y0 = 92521 - (w * 61681 >> 16);  // Q.15, and 2 steps
    const std::uint32_t y1 = y0 * (65536 - (w * y0 >> 16)) >> 15;
    const std::uint32_t y2 = y1 * (65536 - (w * y1 >> 16)) >> 15;
    // What is left of 2^44 - (n / 8) y2 has 31 bits; half a y2 for those that n loses.
    const std::uint32_t left = 0u - (n >> 3) * y2 - (y2 >> 1);
    const std::int32_t part =
        fixed::floor_shift(static_cast<std::int32_t>(left + (1u << 15)), 16);
    const std::int32_t more =
        fixed::floor_shift(static_cast<std::int32_t>(y2) * part + (1 << 12), 13);
    const std::uint32_t y = (y2 << 15) + static_cast<std::uint32_t>(more);
    return static_cast<std::int32_t>(y < INT32_MAX ? y : INT32_MAX);
}

// sum_w = 2^cut_w n 2^-up, less what the cut loses, with 2^31 <= n < 2^32; y is the reciprocal of
// n, and 0 where sum_w is not positive. Where the bits of sum_w that are left are too few, `up` is
// as large as no shift is.
constexpr std::int32_t coarse = 1024;
static inline void find_reciprocals(const ResultLine& line, const Lane64& sum_w,
                                    std::int32_t* __restrict y, std::int32_t* __restrict up) {
    const std::uint32_t least = line.cut_w > 0 ? 1u << 20 : 1;
    Lane32u normal;
    Lane32 high;
    for (int k = 0; k < result_lanes; ++k)
        normal[k] = static_cast<std::uint32_t>(bits_of(sum_w[k]) >> line.cut_w);
    for (int k = 0; k < result_lanes; ++k)
        high[k] = static_cast<std::int32_t>(bits_of(sum_w[k]) >> 32);
    for (int k = 0; k < result_lanes; ++k) {
        std::uint32_t n = normal[k];
        const std::uint32_t few = n < least ? coarse : 0;
        n |= n == 0 ? 1 : 0;
        std::uint32_t steps = lift(n, 16);
        steps += lift(n, 8);
        steps += lift(n, 4);
        steps += lift(n, 2);
        steps += lift(n, 1);
        up[k] = static_cast<std::int32_t>(steps + few);
        y[k] = high[k] < 0 ? 0 : reciprocal_of(n);
    }
}

// Quotients of a row's sums, or no_result, by a sum's highest 31 bits and the reciprocal. Where the
// error could round to another quotient, and where the highest bits are too few, `unsure` says so.
static inline void divide_sums(const ResultLine& line, const ResultRow& row, const Lane64& sum,
                               const std::int32_t* y, const std::int32_t* up,
                               std::int32_t* __restrict out, Lane32& __restrict unsure) {
    constexpr std::int32_t least = 4, most = 30;  // so that a quotient has 0 to 26 bits
    const std::uint32_t end = 1u << (row.bits - 1), cut = line.cut_w > 0 ? 1 : 0;
    const std::int32_t half = line.half_up ? 1 : 0;
    const std::int32_t down_to = 30 - row.cut - row.shift + line.cut_w;
    Lane32 top, high;
    for (int k = 0; k < result_lanes; ++k)
        top[k] = static_cast<std::int32_t>(bits_of(sum[k]) >> row.cut);
    for (int k = 0; k < result_lanes; ++k)
        high[k] = static_cast<std::int32_t>(bits_of(times(top[k], y[k])) >> 32);
    for (int k = 0; k < result_lanes; ++k) {
        const std::int32_t wanted = down_to - up[k];
        const std::int32_t at_least = wanted < least ? least : wanted;
        const std::int32_t n = at_least < most ? at_least : most;
        // Of the high half: 2^31 times the error of y, and what the sums' cuts lose. Not coarse, a
        // cut sum_w is lifted by 11 bits at most.
        const auto error = static_cast<std::int32_t>(9u + (cut << (up[k] & 15)));
        const std::int32_t rounded = high[k] + (half << (n - 1));
        const std::int32_t q = fixed::floor_shift(rounded - error, n);
        const std::int32_t q_high = fixed::floor_shift(rounded + error, n);
        const std::int32_t positive = y[k] != 0 ? 1 : 0, cannot = n != wanted ? positive : 0;
        unsure[k] = q != q_high ? positive : cannot;
        const std::uint32_t above = static_cast<std::uint32_t>(q) + end;
        const std::int32_t v = above < 2 * end ? q : no_result;
        out[k] = positive != 0 ? v : no_result;
    }
}

// The line's words of Z, all before the first of them is read: in blocks they would be written in
// halves of a register, and a register that is read back as one would wait for both.
static inline void find_words(const ResultLine& line, const hw::Depth16* __restrict depth,
                              std::int32_t* __restrict z) {
    for (int x = 0; x < line.width; ++x) z[x] = (depth[x] - line.offset) * (1 << line.z_up);
}
// By words of 64 bits, which leaves the lanes to the rest.
static inline bool has_drawn(const ResultLine& line, const hw::Depth16* depth) {
    static_assert(sizeof(hw::Depth16) == 2 && result_lanes == 16);
    std::uint64_t four[4], other = 0;
    __builtin_memcpy(four, depth, sizeof four);
    for (int k = 0; k < 4; ++k)
        other |= four[k] ^ 0x0001000100010001u * static_cast<std::uint64_t>(line.background);
    return other != 0;
}

// Blocks of 16 pixels of a line, by their first columns. They are listed without a branch, for what
// comes next cannot be predicted, and with each list the processor has several blocks under way.
struct Blocks {
    int count;
    int x[widest_row / result_lanes];
};
static inline void list_block(Blocks& list, int x, bool is_one) {
    list.x[list.count] = x;
    list.count += is_one ? 1 : 0;
}

// By columns: words of Z, reciprocals of W and how far it is lifted.
struct Divisors {
    const std::int32_t *z, *y, *up;
};
static inline bool divide_16(const ResultLine& line, const Divisors& by, int x, RowMemory& m,
                             Lane64* sum, Lane32* unsure) {
    for (int row = 0; row < 3; ++row) {
        find_sums(line.row[row], m.column_wide[row] + x, by.z + x, sum[row]);
        divide_sums(line, line.row[row], sum[row], by.y + x, by.up + x, m.column_high[row] + x,
                    unsure[row]);
    }
    std::int32_t any = 0;
    for (int k = 0; k < result_lanes; ++k) any |= unsure[0][k] | unsure[1][k] | unsure[2][k];
    return any != 0;
}

// Asks the definition for what is unsure: a pixel in some hundreds.
static void divide_unsure(const ResultLine& line, const Divisors& by, int x, RowMemory& m) {
    Lane64 sum[3], sum_w;
    Lane32 unsure[3];
    divide_16(line, by, x, m, sum, unsure);
    find_sums(line.row[3], m.column_wide[3] + x, by.z + x, sum_w);
    for (int row = 0; row < 3; ++row)
        for (int k = 0; k < result_lanes; ++k)
            if (unsure[row][k] != 0)
                m.column_high[row][x + k] = quotient_of(line, line.row[row], sum[row][k], sum_w[k]);
}

static inline void divide_line(const ResultLine& line, const Blocks& drawn, RowMemory& m) {
    std::int32_t *z = m.result[0], *y = m.result[1], *up = m.result[2];
    const Divisors by{z, y, up};
    Blocks again;
    again.count = 0;
    for (int i = 0; i < drawn.count; ++i) {
        const int x = drawn.x[i];
        Lane64 sum_w;
        find_sums(line.row[3], m.column_wide[3] + x, z + x, sum_w);
        find_reciprocals(line, sum_w, y + x, up + x);
    }
    for (int i = 0; i < drawn.count; ++i) {
        Lane64 sum[3];
        Lane32 unsure[3];
        list_block(again, drawn.x[i], divide_16(line, by, drawn.x[i], m, sum, unsure));
    }
    for (int i = 0; i < again.count; ++i) divide_unsure(line, by, again.x[i], m);
}

static inline void shift_line(const ResultLine& line, const Blocks& drawn, RowMemory& m) {
    for (int i = 0; i < drawn.count; ++i)
        for (int row = 0; row < 3; ++row) {
            const int x = drawn.x[i];
            Lane64 sum;
            find_sums(line.row[row], m.column_wide[row] + x, m.result[0] + x, sum);
            shift_sums(line.row[row], sum, m.column_high[row] + x);
        }
}

static void results_form(const ResultLine& line, const hw::Depth16* depth, RowMemory& m) {
    Blocks drawn;
    drawn.count = 0;
    find_words(line, depth, m.result[0]);
    for (int x = 0; x < line.width; x += result_lanes)
        list_block(drawn, x, has_drawn(line, depth + x));
    if (line.divides) divide_line(line, drawn, m);
    else shift_line(line, drawn, m);
}

#endif
