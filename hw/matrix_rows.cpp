#include "hw/matrix_rows.hpp"

#include "fixed/overflow.hpp"

#include <algorithm>

namespace umbra78::hw {

std::array<Rational, 4> for_words(std::array<Rational, 4> row, WordFormat input) {
    row[3] = row[3] / Rational(input.one_word(), std::int64_t{1} << input.fraction);
    return row;
}

bool round_row(const std::array<Rational, 4>& row, int exponent, const MachineSpec& spec,
               RowWords& words) {
    const int bits = spec.coefficient_bits;
    for (std::size_t i = 0; i < 4; ++i) {
        std::int64_t word = 0;
        if (!row[i].round_scaled(bits - 2 - exponent, spec.coefficient_rounding, word))
            return false;
        if (!fixed::fits(word, bits)) return false;
        words[i] = static_cast<std::int32_t>(word);
    }
    return true;
}

bool quantize_row(const std::array<Rational, 4>& row, const MachineSpec& spec, RowWords& words,
                  int& exponent) {
    int start = min_exponent;
    bool zero = true;
    for (const Rational& c : row) {
        if (c.is_zero()) continue;
        const int log2 = c.floor_log2();
        start = zero || log2 > start ? log2 : start;
        zero = false;
    }
    if (zero) {
        words = {};
        exponent = 0;
        return true;
    }
    // |c| < 2^(log2 + 1) fits Q1.x from exponent log2 on, or log2 - 1 for exactly -2^log2.
    for (int e = std::max(start - 1, min_exponent); e <= max_exponent; ++e) {
        if (round_row(row, e, spec, words)) {
            exponent = e;
            return true;
        }
    }
    return false;
}

}  // namespace umbra78::hw
