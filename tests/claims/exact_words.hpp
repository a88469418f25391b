// The exact distribution of a dither word: the probability of each word -64 .. 64 if the k bytes of
// its sum were independent and uniform. Exact but for a double's last bits: the sums' distribution
// by convolution, taken together where they round to one word.
#pragma once

#include "hw/noise_source.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace umbra78::claims {

template <int K>
std::array<double, 129> exact_words() {
    const auto counts = fixed::sum_counts<K>();
    const std::int32_t amplitude = fixed::dither_amplitude(K, 256, 7);
    std::array<double, 129> probability{};
    for (std::size_t s = 0; s < counts.size(); ++s) {
        double p = 0;
        if constexpr (K <= 7) {
            p = std::ldexp(static_cast<double>(counts[s]), -8 * K);
        } else {
            p = std::ldexp(static_cast<double>((counts[s] >> 48).to_int64()), 48 - 8 * K);
        }
        const int word = fixed::dither_word(static_cast<int>(s), K, amplitude);
        probability[static_cast<std::size_t>(word + 64)] += p;
    }
    return probability;
}

}  // namespace umbra78::claims
