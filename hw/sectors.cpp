#include "hw/sectors.hpp"

#include "hw/matrix_rows.hpp"

#include <algorithm>

namespace umbra78::hw {

LoadStatus load_sector(const std::array<ExactRow, 3>& directions, const ExactRow& z,
                       const MachineSpec& spec, WordFormat input, MatrixWords& out) {
    using enum LoadStatus;
    constexpr std::array<std::size_t, 3> holds{0, 1, 3};  // the unit's rows X, Y, W
    std::array<ExactRow, 3> rows;
    int common = min_exponent;
    for (std::size_t a = 0; a < 3; ++a) {
        rows[a] = for_words(directions[a], input);
        int exponent = 0;
        if (!quantize_row(rows[a], spec, out.word[holds[a]], exponent))
            return exponent_out_of_range;
        common = std::max(common, exponent);
    }
    for (std::size_t a = 0; a < 3; ++a)
        if (!round_row(rows[a], common, spec, out.word[holds[a]])) return exponent_out_of_range;
    int exponent_z = 0;
    if (!quantize_row(for_words(z, input), spec, out.word[2], exponent_z))
        return exponent_out_of_range;
    if (magnitude(exponent_z - common) > max_apart) return exponent_out_of_range;
    // X and Y are in pixels: half_px times the quotient.
    const int scale = spec.xy_bits - 1;
    out.exponent = {common + scale, common + scale, exponent_z, common};
    out.affine = false;
    return ok;
}

}  // namespace umbra78::hw
