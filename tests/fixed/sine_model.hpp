// The slow model of sine and cosine: Q.120 in 256-bit integers, pi by Machin's formula, the plain
// Taylor series without any folding of the angle. Shares no constant and no path with the code
// under test. Every step truncates by less than 2^-120, so results are good to 2^-110.
#pragma once

#include "fixed/wide_int.hpp"

namespace umbra78::fixed::test {

using Wide = WideInt<4>;
inline constexpr int model_bits = 120;

inline Wide multiply_model(const Wide& a, const Wide& b) { return (a * b) >> model_bits; }

// arctan(1/n) = 1/n - 1/(3 n^3) + 1/(5 n^5) - ...
inline Wide arctan_of_inverse(std::int64_t n) {
    Wide power = (Wide(1) << model_bits) / n, sum = 0;
    for (std::int64_t k = 1; !power.is_zero(); k += 2) {
        sum += k % 4 == 1 ? power / k : -(power / k);
        power = power / (n * n);
    }
    return sum;
}

struct SineCosineModel {
    Wide sine, cosine;
};

// Of an angle in units of 2^-16 degree, any value within +-2^31.
inline SineCosineModel sine_cosine_model(std::int64_t degrees_q16) {
    static const Wide pi = (arctan_of_inverse(5) * 4 - arctan_of_inverse(239)) * 4;
    const std::int64_t turn = std::int64_t{360} << 16;
    const Wide x = pi * (degrees_q16 % turn) / (turn / 2);
    SineCosineModel sum{0, 0};
    Wide term = Wide(1) << model_bits;  // x^k / k!
    for (std::int64_t k = 0; !term.is_zero() && term != -1; ++k) {
        Wide& target = k % 2 == 0 ? sum.cosine : sum.sine;
        target += k % 4 < 2 ? term : -term;
        term = multiply_model(term, x) / (k + 1);
    }
    return sum;
}

// The nearest Q1.30 word, and how far from a tie it was, in units of 2^-120.
struct NearestWord {
    std::int64_t word;
    Wide distance_to_tie;
};
inline NearestWord nearest_q30(const Wide& v) {
    constexpr int dropped = model_bits - 30;
    const Wide half = Wide(1) << (dropped - 1);
    const Wide word = (v + half) >> dropped;
    const Wide from_tie = v + half - (word << dropped);  // 0 at the tie below
    const Wide to_next = (Wide(1) << dropped) - from_tie;
    return {word.to_int64(), from_tie < to_next ? from_tie : to_next};
}

}  // namespace umbra78::fixed::test
