// Dither words: sums of k uniform bytes, which are nearly normal for a large k.
//
//   sum      = byte[0] + ... + byte[k-1]                 0 .. 255 k, mean 127.5 k
//   word     = round_half_up((2 sum - 255 k) amplitude / 2^16)
//   amplitude = round_half_up(size 2^fraction_bits 2^16 / (512 k))
//
// k = 1 is uniform, 2 triangular, 3 and more bell-shaped (the central limit theorem). Words lie in
// -size/2 .. +size/2 for every k, so a size of one texel stays within half a texel to each side.
// The variance of the sum is k (2^16 - 1) / 12, that of the word about (size^2 / 12) / k.
//
// In: size in texels, 8 fraction bits; k = 1..12; 0..14 fraction bits of the word. Out: the word in
// texels with fraction_bits fraction bits; probabilities as exact counts out of 2^(8k). Anything
// else is a broken precondition.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "fixed/rounding.hpp"
#include "fixed/trap.hpp"
#include "fixed/wide_int.hpp"

namespace umbra78::fixed {

inline constexpr int max_uniforms = 12;  // of k

// The sum of the k low bytes of the word, 1 <= k <= 8: first of pairs of bytes, then by one
// multiplication of all pairs. A k above 8 takes its bytes from two words.
constexpr int sum_of_uniforms(std::uint64_t bits, int k) {
    require(k >= 1 && k <= 8, "dither: 1..8 uniforms a word");
    constexpr std::uint64_t even_bytes = 0x00ff00ff00ff00ff;
    const std::uint64_t drawn = bits & ~std::uint64_t{0} >> (64 - 8 * k);
    const std::uint64_t pairs = (drawn & even_bytes) + (drawn >> 8 & even_bytes);
    return static_cast<int>((pairs * 0x0001000100010001) >> 48);
}

// size_q8: peak to peak in texels, Q.8.
constexpr std::int32_t dither_amplitude(int k, std::int32_t size_q8, int fraction_bits) {
    require(k >= 1 && k <= max_uniforms, "dither: 1..12 uniforms");
    require(fraction_bits >= 0 && fraction_bits <= 14, "dither: 0..14 fraction bits");
    const std::int64_t scaled = scale_shift(size_q8, -(fraction_bits + 16), Rounding::floor);
    const std::int64_t amplitude =
        round_divide(scaled, (std::int64_t{1} << 8) * 512 * k, Rounding::half_up);
    require(amplitude >= INT32_MIN && amplitude <= INT32_MAX, "dither: amplitude overflow");
    return static_cast<std::int32_t>(amplitude);
}

// |2 sum - 255 k| <= 255 * 12 < 2^12, times 2^31: the product fits.
constexpr int dither_word(int sum, int k, std::int32_t amplitude) {
    const std::int64_t centred = std::int64_t{2} * sum - std::int64_t{255} * k;
    return static_cast<int>(round_shift(centred * amplitude, 16, Rounding::half_up));
}

// The exact distribution: sum_counts<K>()[s] of the 2^(8K) equally likely draws have the sum s.
// One more uniform byte convolves it with 256 ones, which is a running sum over 256 neighbours.
template <int K>
using SumCount = std::conditional_t<(K <= 7), std::uint64_t, WideInt<2>>;

template <int K>
constexpr std::array<SumCount<K>, 255 * K + 1> sum_counts() {
    static_assert(K >= 1 && K <= max_uniforms, "sum_counts: 1..12 uniforms");
    std::array<SumCount<K>, 255 * K + 1> counts{}, next{};
    counts[0] = 1;  // the empty sum
    for (std::size_t k = 1; k <= K; ++k) {
        SumCount<K> window = 0;
        for (std::size_t s = 0; s <= 255 * k; ++s) {
            window += counts[s];
            if (s >= 256) {
                window -= counts[s - 256];
            }
            next[s] = window;
        }
        counts = next;
    }
    return counts;
}

}  // namespace umbra78::fixed
