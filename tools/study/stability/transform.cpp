// A frame's transform unit against its exact matrix, point by point.
//
//   affine        |error| <= 1/2 + sum_j |v_j| u_r / 2              u_r: a row's coefficient LSB
//   perspective   |error| <= 1/2 + (dN + |q| dW) / (W - dW)         dN, dW: those sums
//
// in LSB of the output. The exact side is computed in double precision; 2^-46 of the sum of the
// magnitudes is added to the bound for it, a thousandth of what 32-bit coefficients lose.
#include "tools/study/stability/stability.hpp"

#include <array>
#include <cmath>

namespace umbra78::tools::study {
namespace {

double real(const fixed::Rational& r) {
    if (r.is_zero()) return 0;
    const int log2 = r.floor_log2();
    std::int64_t word = 0;
    r.round_scaled(60 - log2, fixed::Rounding::half_even, word);
    return std::ldexp(static_cast<double>(word), log2 - 60);
}

// A row's value at a point, and by how much rounded coefficients and cut products may change it.
struct RowValue {
    double value, doubt;
};

using Matrix = std::array<std::array<double, 4>, 4>;

Matrix real(const hw::RationalMatrix& exact, bool affine) {
    Matrix m{};
    for (std::size_t r = 0; r < 4; ++r)
        for (std::size_t j = 0; j < 4; ++j)
            m[r][j] = real(affine ? exact[r][j] / exact[3][3] : exact[r][j]);
    return m;
}

RowValue at(const Matrix& m, std::size_t row, const hw::MatrixWords& words,
            const hw::MachineSpec& spec, const hw::Words& v) {
    const double scale = std::ldexp(1, -spec.input_fraction());
    const double coefficient_lsb = std::ldexp(1, words.exponent[row] - spec.coefficient_bits + 2);
    // The fourth coefficient multiplies the word for one, which is 2^(n - 2).
    const double one = spec.one_word() * scale;
    const std::array<double, 4> in{v.x * scale, v.y * scale, v.z * scale, one};
    RowValue sum{0, 0};
    double magnitude = 0;
    for (std::size_t j = 0; j < 4; ++j) {
        const double term = m[row][j] * (j == 3 ? 1 : in[j]);
        sum.value += term;
        magnitude += std::abs(term);
        sum.doubt += std::abs(in[j]) * coefficient_lsb / 2;
    }
    sum.doubt += std::ldexp(magnitude, -46);
    if (spec.dropped_bits() > 0)
        sum.doubt += 4 * std::ldexp(coefficient_lsb * scale, spec.dropped_bits());
    return sum;
}

struct Judge {
    const hw::MachineSpec& spec;
    const hw::MatrixWords& words;
    Matrix exact;
    TransformError& found;

    void value(double is, double must, double doubt, int fraction) const {
        const double error = std::abs(is - std::ldexp(must, fraction));
        const double bound = 0.5 + std::ldexp(doubt, fraction);
        if (error / bound < found.over_bound) return;
        found.over_bound = error / bound;
        found.worst = error;
        found.bound = bound;
    }

    void affine(const hw::Words& v, const hw::Point& p) const {
        const std::array<std::int64_t, 3> out{p.x, p.y, p.z};
        if (p.status != hw::DivideStatus::ok) found.sound = false;
        for (std::size_t r = 0; r < 3; ++r) {
            const RowValue q = at(exact, r, words, spec, v);
            value(static_cast<double>(out[r]), q.value, q.doubt, fraction(r));
        }
        ++found.points;
    }

    // Where the exact values leave no doubt, the status must be the right one.
    void divided(const hw::Words& v, const hw::Point& p) const {
        const RowValue w = at(exact, 3, words, spec, v);
        const bool behind = p.status == hw::DivideStatus::divisor_not_positive;
        if (w.value > w.doubt ? behind : (w.value < -w.doubt && !behind)) found.sound = false;
        if (p.status != hw::DivideStatus::ok) ++found.refused;
        if (w.value <= w.doubt) return;
        const std::array<std::int64_t, 3> out{p.x, p.y, p.z};
        bool surely_out = false, surely_in = true;
        std::array<double, 3> q{}, doubt{};
        for (std::size_t r = 0; r < 3; ++r) {
            const RowValue n = at(exact, r, words, spec, v);
            q[r] = n.value / w.value;
            doubt[r] = (n.doubt + std::abs(q[r]) * w.doubt) / (w.value - w.doubt);
            const double edge = std::ldexp(1, r == 2 ? spec.z_bits : spec.xy_bits + fraction(r));
            const double size = std::abs(std::ldexp(q[r], fraction(r)));
            const double slack = 1 + std::ldexp(doubt[r], fraction(r));
            surely_out = surely_out || size - slack > edge;
            surely_in = surely_in && size + slack < edge;
        }
        const bool overflow = p.status == hw::DivideStatus::overflow;
        if (overflow ? surely_in : surely_out && !behind) found.sound = false;
        if (p.status != hw::DivideStatus::ok) return;
        for (std::size_t r = 0; r < 3; ++r)
            value(static_cast<double>(out[r]), q[r], doubt[r], fraction(r));
        ++found.points;
    }

    int fraction(std::size_t row) const {
        return row == 2 ? spec.depth_fraction() : spec.fraction_bits;
    }
};

}  // namespace

TransformError transform_error(const hw::RationalMatrix& exact, const hw::MachineSpec& spec) {
    TransformError found;
    hw::MatrixWords words;
    if (hw::load_matrix(exact, spec, hw::screen_words(spec), words) != hw::LoadStatus::ok)
        return found;
    const hw::TransformUnit unit(spec, words);
    const Judge judge{spec, words, real(exact, words.affine), found};
    const std::int32_t max = (std::int32_t{1} << (spec.word_bits() - 1)) - 1;
    constexpr int steps = 12;  // the words' whole range, both ends and 0
    const auto word = [&](int k) {
        return static_cast<std::int32_t>(std::int64_t{max} * (2 * k - steps) / steps -
                                         (k == 0 ? 1 : 0));
    };
    for (int i = 0; i <= steps; ++i)
        for (int j = 0; j <= steps; ++j)
            for (int k = 0; k <= steps; ++k) {
                const hw::Words v{word(i), word(j), word(k)};
                if (words.affine)
                    judge.affine(v, unit(v));
                else
                    judge.divided(v, unit(v));
            }
    return found;
}

}  // namespace umbra78::tools::study
