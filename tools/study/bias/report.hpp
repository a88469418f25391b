// The page of the bias study: plots, the table of least biases, and the answer for a scene.
#pragma once

#include "tools/study/study.hpp"

namespace umbra78::tools::study {

void report_bias(const Request&, std::span<const Row>, Report&);

// A column's number; "not found" where no bias up to the search's end suffices.
std::string figure(const Row& row, const std::string& column, int digits = 3);

// A unit of bias, and by how much the least bias changes in it from one width to another: the
// maximum over the minimum, 1 if it does not change.
struct UnitSpread {
    std::string unit;
    double spread;
};
// Of these rows' least biases outside the edge band; the unit that changes least comes first. A
// unit in which no row has a positive least bias is left out.
std::vector<UnitSpread> unit_spreads(std::span<const Row>);

}  // namespace umbra78::tools::study
