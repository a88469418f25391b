// The post-process a scan line at a time: its shares, and the pass.
//
// An affine result is floor((c_x x + c_y y + c_z z + c_1 one + half) / 2^S). On a scan line only x
// and z change, so the sum is a column's share, a row's share and c_z z. Each share is split at
// the binary point into a whole part and S low bits; the low bits and c_z z fit 32 bits together,
// and floor(a 2^S + b) / 2^S = a + floor(b / 2^S) makes the result exact in 32-bit lanes.
// Where 32 bits without a sign hold every sum of the frame, counted from the map's corner, the
// lanes have all bits as low ones: a rotation seldom needs more.
// Other matrices have their results found in wide lanes before (shadow/result_form.hpp).

#include "shadow/result_form.hpp"
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

namespace {

// Whether 32 bits hold a line's shares.
bool shares_cover(const ShadowTest& settings, const hw::MatrixWords& matrix) {
    const hw::MachineSpec& m = settings.machine;
    if (matrix.divides() || m.word_bits() > 16 || m.coefficient_bits > 16) return false;
    for (std::size_t r = 0; r < 3; ++r) {
        const int shift = rounded(settings, matrix, r).shift;
        if (shift < min_shift || shift > max_shift) return false;
    }
    return true;
}

}  // namespace

bool rows_cover(const ShadowTest& settings, const hw::MatrixWords& matrix) {
    const hw::MachineSpec& m = settings.machine;
    if (has_window(settings.lookup) || settings.receiver != Receiver::point) return false;
    if (m.size_px() > widest_row || m.z_bits > 16 || m.depth_store != hw::DepthStore::fixed ||
        m.fraction_bits > 7 || m.fraction_bits < 1 ||
        m.dropped_bits() > 0)  // a cut product is no sum of shares
        return false;
    if (m.transform_rounding != Rounding::half_up && m.transform_rounding != Rounding::floor)
        return false;
    return shares_cover(settings, matrix) || result_lines_cover(settings, matrix);
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

PostProcessCounts post_process_rows(const DepthMaps<hw::Depth16>& maps,
                                    const hw::MatrixWords& matrix, const ShadowTest& settings,
                                    RowMemory& memory, std::span<std::uint8_t> mask,
                                    const RowForm& form, hw::Band band) {
    const hw::MachineSpec& m = settings.machine;
    check(maps, m, mask);
    fixed::require(rows_cover(settings, matrix),
                   "post-process: the row form does not cover these settings or this matrix");
    fixed::require(form.supported(), "post-process: this processor has not the row form's lanes");
    const LightMap<hw::Depth16> light = light_map(maps.light, settings);
    RowLine line = line_of(settings, light);
    const auto run = lanes_cover(settings) ? form.run : plain_row;
    if (line.uniforms > 0) line.noise = fixed::NoiseRegister(settings.dither.seed);
    const std::uint64_t bits_of_line =
        static_cast<std::uint64_t>(line.width) * 16 * static_cast<std::uint64_t>(line.uniforms);
    const std::uint32_t line_of_noise = fixed::NoiseRegister::power_of_x(bits_of_line);
    band = band.within(line.width);
    if (line.uniforms > 0)
        line.noise.jump(static_cast<std::uint64_t>(band.first) * bits_of_line);
    const bool shares = shares_cover(settings, matrix);
    std::array<LineSum, 3> sums{};
    ResultLine results;
    if (shares) {
        line.whole = run != plain_row && fits_whole(settings, matrix);
        column_shares(settings, matrix, line.whole, memory);
        for (std::size_t r = 0; r < 3; ++r) {
            sums[r] = first_line(settings, matrix, r);
            sums[r].value += sums[r].step * band.first;
        }
    } else {
        first_result_line(settings, matrix, results, memory);
        next_result_line(results, band.first);
    }
    const ResultForm& transform = result_form_for(form.name);
    PostProcessCounts counts;
    for (line.y = band.first; line.y < band.end; ++line.y) {
        line.depth = maps.observer.depth.data() + maps.observer.address(0, line.y);
        line.mask = mask.data() + maps.observer.address(0, line.y);
        if (shares) {
            for (std::size_t r = 0; r < 3; ++r) set_share(sums[r], line.whole, line.share[r]);
        } else {  // the columns' shares are the results; the line has none
            for (RowShare& share : line.share) share = {0, 0, 0, min_shift};
            transform.run(results, line.depth, memory);
            next_result_line(results);
        }
        const RowCounts c = run(line, memory);
        if (line.uniforms > 0) line.noise.jump_by(line_of_noise);
        counts.visible += c.visible;
        counts.shadowed += c.shadowed;
    }
    return counts;
}

PostProcessCounts post_process_rows(const DepthMaps<hw::Depth16>& maps,
                                    const hw::MatrixWords& matrix, const ShadowTest& settings,
                                    RowMemory& memory, std::span<std::uint8_t> mask,
                                    hw::Band band) {
    return post_process_rows(maps, matrix, settings, memory, mask, fastest_row_form(), band);
}

}  // namespace umbra78::shadow
