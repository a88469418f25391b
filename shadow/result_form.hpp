// A scan line's transform in wide lanes, for matrices that the shares of 32 bits do not hold: in
// perspective, of more than 16 bits, or of any shift. A row form then does the rest: it finds the
// results in its columns' shares and its line's shares empty (shadow/post_process_rows.cpp).
//
// A row's sum is a column's share, a line's share and c_z z, in 64 bits. In perspective
//
//   result = round(sum 2^shift / sum_w)
//
// is found by the reciprocal of sum_w, of 31 bits by Newton's steps, which every row uses. The
// estimate's error has a bound; where that much more or less would round to another quotient (one
// pixel in some hundreds), and where a small sum_w leaves too few bits, the divider's definition is
// asked. So the results are exact. hw/MACHINE.md, section 5.
#pragma once

#include "shadow/post_process.hpp"

#include <cstdint>
#include <span>
#include <string_view>

namespace umbra78::shadow {

struct ResultRow {
    std::int64_t line;  // its share; with what is added to round, if there is no division
    std::int64_t step;  // from line to line
    std::int32_t z_coefficient;
    int shift;  // without division to the right, else to the left
    int bits;   // of a quotient
    int cut;    // bits that a sum may have beyond 31
};

// X, Y, Z and W. Plain words only.
struct ResultLine {
    ResultRow row[4];
    bool divides, half_up;
    int cut_w;
    int width, z_up;
    std::int32_t offset, background;
};

// What stands for a result that is none or lies far outside of the light's volume.
inline constexpr std::int32_t no_result = 1 << 28;

// Whether the lanes cover the matrix; then `line` is the first one of a strip of columns.
bool result_lines_cover(const ShadowTest& test, const hw::MatrixWords& matrix);
void first_result_line(const ShadowTest& test, const hw::MatrixWords& matrix, int first, int width,
                       ResultLine& line, RowMemory& memory);
void next_result_line(ResultLine& line, int lines = 1);

// The definition of a quotient.
std::int32_t quotient_of(const ResultLine& line, const ResultRow& row, std::int64_t sum,
                         std::int64_t sum_w);

struct ResultForm {
    std::string_view name;
    bool (*supported)();  // by this processor
    // Puts the line's results in memory.column_high; of background pixels any number.
    void (*run)(const ResultLine& line, const hw::Depth16* depth, RowMemory& memory);
};
std::span<const ResultForm> result_forms();
// The last one that is supported and that is not beyond the row form of this name.
const ResultForm& result_form_for(std::string_view row_form);

}  // namespace umbra78::shadow
