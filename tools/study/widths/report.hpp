// What the widths study's rows say: plots over each width, heat maps, and what the bits buy.
#pragma once

#include "tools/study/study.hpp"

namespace umbra78::tools::study {

void report_widths(const Request&, std::span<const Row>, Report&);

// The power of 2^bits that a column grows as, by least squares of logarithms: 2 for what follows
// the square law of lateral resolution. NaN from fewer than two widths where it is not 0.
double growth_per_doubling(std::span<const Row>, const char* column);

}  // namespace umbra78::tools::study
