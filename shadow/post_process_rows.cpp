// The post-process a scan line at a time: its shares, and the pass.
//
// An affine result is floor((c_x x + c_y y + c_z z + c_1 one + half) / 2^S). On a scan line only x
// and z change, so the sum is a column's share, a row's share and c_z z. Each share is split at
// the binary point into a whole part and S low bits; the low bits and c_z z fit 32 bits together,
// and floor(a 2^S + b) / 2^S = a + floor(b / 2^S) makes the result exact in 32-bit lanes.
// Where 32 bits without a sign hold every sum of the frame, counted from the map's corner, the
// lanes have all bits as low ones: a rotation seldom needs more.
// A frame wider than widest_row is done in strips of columns, each from its first line to its last.
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

void column_shares(const ShadowTest& s, const hw::MatrixWords& m, const RowLine& line,
                   RowMemory& memory) {
    const std::int64_t first = pixel_words(line.first, 0, 0, s).x;
    const std::int64_t step = pixel_words(line.first + 1, 0, 0, s).x - first;
    for (std::size_t r = 0; r < 3; ++r) {
        const int shift = rounded(s, m, r).shift;
        std::int64_t v = m.word[r][0] * first;
        for (int x = 0; x < line.width; ++x, v += m.word[r][0] * step) {
            const Split parts = split(v, shift, line.whole);
            memory.column_high[r][x] = parts.high;
            memory.column_low[r][x] = parts.low;
        }
    }
}

// share_of_dark() by the reciprocal of twice the taps, which 20 bits hold well enough.
struct ShareWords {
    std::int32_t scale, offset;
};
constexpr ShareWords share_words(int taps) {
    const std::int32_t over = ((1 << 20) + 2 * taps - 1) / (2 * taps);
    return {510 * over, taps * over};
}
static_assert([] {
    for (int side = 2; side <= max_taps_a_side; ++side)
        for (int count = 0; count <= side * side; ++count) {
            const ShareWords w = share_words(side * side);
            if (fixed::floor_shift(count * w.scale + w.offset, 20) !=
                share_of_dark(count, {side, false}))
                return false;
        }
    return true;
}());

// What a frame's lines have in common.
RowLine line_of(const ShadowTest& s, const LightMap<hw::Depth16>& light) {
    const hw::MachineSpec& m = s.machine;
    RowLine line{};
    line.test = &s;
    line.light = &light;
    line.texels = light.store.depth.data();
    line.size = m.size_px();
    line.width = std::min(line.size, widest_row);
    line.xy_bits = m.xy_bits;
    line.fraction_bits = m.fraction_bits;
    line.z_up = m.input_fraction() - m.depth_fraction();
    line.offset = static_cast<std::int32_t>(m.depth_offset());
    line.background = static_cast<std::int32_t>(m.background());
    line.bilinear = hw::built(hw::Feature::bilinear) && s.lookup == Lookup::bilinear;
    if (hw::built(hw::Feature::windows) && has_window(s.lookup)) {
        const ShareWords share = share_words(s.taps * s.taps);
        line.window_side = s.taps;
        line.percentage = s.lookup == Lookup::percentage;
        line.share_scale = share.scale;
        line.share_offset = share.offset;
    }
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
    const bool jittered = window_of(settings).jittered;
    if (jittered || settings.receiver != Receiver::point) return false;
    if (m.z_bits > 16 || m.depth_store != hw::DepthStore::fixed ||
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

std::uint8_t row_pixel_darkness(const RowLine& line, std::int32_t x, std::int32_t y,
                                std::int32_t z) {
    return darkness(*line.light, hw::Point{x, y, z, hw::DivideStatus::ok}, hw::DitherWords{0, 0});
}

void start_row_noise(const RowLine& line, std::uint32_t* words) {
    fixed::NoiseStream64 stream(line.noise);
    for (int i = 0; i < 32; i += 2) {
        const std::uint64_t two = stream.next64();
        words[i] = static_cast<std::uint32_t>(two);
        words[i + 1] = static_cast<std::uint32_t>(two >> 32);
    }
}

namespace {

// The strip of columns of which line.first is the first, within a band of the frame's lines.
class StripPass {
public:
    StripPass(const ShadowTest& test, const hw::MatrixWords& matrix, const RowLine& line,
              const RowForm& form, RowMemory& memory)
        : line_(line), run_(lanes_cover(test) ? form.run : plain_row),
          transform_(result_form_for(form.name)), memory_(memory),
          shares_(shares_cover(test, matrix)) {
        if (!shares_) {
            first_result_line(test, matrix, line_.first, line_.width, results_, memory);
        } else {
            line_.whole = run_ != plain_row && fits_whole(test, matrix);
            column_shares(test, matrix, line_, memory);
            for (std::size_t r = 0; r < 3; ++r) sums_[r] = first_line(test, matrix, r);
        }
        if (line_.uniforms == 0) return;
        line_.noise_line = &noise_line_;
        line_of_noise_ = fixed::NoiseRegister::power_of_x(bits_of(line_.size));
        line_.noise = fixed::NoiseRegister(test.dither.seed);
        line_.noise.jump(bits_of(line_.first));
    }

    PostProcessCounts run(const DepthMaps<hw::Depth16>& maps, std::span<std::uint8_t> mask,
                          const hw::Band& band) {
        for (LineSum& sum : sums_) sum.value += sum.step * band.first;
        next_result_line(results_, band.first);
        if (line_.uniforms > 0)
            line_.noise.jump(static_cast<std::uint64_t>(band.first) * bits_of(line_.size));
        PostProcessCounts counts;
        for (line_.y = band.first; line_.y < band.end; ++line_.y) {
            const std::size_t at = maps.observer.address(line_.first, line_.y);
            line_.depth = maps.observer.depth.data() + at;
            line_.mask = mask.data() + at;
            const RowCounts c = run_line();
            counts.visible += c.visible;
            counts.shadowed += c.shadowed;
        }
        return counts;
    }

private:
    // Of the noise of so many pixels.
    std::uint64_t bits_of(int pixels) const {
        return static_cast<std::uint64_t>(pixels) * 16 * static_cast<std::uint64_t>(line_.uniforms);
    }

    RowCounts run_line() {
        if (shares_) {
            for (std::size_t r = 0; r < 3; ++r) set_share(sums_[r], line_.whole, line_.share[r]);
        } else {  // the columns' shares are the results; the line has none
            for (RowShare& share : line_.share) share = {0, 0, 0, min_shift};
            transform_.run(results_, line_.depth, memory_);
            next_result_line(results_);
        }
        const RowCounts counts = run_(line_, memory_);
        if (line_.uniforms > 0) line_.noise.jump_by(line_of_noise_);
        return counts;
    }

    RowLine line_;
    RowCounts (*run_)(const RowLine&, RowMemory&);
    const ResultForm& transform_;
    RowMemory& memory_;
    bool shares_;
    std::array<LineSum, 3> sums_{};
    ResultLine results_{};
    std::uint32_t line_of_noise_ = 0;
    int noise_line_ = RowLine::no_line;
};

}  // namespace

PostProcessCounts post_process_rows(const DepthMaps<hw::Depth16>& maps,
                                    const hw::MatrixWords& matrix, const ShadowTest& settings,
                                    RowMemory& memory, std::span<std::uint8_t> mask,
                                    const RowForm& form, hw::Band band) {
    check(maps, settings.machine, mask);
    fixed::require(rows_cover(settings, matrix),
                   "post-process: the row form does not cover these settings or this matrix");
    fixed::require(form.supported(), "post-process: this processor has not the row form's lanes");
    const LightMap<hw::Depth16> light = light_map(maps.light, settings);
    RowLine line = line_of(settings, light);
    PostProcessCounts counts;
    for (; line.first < line.size; line.first += line.width)
        counts += StripPass(settings, matrix, line, form, memory)
                      .run(maps, mask, band.within(line.size));
    return counts;
}

PostProcessCounts post_process_rows(const DepthMaps<hw::Depth16>& maps,
                                    const hw::MatrixWords& matrix, const ShadowTest& settings,
                                    RowMemory& memory, std::span<std::uint8_t> mask,
                                    hw::Band band) {
    return post_process_rows(maps, matrix, settings, memory, mask, fastest_row_form(), band);
}

}  // namespace umbra78::shadow
