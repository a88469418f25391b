// The 4 x 4 homogeneous transform unit: words in, exact accumulators, one rounding out.
//
//   acc_r = c_r0 x + c_r1 y + c_r2 z + c_r3 one         (exact; 35 bits in 1978's widths, unless
//                                                        MachineSpec gives it fewer)
//   out_r = round(acc_r 2^(e_r) / 2^(C - 2) / 2^(in))   in `out` fraction bits   (affine)
//   out_r = round(acc_r 2^(e_r) / (acc_w 2^(e_w)))      by the divider           (perspective)
//
// A coefficient is a signed Q1.(C - 2) word; a row shares the block exponent e_r. The homogeneous
// input `one` is the word 2^(bits - 2), so the fourth column holds t 2^(in - bits + 2) for a
// translation t: with 16-bit Q8.7 words, +-256 pixels at exponent 0, in steps of a quantum.
// The shadow's bias is part of the Z row (Williams 1978, p. 272).
//
// In: words of at most `bits` bits, coefficients of at most C bits. Out: X and Y in pixels from the
// centre with fraction_bits fraction bits, Z in quanta from the middle of its range. A quotient
// that does not exist (acc_w <= 0) or does not fit is a status of the point.
// Not emulated here: the clock. This is the functional form; the cycles are closed forms, below.
#pragma once

#include "fixed/divide.hpp"
#include "fixed/rational.hpp"
#include "fixed/rounding.hpp"
#include "hw/features.hpp"
#include "hw/machine_spec.hpp"

#include <array>
#include <cstdint>

namespace umbra78::hw {

using fixed::Rational;

using RationalMatrix = std::array<std::array<Rational, 4>, 4>;

// Input words: value = word / 2^fraction, `bits` wide.
struct WordFormat {
    int bits;
    int fraction;
    constexpr std::int32_t one_word() const { return std::int32_t{1} << (bits - 2); }
};

constexpr WordFormat screen_words(const MachineSpec& m) {
    return {m.word_bits(), m.input_fraction()};
}

enum class Row : std::uint8_t { x, y, z, w };

struct MatrixWords {
    std::array<std::array<std::int32_t, 4>, 4> word{};  // [row][column], Q1.(C - 2)
    std::array<int, 4> exponent{};                      // value = word 2^(exponent - C + 2)
    bool affine = true;                                 // the W row is (0, 0, 0, 1)
    constexpr bool operator==(const MatrixWords&) const = default;

    // Whether a point's W must be summed and divided by.
    constexpr bool divides() const { return built(Feature::perspective) && !affine; }
};

enum class LoadStatus : std::uint8_t { ok, exponent_out_of_range };

inline constexpr int min_exponent = -31;
inline constexpr int max_exponent = 31;
// Between a perspective row and W: with up to 20 fraction bits the divider shifts 62 places.
inline constexpr int max_apart = 42;

// Rounds an exact matrix to coefficient words: the smallest exponent that holds the whole row.
// Refused: a row that no exponent in range holds, one too far from W, and a W row of zeros.
LoadStatus load_matrix(const RationalMatrix& exact, const MachineSpec& spec, WordFormat input,
                       MatrixWords& out);

struct Words {
    std::int32_t x, y, z;
};

using Accumulators = std::array<std::int64_t, 4>;

constexpr std::int64_t accumulate(const MatrixWords& m, Row row, const Words& v,
                                  std::int32_t one) {
    const auto& c = m.word[static_cast<std::size_t>(row)];
    return std::int64_t{c[0]} * v.x + std::int64_t{c[1]} * v.y + std::int64_t{c[2]} * v.z +
           std::int64_t{c[3]} * one;
}

// The rounding of each product to the bits that a short accumulator has. The result keeps its
// scale; the dropped bits are zero.
struct ProductCut {
    int dropped = 0;
    Rounding rounding = Rounding::floor;

    // Where nothing is dropped nothing is rounded.
    constexpr bool operator==(const ProductCut& other) const {
        return dropped == other.dropped && (dropped == 0 || rounding == other.rounding);
    }
    constexpr std::int64_t operator()(std::int64_t product) const {
        return fixed::round_shift(product, dropped, rounding) * (std::int64_t{1} << dropped);
    }
};

constexpr ProductCut product_cut(const MachineSpec& m) {
    return {m.dropped_bits(), m.product_rounding};
}

constexpr std::int64_t accumulate(const MatrixWords& m, Row row, const Words& v, std::int32_t one,
                                  ProductCut cut) {
    const auto& c = m.word[static_cast<std::size_t>(row)];
    return cut(std::int64_t{c[0]} * v.x) + cut(std::int64_t{c[1]} * v.y) +
           cut(std::int64_t{c[2]} * v.z) + cut(std::int64_t{c[3]} * one);
}

// How far an affine row's accumulator shifts right to leave `out_fraction` bits.
constexpr int affine_shift(const MatrixWords& m, Row row, const MachineSpec& spec,
                           WordFormat input, int out_fraction) {
    return spec.coefficient_bits - 2 + input.fraction - out_fraction -
           m.exponent[static_cast<std::size_t>(row)];
}

// How far a perspective row's dividend shifts left to leave `out_fraction` bits.
constexpr int divide_shift(const MatrixWords& m, Row row, int out_fraction) {
    return out_fraction + m.exponent[static_cast<std::size_t>(row)] - m.exponent[3];
}

using fixed::DivideStatus;
using fixed::Quotient;

struct Point {
    std::int64_t x, y;    // pixels from the centre, fraction_bits fraction bits
    std::int64_t z;       // depth quanta from the centre of the cube
    DivideStatus status;  // of the perspective divide; ok where there is none
};

// With an affine matrix these three give the same value for every point, so the unit may leave them
// out. Computing them changes no bit of a frame; they show that, and what they cost.
struct UnitWork {
    bool constant_product = false;  // c_r3 one for every point, not once for the matrix
    bool w_row = false;             // acc_w for every point
    bool divide = false;            // by that constant
    constexpr bool operator==(const UnitWork&) const = default;
};

// The unit as the shadow post-process uses it: screen words in, screen words of another view out.
// Drawing uses it with another word format and with exact accumulators.
class TransformUnit {
public:
    TransformUnit(const MachineSpec& spec, const MatrixWords& matrix, UnitWork work = {})
        : TransformUnit(spec, matrix, screen_words(spec), work, product_cut(spec)) {}
    TransformUnit(const MachineSpec& spec, const MatrixWords& matrix, WordFormat input,
                  UnitWork work, ProductCut cut = {});

    Point operator()(const Words& v) const {
        if constexpr (built(Feature::perspective)) {
            if (matrix_.divides() || work_.divide) return divided(v);
        }
        return affine(v);
    }

    Point affine(const Words& v) const;
    Point divided(const Words& v) const;
    // A row's sum, and what the divider makes of the four sums.
    std::int64_t sum(Row row, const Words& v) const;
    Point quotients(Accumulators acc) const;
    // One row of an affine matrix with `fraction` fraction bits, by a shift or by the divider.
    std::int64_t affine_row(Row row, const Words& v, int fraction) const;

    const MatrixWords& matrix() const { return matrix_; }
    const MachineSpec& spec() const { return spec_; }

private:
    std::int64_t sum_w(const Words& v) const;
    Quotient quotient(Row row, const Accumulators& acc, int fraction, int bits) const;

    MachineSpec spec_;
    MatrixWords matrix_;
    WordFormat input_;
    UnitWork work_;
    ProductCut cut_;
    Accumulators constant_{};  // c_r3 one, preloaded
};

// Cycles that the multipliers need for a point. Coefficients or words of more than 16 bits take two
// passes each. Where w is 1 the fourth product is a preloaded constant and the W row is left out,
// so an affine point costs 9 products, any other 16.
constexpr int transform_cycles(const MachineSpec& spec, bool affine, UnitWork work = {}) {
    const int passes = (spec.coefficient_bits > 16 ? 2 : 1) * (spec.word_bits() > 16 ? 2 : 1);
    const int rows = affine && !work.w_row ? 3 : 4;
    const int per_row = affine && !work.constant_product ? 3 : 4;
    switch (spec.multipliers) {
        case 1: return rows * per_row * passes;
        case 4: return rows * passes;
        default: return passes;
    }
}

// Cycles of one serial restoring divider for X, Y and Z of a point, one after the other: a cycle
// for each bit of the quotient (sign, value and the rounding bit; Sproull and Sutherland, 1968) and
// two to load and to correct.
constexpr int serial_divide_cycles(const MachineSpec& spec) {
    const int xy = spec.xy_bits + spec.fraction_bits + 2;
    const int z = spec.z_bits + 2;
    return 2 * (xy + 2) + z + 2;
}

}  // namespace umbra78::hw
