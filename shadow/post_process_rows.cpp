// The post-process a scan line at a time: its shares, the plain form, and the pass.
//
// An affine result is floor((c_x x + c_y y + c_z z + c_1 one + half) / 2^S). On a scan line only x
// and z change, so the sum is a column's share, a row's share and c_z z. Each share is split at
// the binary point into a whole part and S low bits; the low bits and c_z z fit 32 bits together,
// and floor(a 2^S + b) / 2^S = a + floor(b / 2^S) makes the result exact in 32-bit lanes.
// Where 32 bits without a sign hold every sum of the frame, counted from the map's corner, the
// lanes have all bits as low ones: a rotation seldom needs more.

#include "shadow/row_form.hpp"

#include "fixed/dither.hpp"

#include <algorithm>
#include <array>

namespace umbra78::shadow {
namespace {

using fixed::Rounding;

// With 35-bit accumulators a shift of 6 leaves results of 29 bits, and low parts of 28 bits leave
// room for two of them and a 31-bit product.
constexpr int min_shift = 6;
constexpr int max_shift = 28;

struct Rounded {
    int shift;
    std::int64_t half;  // added before the floor
};

int output_fraction(const hw::MachineSpec& m, std::size_t row) {
    return row == 2 ? m.depth_fraction() : m.fraction_bits;
}

Rounded rounded(const ShadowTest& s, const hw::MatrixWords& matrix, std::size_t row) {
    const int shift = hw::affine_shift(matrix, static_cast<hw::Row>(row), s.machine,
                                       hw::screen_words(s.machine),
                                       output_fraction(s.machine, row));
    const bool half_up = s.machine.transform_rounding == Rounding::half_up && shift > 0;
    return {shift, half_up ? std::int64_t{1} << (shift - 1) : 0};
}

// A bound of the dither words, before their last 16 bits are rounded off.
std::int64_t largest_scaled_dither(const ShadowTest& s) {
    if (hw::silent(s.dither, s.machine)) return 0;
    const int k = hw::uniforms(s.dither.shape);
    return std::int64_t{255} * k *
               fixed::dither_amplitude(k, s.dither.size_q8, s.machine.fraction_bits) + (1 << 15);
}
std::int64_t largest_dither(const ShadowTest& s) {
    return fixed::floor_shift(largest_scaled_dither(s), 16) + 1;
}

constexpr std::int64_t magnitude_of(std::int64_t v) { return v < 0 ? -v : v; }

// With c the map's corner, B the bound of a sum by absolute values, and all modulo 2^32: a place
// inside the map, 0 <= sum + c < 2 c, is no other place's word if B + c < 2^32.
bool fits_whole(const ShadowTest& s, const hw::MatrixWords& m) {
    const std::int64_t largest = std::int64_t{1} << (s.machine.word_bits() - 1);
    const std::int64_t dither = largest_dither(s);
    for (std::size_t r = 0; r < 3; ++r) {
        const auto& c = m.word[r];
        const Rounded k = rounded(s, m, r);
        const std::int64_t coefficients = magnitude_of(c[0]) + magnitude_of(c[1]) +
                                          magnitude_of(c[2]);
        const std::int64_t corner = r == 2 ? s.machine.depth_offset() : volume_edge(s.machine);
        const std::int64_t bound = coefficients * largest +
                                   magnitude_of(c[3]) * s.machine.one_word() + k.half +
                                   ((corner + (r == 2 ? 0 : dither)) << k.shift);
        if (bound > UINT32_MAX) return false;
    }
    return true;
}

struct Split {
    std::int32_t high, low;
};
Split split(std::int64_t v, int shift, bool whole) {
    if (whole) return {0, static_cast<std::int32_t>(v)};
    return {static_cast<std::int32_t>(fixed::floor_shift(v, shift)),
            static_cast<std::int32_t>(v & ((std::int64_t{1} << shift) - 1))};
}

// The line's share of a result is what does not change along it; `step` from line to line.
struct LineSum {
    std::int64_t value, step;
    int shift;
    std::int16_t z_coefficient;
};
LineSum first_line(const ShadowTest& s, const hw::MatrixWords& m, std::size_t r) {
    const std::int64_t y = pixel_words(0, 0, 0, s).y, step = pixel_words(0, 1, 0, s).y - y;
    const Rounded k = rounded(s, m, r);
    const std::int64_t v = m.word[r][1] * y +
                           std::int64_t{m.word[r][3]} * s.machine.one_word() + k.half;
    return {v, m.word[r][1] * step, k.shift, static_cast<std::int16_t>(m.word[r][2])};
}
void set_share(LineSum& sum, bool whole, RowShare& share) {
    const Split v = split(sum.value, sum.shift, whole);
    share = {v.high, v.low, sum.z_coefficient, sum.shift};
    sum.value += sum.step;
}

void column_shares(const ShadowTest& s, const hw::MatrixWords& m, bool whole, RowMemory& memory) {
    const std::int64_t first = pixel_words(0, 0, 0, s).x, step = pixel_words(1, 0, 0, s).x - first;
    for (std::size_t r = 0; r < 3; ++r) {
        const int shift = rounded(s, m, r).shift;
        std::int64_t v = m.word[r][0] * first;
        for (int x = 0; x < s.machine.size_px(); ++x, v += m.word[r][0] * step) {
            const Split parts = split(v, shift, whole);
            memory.column_high[r][x] = parts.high;
            memory.column_low[r][x] = parts.low;
        }
    }
}

// The pixels of a scan line between its first and its last visible one.
struct Span {
    std::size_t first, end;
};

Span visible_span(const hw::Depth16* depth, std::size_t n, hw::Depth16 none) {
    Span s{0, n};
    while (s.first < n && depth[s.first] == none) ++s.first;
    while (s.end > s.first && depth[s.end - 1] == none) --s.end;
    return s;
}

// z words are 16 bits, like the coefficient: a widening product the compiler has lanes for.
void transform_row(const RowLine& line, Span span, RowMemory& memory) {
    for (std::size_t r = 0; r < 3; ++r) {
        const RowShare k = line.share[r];
        const hw::Depth16* depth = line.depth;
        const std::int32_t *high = memory.column_high[r], *low = memory.column_low[r];
        const std::int32_t offset = line.offset;
        const int z_up = line.z_up;
        std::int32_t* out = memory.result[r];
        for (std::size_t x = span.first; x < span.end; ++x) {
            const auto z = static_cast<std::int16_t>((depth[x] - offset) * (1 << z_up));
            const std::int32_t product = std::int32_t{k.z_coefficient} * z;
            out[x] = high[x] + k.high + fixed::floor_shift(low[x] + k.low + product, k.shift);
        }
    }
}

// The sum of a word's n low bytes.
int bytes(std::uint64_t w, int n) { return fixed::sum_of_uniforms(w, n); }

// Four or twelve bytes a word: a pixel's bits are one or three steps of the 64-bit stream.
template <int K>
void add_normal(const hw::Dither& d, const hw::MachineSpec& m, int y, Span span,
                RowMemory& memory) {
    const std::int32_t amplitude = fixed::dither_amplitude(K, d.size_q8, m.fraction_bits);
    fixed::NoiseRegister start(d.seed);
    start.jump(((static_cast<std::uint64_t>(y) << m.xy_bits) + span.first) * 16 * K);
    fixed::NoiseStream64 stream(start);
    for (std::size_t x = span.first; x < span.end; ++x) {
        const std::uint64_t a = stream.next64();
        int sx = bytes(a, 4), sy = bytes(a >> 32, 4);
        if constexpr (K == 12) {
            const std::uint64_t b = stream.next64(), c = stream.next64();
            sx = bytes(a, 8) + bytes(b, 4);
            sy = bytes(b >> 32, 4) + bytes(c, 8);
        }
        memory.result[0][x] += fixed::dither_word(sx, K, amplitude);
        memory.result[1][x] += fixed::dither_word(sy, K, amplitude);
    }
}

void add_dither(const ShadowTest& s, int y, Span span, RowMemory& memory) {
    const hw::Dither& d = s.dither;
    if (d.shape == hw::DitherShape::normal4) return add_normal<4>(d, s.machine, y, span, memory);
    if (d.shape == hw::DitherShape::normal) return add_normal<12>(d, s.machine, y, span, memory);
    hw::NoiseSource noise(d, s.machine, static_cast<int>(span.first), y);
    for (std::size_t x = span.first; x < span.end; ++x) {
        const hw::DitherWords w = noise.next();
        memory.result[0][x] += w.x;
        memory.result[1][x] += w.y;
    }
}

// Nearest: the address of the texel, and the code or -1 where the pixel is lit for sure.
void nearest_addresses(const hw::Depth16* depth, Span span, const hw::MachineSpec& m,
                       RowMemory& memory) {
    const std::int32_t edge = m.half_px() << m.fraction_bits, limit = 2 * edge;
    const int f = m.fraction_bits, xy = m.xy_bits;
    const auto offset = static_cast<std::int32_t>(m.depth_offset());
    const auto beyond = static_cast<std::int32_t>(m.background());  // also: nothing drawn
    const std::int32_t* X = memory.result[0];
    const std::int32_t* Y = memory.result[1];
    std::int32_t* Z = memory.result[2];
    std::int32_t* address = memory.address;
    for (std::size_t i = span.first; i < span.end; ++i) {
        const std::int32_t x = X[i] + edge, y = Y[i] + edge, code = Z[i] + offset;
        // All ones where every one of these is negative, that is: inside the light's volume.
        const std::int32_t inside =
            fixed::floor_shift(~x & ~y & ~code & (x - limit) & (y - limit) & (code - beyond) &
                                   (std::int32_t{depth[i]} - beyond), 31);
        address[i] = ((fixed::floor_shift(y, f) << xy) + fixed::floor_shift(x, f)) & inside;
        Z[i] = code | ~inside;
    }
}

std::uint32_t nearest_row(const RowLine& line, Span span, RowMemory& memory) {
    nearest_addresses(line.depth, span, line.test->machine, memory);
    const hw::Depth16* texels = line.texels;
    std::uint8_t* mask = line.mask;
    std::int32_t* code = memory.result[2];
    std::int32_t* texel = memory.result[0];
    for (std::size_t i = span.first; i < span.end; ++i)
        texel[i] = texels[static_cast<std::uint32_t>(memory.address[i])];
    std::uint32_t shadowed = 0;
    for (std::size_t i = span.first; i < span.end; ++i) {
        const std::uint32_t shadow = static_cast<std::uint32_t>(texel[i] - code[i]) >> 31;
        mask[i] = static_cast<std::uint8_t>(0 - shadow);
        shadowed += shadow;
    }
    return shadowed;
}

std::uint32_t bilinear_row(const RowLine& line, Span span, RowMemory& memory) {
    const ShadowTest& s = *line.test;
    const hw::MachineSpec& m = s.machine;
    const hw::Depth16 *depth = line.depth, *texels = line.texels;
    const std::int32_t one = 1 << m.fraction_bits, f = m.fraction_bits;
    const std::int32_t last = m.size_px() - 1, half = m.half_px();
    const auto offset = static_cast<std::int32_t>(m.depth_offset());
    std::uint32_t shadowed = 0;
    for (std::size_t i = span.first; i < span.end; ++i) {
        bool shadow = false;
        const std::int32_t x = memory.result[0][i], y = memory.result[1][i];
        const std::int32_t code = memory.result[2][i] + offset;
        const std::int32_t cx = x - one / 2, cy = y - one / 2;
        const std::int32_t tx = fixed::floor_shift(cx, f) + half;
        const std::int32_t ty = fixed::floor_shift(cy, f) + half;
        if (depth[i] == m.background()) {
            // nothing drawn
        } else if (s.background == Background::blend && tx >= 0 && ty >= 0 && tx < last &&
                   ty < last && code >= 0 &&
                   code <= static_cast<std::int32_t>(m.deepest_drawn())) {
            const hw::Depth16* t = texels + (static_cast<std::size_t>(ty) << m.xy_bits) + tx;
            const auto fx = static_cast<std::uint32_t>(cx & (one - 1));
            const auto fy = static_cast<std::uint32_t>(cy & (one - 1));
            const std::uint32_t wx = static_cast<std::uint32_t>(one) - fx;
            const std::uint32_t wy = static_cast<std::uint32_t>(one) - fy;
            const std::uint32_t blend =
                wy * (wx * t[0] + fx * t[1]) +
                fy * (wx * t[m.size_px()] + fx * t[m.size_px() + 1]);
            shadow = static_cast<std::uint32_t>(code) << (2 * f) > blend;
        } else {
            // At the map's edge, outside the volume, or falling back: the definition itself.
            shadow = row_pixel_in_shadow(line, x, y, memory.result[2][i]);
        }
        line.mask[i] = shadow ? mask_shadow : mask_lit;
        shadowed += shadow;
    }
    return shadowed;
}

// What a frame's lines have in common.
RowLine line_of(const ShadowTest& s, const LightMap<hw::Depth16>& light) {
    const hw::MachineSpec& m = s.machine;
    RowLine line{};
    line.test = &s;
    line.light = &light;
    line.texels = light.store.depth.data();
    line.width = m.size_px();
    line.xy_bits = m.xy_bits;
    line.fraction_bits = m.fraction_bits;
    line.z_up = m.input_fraction() - m.depth_fraction();
    line.offset = static_cast<std::int32_t>(m.depth_offset());
    line.background = static_cast<std::int32_t>(m.background());
    line.bilinear = hw::built(hw::Feature::bilinear) && s.lookup == Lookup::bilinear;
    if (hw::built(hw::Feature::dither) && !hw::silent(s.dither, m)) {
        line.uniforms = hw::uniforms(s.dither.shape);
        line.amplitude = fixed::dither_amplitude(line.uniforms, s.dither.size_q8, m.fraction_bits);
    }
    return line;
}

}  // namespace

bool rows_cover(const ShadowTest& settings, const hw::MatrixWords& matrix) {
    const hw::MachineSpec& m = settings.machine;
    if (has_window(settings.lookup) || settings.receiver != Receiver::point) return false;
    if (!matrix.affine || m.size_px() > widest_row || m.z_bits > 16 || m.word_bits() > 16 ||
        m.coefficient_bits > 16 || m.fraction_bits > 7 || m.fraction_bits < 1 ||
        m.dropped_bits() > 0)  // a cut product is no sum of shares
        return false;
    if (m.transform_rounding != Rounding::half_up && m.transform_rounding != Rounding::floor)
        return false;
    for (std::size_t r = 0; r < 3; ++r) {
        const int shift = rounded(settings, matrix, r).shift;
        if (shift < min_shift || shift > max_shift) return false;
    }
    return true;
}

bool lanes_cover(const ShadowTest& s) {
    if (s.lookup == Lookup::bilinear && s.background == Background::fall_back) return false;
    return largest_scaled_dither(s) <= INT32_MAX;
}

bool row_pixel_in_shadow(const RowLine& line, std::int32_t x, std::int32_t y, std::int32_t z) {
    return in_shadow(*line.light, hw::Point{x, y, z, hw::DivideStatus::ok}, hw::DitherWords{0, 0});
}

void start_row_noise(const RowLine& line, std::uint32_t* words) {
    fixed::NoiseStream64 stream(line.noise);
    for (int i = 0; i < 32; i += 2) {
        const std::uint64_t two = stream.next64();
        words[i] = static_cast<std::uint32_t>(two);
        words[i + 1] = static_cast<std::uint32_t>(two >> 32);
    }
}

RowCounts plain_row(const RowLine& line, RowMemory& memory) {
    const ShadowTest& s = *line.test;
    const auto n = static_cast<std::size_t>(line.width);
    const auto none = static_cast<hw::Depth16>(line.background);
    const Span span = visible_span(line.depth, n, none);
    std::fill_n(line.mask, span.first, mask_lit);
    std::fill_n(line.mask + span.end, n - span.end, mask_lit);
    if (span.first == span.end) return {0, 0};  // background alone: no transform, no noise
    std::uint32_t visible = 0;
    for (std::size_t x = span.first; x < span.end; ++x) visible += line.depth[x] != none;
    transform_row(line, span, memory);
    if (line.uniforms > 0) add_dither(s, line.y, span, memory);
    const std::uint32_t shadowed = line.bilinear ? bilinear_row(line, span, memory)
                                                 : nearest_row(line, span, memory);
    return {visible, shadowed};
}

PostProcessCounts post_process_rows(const DepthMaps<hw::Depth16>& maps,
                                    const hw::MatrixWords& matrix, const ShadowTest& settings,
                                    RowMemory& memory, std::span<std::uint8_t> mask,
                                    const RowForm& form) {
    const hw::MachineSpec& m = settings.machine;
    check(maps, m, mask);
    fixed::require(rows_cover(settings, matrix),
                   "post-process: the row form does not cover these settings or this matrix");
    fixed::require(form.supported(), "post-process: this processor has not the row form's lanes");
    const LightMap<hw::Depth16> light = light_map(maps.light, settings);
    RowLine line = line_of(settings, light);
    const auto run = lanes_cover(settings) ? form.run : plain_row;
    if (line.uniforms > 0) line.noise = fixed::NoiseRegister(settings.dither.seed);
    const std::uint32_t line_of_noise = fixed::NoiseRegister::power_of_x(
        static_cast<std::uint64_t>(line.width) * 16 * static_cast<std::uint64_t>(line.uniforms));
    line.whole = run != plain_row && fits_whole(settings, matrix);
    column_shares(settings, matrix, line.whole, memory);
    std::array<LineSum, 3> sums{first_line(settings, matrix, 0), first_line(settings, matrix, 1),
                                first_line(settings, matrix, 2)};
    PostProcessCounts counts;
    for (line.y = 0; line.y < line.width; ++line.y) {
        line.depth = maps.observer.depth.data() + maps.observer.address(0, line.y);
        line.mask = mask.data() + maps.observer.address(0, line.y);
        for (std::size_t r = 0; r < 3; ++r) set_share(sums[r], line.whole, line.share[r]);
        const RowCounts c = run(line, memory);
        if (line.uniforms > 0) line.noise.jump_by(line_of_noise);
        counts.visible += c.visible;
        counts.shadowed += c.shadowed;
    }
    return counts;
}

PostProcessCounts post_process_rows(const DepthMaps<hw::Depth16>& maps,
                                    const hw::MatrixWords& matrix, const ShadowTest& settings,
                                    RowMemory& memory, std::span<std::uint8_t> mask) {
    return post_process_rows(maps, matrix, settings, memory, mask, fastest_row_form());
}

}  // namespace umbra78::shadow
