// Independent models of what a point goes through before the lookup: its words, the transform, the
// dither. In 128-bit integers, from hw/MACHINE.md, sections 2, 5 and 10; nothing is shared with
// the units but the meaning.
#pragma once

#include "hw/noise_source.hpp"
#include "hw/transform_unit.hpp"
#include "shadow/shadow_test.hpp"
#include "tests/fixed/boundary.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

namespace umbra78::shadow::test {

using fixed::test::Int128;
using fixed::test::model_round;

inline Int128 two_to(int n) { return Int128{1} << n; }

// The noise register's stream from its recurrence, one bit at a time, and a pixel's two words.
class SlowNoise {
public:
    SlowNoise(const hw::Dither& d, const hw::MachineSpec& m)
        : k_(bytes(d.shape)), dither_(d), fraction_(m.fraction_bits),
          bit_((std::size_t{16} << (2 * m.xy_bits)) * static_cast<std::size_t>(k_)) {
        for (std::size_t n = 0; n < bit_.size(); ++n)
            bit_[n] = n < 31 ? (d.seed >> n & 1) != 0 : bit_[n - 31] != bit_[n - 28];
    }
    hw::DitherWords words(std::size_t pixel) const {
        if (k_ == 0) return {0, 0};
        const std::size_t first = pixel * 16 * static_cast<std::size_t>(k_);
        return {word(first), word(first + 8 * static_cast<std::size_t>(k_))};
    }
    // Bytes in a word's sum, from section 10's table.
    static int bytes(hw::DitherShape shape) {
        switch (shape) {
            case hw::DitherShape::none: return 0;
            case hw::DitherShape::uniform: return 1;
            case hw::DitherShape::triangular: return 2;
            case hw::DitherShape::normal4: return 4;
            default: return 12;
        }
    }

private:
    std::int32_t word(std::size_t first) const {
        Int128 sum = 0;
        for (std::size_t i = 0; i < 8 * static_cast<std::size_t>(k_); ++i)
            sum += bit_[first + i] ? 1 << i % 8 : 0;
        const Int128 amplitude = model_round(Int128{dither_.size_q8} << (fraction_ + 16),
                                             Int128{256 * 512} * k_, fixed::Rounding::half_up);
        return static_cast<std::int32_t>(
            model_round((2 * sum - 255 * k_) * amplitude, 1 << 16, fixed::Rounding::half_up));
    }
    int k_;
    hw::Dither dither_;
    int fraction_;
    std::vector<bool> bit_;
};

// A window's taps' bytes: the noise's bits from the 2^30-th on, pixel after pixel. The first of
// them come from the recurrence for a power of two, b[n] = b[n - 31 s] xor b[n - 28 s], the rest
// one by one.
class SlowTapNoise {
public:
    explicit SlowTapNoise(const ShadowTest& s)
        : taps_(s.tap_places == TapPlaces::jittered &&
                        (s.lookup == Lookup::percentage || s.lookup == Lookup::filtered_depth)
                    ? s.taps * s.taps
                    : 0),
          seed_(s.dither.seed) {
        bit_.resize(static_cast<std::size_t>(16 * taps_) << (2 * s.machine.xy_bits));
        for (std::size_t n = 0; n < bit_.size(); ++n)
            bit_[n] = n < 31 ? bit((std::uint64_t{1} << 30) + n) : bit_[n - 31] != bit_[n - 28];
    }
    hw::TapBytes bytes(std::size_t pixel) const {
        hw::TapBytes out;
        const auto taps = static_cast<std::size_t>(taps_);
        for (std::size_t t = 0; t < taps; ++t) {
            const std::size_t first = 16 * (pixel * taps + t);
            for (std::size_t k = 0; k < 8; ++k) {
                out.x[t] = static_cast<std::uint8_t>(out.x[t] | bit_[first + k] << k);
                out.y[t] = static_cast<std::uint8_t>(out.y[t] | bit_[first + 8 + k] << k);
            }
        }
        return out;
    }

private:
    bool bit(std::uint64_t n) {
        if (n < 31) return (seed_ >> n & 1) != 0;
        if (const auto found = known_.find(n); found != known_.end()) return found->second;
        std::uint64_t s = 1;
        while (62 * s <= n) s *= 2;
        return known_[n] = bit(n - 31 * s) != bit(n - 28 * s);
    }
    int taps_;
    std::uint32_t seed_;
    std::vector<bool> bit_;
    std::map<std::uint64_t, bool> known_;
};

// Input words have as many fraction bits as Z needs, and one at least: a pixel's centre.
inline int slow_input_fraction(const hw::MachineSpec& m) {
    return std::max(m.z_bits - m.xy_bits, 1);
}
inline int slow_word_bits(const hw::MachineSpec& m) { return m.xy_bits + slow_input_fraction(m); }

using SlowWords = std::array<Int128, 3>;  // x, y, z

inline Int128 slow_z_word(const hw::MachineSpec& m, std::uint32_t code) {
    return (Int128{code} - two_to(m.z_bits - 1)) *
           two_to(slow_input_fraction(m) + m.xy_bits - m.z_bits);
}

// A pixel's centre, or its upper left corner, and its Z code.
inline SlowWords slow_words(const ShadowTest& s, int px, int py, std::uint32_t code) {
    const hw::MachineSpec& m = s.machine;
    const int centre = s.registration == Registration::centre ? 1 : 0;
    const auto screen = [&](int p) {
        return (2 * (p - two_to(m.xy_bits - 1)) + centre) * two_to(slow_input_fraction(m) - 1);
    };
    return {screen(px), screen(py), slow_z_word(m, code)};
}

// Words through the matrix as exact fractions, each coordinate rounded once. An accumulator that
// is too short rounds each product to the bits that it has.
inline hw::Point slow_transform(const hw::MatrixWords& m, const hw::MachineSpec& spec,
                                const SlowWords& words) {
    const int in = slow_input_fraction(spec);
    const std::array<Int128, 4> v{words[0], words[1], words[2],
                                  two_to(slow_word_bits(spec) - 2)};
    const Int128 least = two_to(std::max(
        slow_word_bits(spec) + spec.coefficient_bits + 3 - spec.max_accumulator_bits, 0));
    std::array<Int128, 4> sum{};
    for (std::size_t r = 0; r < 4; ++r)
        for (std::size_t c = 0; c < 4; ++c)
            sum[r] += least * model_round(m.word[r][c] * v[c], least, spec.product_rounding);
    if (!m.affine && sum[3] <= 0)
        return {0, 0, 0, hw::DivideStatus::divisor_not_positive};
    const auto result = [&](std::size_t r, int fraction) {
        // affine: sum 2^(e - (C - 2) - in + fraction), else sum_r 2^(e_r - e_w + fraction) / sum_w
        const int up = m.affine ? m.exponent[r] - (spec.coefficient_bits - 2) - in + fraction
                                : m.exponent[r] - m.exponent[3] + fraction;
        const Int128 divisor = m.affine ? Int128{1} : sum[3];
        return static_cast<std::int64_t>(model_round(sum[r] * two_to(std::max(up, 0)),
                                                     divisor * two_to(std::max(-up, 0)),
                                                     spec.transform_rounding));
    };
    return {result(0, spec.fraction_bits), result(1, spec.fraction_bits),
            result(2, spec.z_bits - spec.xy_bits), hw::DivideStatus::ok};
}

}  // namespace umbra78::shadow::test
