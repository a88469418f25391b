#include "hw/transform_unit.hpp"

#include "hw/matrix_rows.hpp"

namespace umbra78::hw {

LoadStatus load_matrix(const RationalMatrix& exact, const MachineSpec& spec, WordFormat input,
                       MatrixWords& out) {
    out.affine = exact[3][0].is_zero() && exact[3][1].is_zero() && exact[3][2].is_zero();
    if (out.affine && exact[3][3].is_zero()) return LoadStatus::exponent_out_of_range;
    for (std::size_t r = 0; r < 4; ++r) {
        std::array<Rational, 4> row = exact[r];
        if (out.affine) {
            for (Rational& c : row) c = c / exact[3][3];
        }
        if (!quantize_row(for_words(row, input), spec, out.word[r], out.exponent[r]))
            return LoadStatus::exponent_out_of_range;
    }
    for (std::size_t r = 0; r < 3; ++r) {
        const int apart = out.exponent[r] - out.exponent[3];
        if (!out.affine && (apart > max_apart || apart < -max_apart))
            return LoadStatus::exponent_out_of_range;
    }
    return LoadStatus::ok;
}

TransformUnit::TransformUnit(const MachineSpec& spec, const MatrixWords& matrix, WordFormat input,
                             UnitWork work, ProductCut cut)
    : spec_(spec), matrix_(matrix), input_(input), work_(work), cut_(cut) {
    if (!built(Feature::perspective)) work_.divide = false;  // there is no divider
    for (std::size_t r = 0; r < 4; ++r)
        constant_[r] = cut(std::int64_t{matrix.word[r][3]} * input.one_word());
}

std::int64_t TransformUnit::sum(Row row, const Words& v) const {
    const bool preloaded = matrix_.affine && !work_.constant_product;
    const std::int32_t one = preloaded ? 0 : input_.one_word();
    const std::int64_t acc = cut_.dropped == 0 ? accumulate(matrix_, row, v, one)
                                               : accumulate(matrix_, row, v, one, cut_);
    return preloaded ? acc + constant_[static_cast<std::size_t>(row)] : acc;
}

// For an affine matrix W is the constant, whether it is summed for the point or not.
std::int64_t TransformUnit::sum_w(const Words& v) const {
    return matrix_.affine && !work_.w_row ? constant_[3] : sum(Row::w, v);
}

Quotient TransformUnit::quotient(Row row, const Accumulators& acc, int fraction, int bits) const {
    return fixed::divide(acc[static_cast<std::size_t>(row)], acc[3],
                         divide_shift(matrix_, row, fraction), bits, spec_.transform_rounding);
}

std::int64_t TransformUnit::affine_row(Row row, const Words& v, int fraction) const {
    if (built(Feature::perspective) && work_.divide) {
        const Accumulators acc{sum(Row::x, v), sum(Row::y, v), sum(Row::z, v), sum_w(v)};
        return quotient(row, acc, fraction, 63).value;
    }
    return fixed::scale_shift(sum(row, v), affine_shift(matrix_, row, spec_, input_, fraction),
                              spec_.transform_rounding);
}

Point TransformUnit::affine(const Words& v) const {
    if (work_.w_row) fixed::require(sum_w(v) == constant_[3], "W row: not the constant");
    return {affine_row(Row::x, v, spec_.fraction_bits), affine_row(Row::y, v, spec_.fraction_bits),
            affine_row(Row::z, v, spec_.depth_fraction()), DivideStatus::ok};
}

Point TransformUnit::divided(const Words& v) const {
    return quotients({sum(Row::x, v), sum(Row::y, v), sum(Row::z, v), sum_w(v)});
}

Point TransformUnit::quotients(Accumulators acc) const {
    if (spec_.divide_order == DivideOrder::round_first && !matrix_.affine) {
        // The setting that shows what this costs: all sums first lose the product's low bits.
        for (std::int64_t& a : acc)
            a = fixed::round_shift(a, spec_.coefficient_bits - 2, spec_.transform_rounding);
    }
    Point p{0, 0, 0, DivideStatus::ok};
    const auto out = [&](Row row, int fraction, int bits) {
        const Quotient q = quotient(row, acc, fraction, bits);
        if (q.status != DivideStatus::ok) p.status = q.status;
        return q.value;
    };
    // One bit more than the volume needs: just outside it is a value, far outside a status.
    p.x = out(Row::x, spec_.fraction_bits, spec_.xy_bits + spec_.fraction_bits + 1);
    p.y = out(Row::y, spec_.fraction_bits, spec_.xy_bits + spec_.fraction_bits + 1);
    p.z = out(Row::z, spec_.depth_fraction(), spec_.z_bits + 1);
    return p;
}

}  // namespace umbra78::hw
