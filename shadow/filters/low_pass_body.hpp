// The steps of the low-pass in lanes: a text for fixed/lane_sets.hpp, of low_pass.cpp; alone it is
// empty. All sums fit 16 bits: 16 times 255.
#ifdef UMBRA78_LANES_TEXT

// Each loop twice: a whole strip's count is a constant, which spares the rest of a last vector.
static inline bool read(const hw::Depth16* depth, const std::uint8_t* mask,
                        hw::Depth16 background, int count, std::uint8_t* __restrict missing,
                        std::uint8_t* __restrict self) {
    std::uint8_t any = 0;
    for (int x = 0; x < count; ++x) {
        const std::uint8_t none = depth[x] == background ? 1 : 0;
        missing[x] = none;
        self[x] = static_cast<std::uint8_t>(mask[x] & (none - 1));
        any |= self[x];
    }
    return any != 0;
}

static inline void across(LowPassStrip& strip, int count) {
    const std::uint8_t *n = strip.missing, *m = strip.self;
    std::uint16_t* __restrict sum = strip.sum;
    std::uint8_t* __restrict weight = strip.weight;
    for (int x = 0; x < count; ++x)
        sum[x] = static_cast<std::uint16_t>(m[x] + 2 * m[x + 1] + m[x + 2]);
    for (int x = 0; x < count; ++x)
        weight[x] = static_cast<std::uint8_t>(n[x] + 2 * n[x + 1] + n[x + 2]);
}

static inline void add_lines(const LowPassStrip& above, const LowPassStrip& here,
                             const LowPassStrip& below, int count, std::uint8_t* __restrict out) {
    for (int x = 0; x < count; ++x) {
        const auto weight =
            static_cast<std::uint8_t>(above.weight[x] + 2 * here.weight[x] + below.weight[x]);
        const auto seen =
            static_cast<std::uint16_t>(above.sum[x] + 2 * here.sum[x] + below.sum[x]);
        const std::uint16_t self = here.self[x + 1];
        const auto sum = static_cast<std::uint16_t>(
            seen + static_cast<std::uint16_t>(self * std::uint16_t{weight}) + 8);
        // What is missing has self = 0, but its neighbours' darkness in the sum.
        const auto kept = static_cast<std::uint16_t>(here.missing[x + 1] - 1);
        out[x] = static_cast<std::uint8_t>(static_cast<std::uint16_t>(sum >> 4) & kept);
    }
}

static bool read_form(const hw::Depth16* depth, const std::uint8_t* mask, hw::Depth16 background,
                      int count, std::uint8_t* missing, std::uint8_t* self) {
    return count == LowPassStrip::most
               ? read(depth, mask, background, LowPassStrip::most, missing, self)
               : read(depth, mask, background, count, missing, self);
}
static void across_form(LowPassStrip& strip, int count) {
    count == LowPassStrip::most ? across(strip, LowPassStrip::most) : across(strip, count);
}
static void down_form(const LowPassStrip& above, const LowPassStrip& here,
                      const LowPassStrip& below, int count, std::uint8_t* out) {
    count == LowPassStrip::most ? add_lines(above, here, below, LowPassStrip::most, out)
                                : add_lines(above, here, below, count, out);
}

#endif
