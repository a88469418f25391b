// What the transform unit's tests share: random matrices and words, and a slow model of the unit
// in 128-bit integers that shares nothing with it but the definition.
#pragma once

#include "hw/transform_unit.hpp"
#include "tests/fixed/boundary.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

namespace umbra78::hw::test {

using fixed::test::Int128;
using fixed::test::model_round;
using fixed::test::Random;

inline Int128 power_of_two(int n) { return Int128{1} << n; }

// value 2^shift rounded, for |value| < 2^62 or so and any shift that keeps 2^126.
inline Int128 model_scale(Int128 value, int shift, Rounding r) {
    return shift >= 0 ? value * power_of_two(shift) : model_round(value, power_of_two(-shift), r);
}

inline MachineSpec random_spec(Random& random) {
    MachineSpec m;
    m.xy_bits = static_cast<int>(random.between(4, 12));
    m.z_bits = static_cast<int>(random.between(4, 24));
    m.coefficient_bits = static_cast<int>(random.between(8, 32));
    m.fraction_bits = static_cast<int>(random.between(0, 12));
    m.transform_rounding = random.rounding();
    m.coefficient_rounding = random.rounding();
    if (random.bits() % 2 == 0) m.max_accumulator_bits = static_cast<int>(random.between(16, 62));
    m.product_rounding = random.rounding();
    return m;
}

// A word of `bits` bits; every fourth one is the minimum or the maximum.
inline std::int32_t random_word(Random& random, int bits) {
    const std::int64_t min = -(std::int64_t{1} << (bits - 1));
    switch (random.bits() % 8) {
        case 0: return static_cast<std::int32_t>(min);
        case 1: return static_cast<std::int32_t>(-min - 1);
        default: return static_cast<std::int32_t>(random.between(min, -min - 1));
    }
}

inline Words random_words(Random& random, int bits) {
    return {random_word(random, bits), random_word(random, bits), random_word(random, bits)};
}

// Coefficient words as load_matrix might leave them, with exponents of a plausible view.
inline MatrixWords random_matrix(Random& random, const MachineSpec& spec, bool affine) {
    MatrixWords m;
    m.affine = affine;
    for (std::size_t r = 0; r < 4; ++r) {
        m.exponent[r] = static_cast<int>(random.between(-6, 6));
        for (std::int32_t& c : m.word[r]) c = random_word(random, spec.coefficient_bits);
    }
    return m;
}

inline Int128 model_sum(const MatrixWords& m, std::size_t r, const Words& v,
                        const MachineSpec& spec) {
    const int needed = spec.word_bits() + spec.coefficient_bits + 3;
    const Int128 place = power_of_two(std::max(needed - spec.max_accumulator_bits, 0));
    const auto& c = m.word[r];
    const auto cut = [&](Int128 product) {
        return model_round(product, place, spec.product_rounding) * place;
    };
    return cut(Int128{c[0]} * v.x) + cut(Int128{c[1]} * v.y) + cut(Int128{c[2]} * v.z) +
           cut(Int128{c[3]} * spec.one_word());
}

// Fraction bits of the unit's X, Y and Z.
inline std::array<int, 3> out_fractions(const MachineSpec& m) {
    return {m.fraction_bits, m.fraction_bits, m.depth_fraction()};
}

}  // namespace umbra78::hw::test
