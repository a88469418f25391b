// The plain form of a scan line: loops over arrays of the line, of which any compiler makes what
// lanes it can. The sums are those of shadow/post_process_rows.cpp.
#include "shadow/row_form.hpp"

#include "fixed/dither.hpp"
#include "shadow/lines.hpp"

#include <algorithm>

namespace umbra78::shadow {
namespace {

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
void add_normal(const hw::Dither& d, const hw::MachineSpec& m, std::uint64_t pixel, Span span,
                RowMemory& memory) {
    const std::int32_t amplitude = fixed::dither_amplitude(K, d.size_q8, m.fraction_bits);
    fixed::NoiseRegister start(d.seed);
    start.jump(pixel * 16 * K);
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

void add_dither(const RowLine& line, Span span, RowMemory& memory) {
    const hw::MachineSpec& m = line.test->machine;
    const hw::Dither& d = line.test->dither;
    const int x = line.first + static_cast<int>(span.first);
    const std::uint64_t pixel =
        (static_cast<std::uint64_t>(line.y) << m.xy_bits) + static_cast<std::uint64_t>(x);
    if (d.shape == hw::DitherShape::normal4) return add_normal<4>(d, m, pixel, span, memory);
    if (d.shape == hw::DitherShape::normal) return add_normal<12>(d, m, pixel, span, memory);
    hw::NoiseSource noise(d, m, x, line.y);
    for (std::size_t i = span.first; i < span.end; ++i) {
        const hw::DitherWords w = noise.next();
        memory.result[0][i] += w.x;
        memory.result[1][i] += w.y;
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
            shadow = row_pixel_darkness(line, x, y, memory.result[2][i]) != mask_lit;
        }
        line.mask[i] = shadow ? mask_shadow : mask_lit;
        shadowed += shadow;
    }
    return shadowed;
}

// Of a window that lies on the map, from its first texel on.
std::uint8_t window_of_row(const RowLine& line, const hw::Depth16* texels, std::int32_t code) {
    const int side = line.window_side;
    std::int32_t dark = 0, sum = 0;
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) {
            const std::int32_t z = texels[j * line.size + i];
            dark += code > z ? 1 : 0;
            sum += z;
        }
    if (line.percentage) return share_of_dark(dark, line.light->window);
    return code * side * side > sum ? mask_shadow : mask_lit;
}

std::uint32_t window_row(const RowLine& line, Span span, RowMemory& memory) {
    const hw::MachineSpec& m = line.test->machine;
    const Window& window = line.light->window;
    const auto edge = static_cast<std::int32_t>(volume_edge(m));
    const std::int32_t last = line.size - line.window_side;
    const auto inside = [&](std::int32_t v) { return v >= -edge && v < edge; };
    std::uint32_t shadowed = 0;
    for (std::size_t i = span.first; i < span.end; ++i) {
        const std::int32_t x = memory.result[0][i], y = memory.result[1][i];
        const std::int32_t code = memory.result[2][i] + line.offset;
        line.mask[i] = mask_lit;
        if (line.depth[i] == line.background || !inside(x) || !inside(y) || code < 0 ||
            code >= line.background)
            continue;
        const std::int32_t tx = first_texel(m, window, x), ty = first_texel(m, window, y);
        line.mask[i] =
            tx >= 0 && ty >= 0 && tx <= last && ty <= last
                ? window_of_row(line, line.texels + (ty << line.xy_bits) + tx, code)
                : row_pixel_darkness(line, x, y, memory.result[2][i]);
        shadowed += line.mask[i] != mask_lit;
    }
    return shadowed;
}

std::uint32_t look_up_row(const RowLine& line, Span span, RowMemory& memory) {
    if (line.window_side > 0) return window_row(line, span, memory);
    return line.bilinear ? bilinear_row(line, span, memory) : nearest_row(line, span, memory);
}

}  // namespace

RowCounts plain_row(const RowLine& line, RowMemory& memory) {
    const auto n = static_cast<std::size_t>(line.width);
    const auto none = static_cast<hw::Depth16>(line.background);
    const Span span = visible_span(line.depth, n, none);
    std::fill_n(line.mask, span.first, mask_lit);
    std::fill_n(line.mask + span.end, n - span.end, mask_lit);
    if (span.first == span.end) return {0, 0};  // background alone: no transform, no noise
    std::uint32_t visible = 0;
    for (std::size_t x = span.first; x < span.end; ++x) visible += line.depth[x] != none;
    transform_row(line, span, memory);
    if (line.uniforms > 0) add_dither(line, span, memory);
    return {visible, look_up_row(line, span, memory)};
}

void plain_drawn(const hw::Depth16* codes, std::size_t words, hw::Depth16 none,
                 std::uint64_t* drawn) {
    for (std::size_t w = 0; w < words; ++w)
        drawn[w] = drawn_of_64(std::span<const hw::Depth16>(codes + 64 * w, 64), none);
}

}  // namespace umbra78::shadow
