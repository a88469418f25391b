#include "shadow/result_form.hpp"

#include <algorithm>
#include <bit>

namespace umbra78::shadow {
namespace {

using fixed::Rounding;

int result_bits(const hw::MachineSpec& m, std::size_t row) {
    return row == 2 ? m.z_bits + 1 : m.xy_bits + m.fraction_bits + 1;
}
int result_fraction(const hw::MachineSpec& m, std::size_t row) {
    return row == 2 ? m.depth_fraction() : m.fraction_bits;
}

// The bits of the greatest sum of a row by absolute values, without a sign.
int sum_bits(const ShadowTest& s, const hw::MatrixWords& m, std::size_t row) {
    const auto& c = m.word[row];
    std::uint64_t sum = fixed::magnitude(c[3]) * static_cast<std::uint64_t>(s.machine.one_word());
    for (std::size_t k = 0; k < 3; ++k)
        sum += fixed::magnitude(c[k]) << (s.machine.word_bits() - 1);
    return static_cast<int>(std::bit_width(sum));
}

int shift_of(const ShadowTest& s, const hw::MatrixWords& m, std::size_t row) {
    const int fraction = result_fraction(s.machine, row);
    if (m.divides()) return hw::divide_shift(m, static_cast<hw::Row>(row), fraction);
    return hw::affine_shift(m, static_cast<hw::Row>(row), s.machine, hw::screen_words(s.machine),
                            fraction);
}

// The lanes' sums are of at most 61 bits, and a rest's divisor of 58.
constexpr int most_bits = 61, most_divisor_bits = 58;

}  // namespace

bool result_lines_cover(const ShadowTest& s, const hw::MatrixWords& m) {
    const hw::MachineSpec& spec = s.machine;
    if (spec.word_bits() > 24 || spec.dropped_bits() > 0) return false;
    if (m.divides() && spec.divide_order == hw::DivideOrder::round_first) return false;
    for (std::size_t r = 0; r < 3; ++r) {
        const int shift = shift_of(s, m, r);
        if (sum_bits(s, m, r) > most_bits) return false;
        if (m.divides() ? sum_bits(s, m, 3) + std::max(0, -shift) > most_divisor_bits
                        : shift < 1 || shift > 60)
            return false;
    }
    return true;
}

void first_result_line(const ShadowTest& s, const hw::MatrixWords& m, int first_column, int width,
                       ResultLine& line, RowMemory& memory) {
    const hw::MachineSpec& spec = s.machine;
    const hw::Words first = pixel_words(first_column, 0, 0, s);
    const hw::Words next = pixel_words(first_column + 1, 1, 0, s);
    line.divides = m.divides();
    line.half_up = spec.transform_rounding == Rounding::half_up;
    line.cut_w = std::max(0, sum_bits(s, m, 3) - 31);
    line.width = width;
    line.z_up = spec.input_fraction() - spec.depth_fraction();
    line.offset = static_cast<std::int32_t>(spec.depth_offset());
    line.background = static_cast<std::int32_t>(spec.background());
    for (std::size_t r = 0; r < 4; ++r) {
        const auto& c = m.word[r];
        ResultRow& row = line.row[r];
        row.shift = r < 3 ? shift_of(s, m, r) : 0;
        row.bits = result_bits(spec, r);
        row.cut = std::max(0, sum_bits(s, m, r) - 31);
        row.z_coefficient = c[2];
        row.line = std::int64_t{c[1]} * first.y + std::int64_t{c[3]} * spec.one_word();
        row.step = std::int64_t{c[1]} * (next.y - first.y);
        if (!line.divides && line.half_up && r < 3) row.line += std::int64_t{1} << (row.shift - 1);
        std::int64_t v = std::int64_t{c[0]} * first.x;
        const std::int64_t step = std::int64_t{c[0]} * (next.x - first.x);
        for (int x = 0; x < line.width; ++x, v += step) memory.column_wide[r][x] = v;
    }
    for (std::size_t r = 0; r < 3; ++r) {
        std::fill_n(memory.column_high[r], line.width, 0);
        std::fill_n(memory.column_low[r], line.width, 0);
    }
}

void next_result_line(ResultLine& line, int lines) {
    for (ResultRow& row : line.row) row.line += row.step * lines;
}

std::int32_t quotient_of(const ResultLine& line, const ResultRow& row, std::int64_t sum,
                         std::int64_t sum_w) {
    const fixed::Quotient q = fixed::divide(sum, sum_w, row.shift, row.bits,
                                            line.half_up ? Rounding::half_up : Rounding::floor);
    return q.status == fixed::DivideStatus::ok ? static_cast<std::int32_t>(q.value) : no_result;
}

}  // namespace umbra78::shadow
