// The noise source: two dither words for each pixel position, from one 31-stage shift register.
//
// Every pixel, visible or not, owns 16 k successive bits of the register's stream. The first 8 k
// make the X word, the next 8 k the Y word: the sum of k unsigned bytes, centred and scaled to
// `size` texels peak to peak (fixed/dither.hpp). k = 1 is uniform, 2 triangular, 4 and 12
// pseudo-normal (Williams 1978, p. 273: normal, within -.5 .. +.5). A pixel's state is reached by
// a jump, so the words do not depend on the order in which pixels are worked on.
// In: the dither's settings; a shape other than `none`, and a seed of 31 bits that is not 0. Out:
// words in texels with MachineSpec::fraction_bits fraction bits.
#pragma once

#include "fixed/noise.hpp"
#include "hw/machine_spec.hpp"

#include <array>
#include <cstdint>

namespace umbra78::hw {

enum class DitherShape : std::uint8_t { none, uniform, triangular, normal4, normal };

// Bytes in one word's sum.
constexpr int uniforms(DitherShape s) {
    constexpr std::array<int, 5> k{0, 1, 2, 4, 12};
    return k[static_cast<std::size_t>(s)];
}

struct Dither {
    DitherShape shape = DitherShape::none;
    std::int32_t size_q8 = 256;       // texels peak to peak, Q8.8: 256 is -0.5 .. +0.5 texel
    std::uint32_t seed = 0x12345678;  // 31 bits, not zero
};

struct DitherWords {
    std::int32_t x, y;  // texels, MachineSpec::fraction_bits fraction bits
};

// Whether every dither word is 0: dither off, or so small that the largest sum rounds to 0.
constexpr bool silent(const Dither& dither, const MachineSpec& spec) {
    const int k = uniforms(dither.shape);
    if (k == 0) return true;
    const std::int64_t largest = 255 * k;
    return largest * fixed::dither_amplitude(k, dither.size_q8, spec.fraction_bits) < 1 << 15;
}

// The words of successive pixels, from (x, y) on.
class NoiseSource {
public:
    NoiseSource(const Dither& dither, const MachineSpec& spec, int x, int y)
        : k_(uniforms(dither.shape)),
          amplitude_(fixed::dither_amplitude(k_, dither.size_q8, spec.fraction_bits)),
          register_(dither.seed) {
        const auto pixel =
            (static_cast<std::uint64_t>(y) << spec.xy_bits) + static_cast<std::uint64_t>(x);
        register_.jump(pixel * 16 * static_cast<std::uint64_t>(k_));
    }

    DitherWords next() {
        const int sx = sum();
        const int sy = sum();
        return {fixed::dither_word(sx, k_, amplitude_), fixed::dither_word(sy, k_, amplitude_)};
    }

private:
    int sum() {
        int total = 0;
        for (int left = k_; left > 0; left -= 8) {
            const int n = left < 8 ? left : 8;
            total += fixed::sum_of_uniforms(register_.take(8 * n), n);
        }
        return total;
    }

    int k_;
    std::int32_t amplitude_;
    fixed::NoiseRegister register_;
};

// --- the taps of a window -----------------------------------------------------------------------

inline constexpr int max_taps = 25;  // 5 x 5

// Two bytes for each tap of a point, row by row: where the tap lies in its cell.
struct TapBytes {
    std::array<std::uint8_t, max_taps> x{}, y{};
};

// The taps' bytes of successive pixels, from (x, y) on: 16 bits a tap, from half a period into the
// stream of the same seed, so that they are not those of the dither.
class TapNoise {
public:
    static constexpr std::uint64_t start = std::uint64_t{1} << 30;

    // `taps` of 0..max_taps a pixel.
    TapNoise(std::uint32_t seed, int taps, const MachineSpec& spec, int x, int y)
        : taps_(taps), register_(seed) {
        fixed::require(taps >= 0 && taps <= max_taps, "noise: 0..25 taps a pixel");
        if (taps == 0) return;
        const auto pixel =
            (static_cast<std::uint64_t>(y) << spec.xy_bits) + static_cast<std::uint64_t>(x);
        register_.jump(start + pixel * 16 * static_cast<std::uint64_t>(taps));
    }

    TapBytes next() {
        TapBytes bytes;
        for (std::size_t t = 0; t < static_cast<std::size_t>(taps_); ++t) {
            const std::uint64_t pair = register_.take(16);
            bytes.x[t] = static_cast<std::uint8_t>(pair & 255);
            bytes.y[t] = static_cast<std::uint8_t>(pair >> 8);
        }
        return bytes;
    }

private:
    int taps_;
    fixed::NoiseRegister register_;
};

}  // namespace umbra78::hw
