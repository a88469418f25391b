// The page of the widths study: what each width buys, with plots and heat maps.
#pragma once

#include "tools/study/study.hpp"

namespace umbra78::tools::study {

void report_widths(const Request&, std::span<const Row>, Report&);

// The power of 2^xy_bits with which a column grows, by least squares of logarithms: 2 for what
// follows the square law of lateral resolution. Rows in which the column is not positive are left
// out; NaN if fewer than two widths remain.
double growth_per_doubling(std::span<const Row>, const char* column);

}  // namespace umbra78::tools::study
