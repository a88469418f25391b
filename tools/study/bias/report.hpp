// What the bias study's rows say: plots, the table of least biases, and the answer for a scene.
#pragma once

#include "tools/study/study.hpp"

namespace umbra78::tools::study {

void report_bias(const Request&, std::span<const Row>, Report&);

// A unit of bias and how much the least bias changes in it from one width to another: the
// greatest over the least, 1 where it stands still.
struct UnitSpread {
    std::string unit;
    double spread;
};
// Of these rows' least biases outside the edge band, the steadiest first.
std::vector<UnitSpread> unit_spreads(std::span<const Row>);

}  // namespace umbra78::tools::study
