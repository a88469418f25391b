// Pareto fronts: the points that no other beats in both coordinates, less being better.
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace umbra78::tools::study {

using CostAndError = std::pair<double, double>;

// Indices of the front, cheapest first, its errors falling strictly; of equal points the first.
// Points that are not numbers are never on it.
std::vector<std::size_t> pareto_front(std::span<const CostAndError>);

// Of a front: the index (into the front) farthest below the straight line between its ends, both
// coordinates as logarithms, errors no less than `least_error`. 0 for one point.
std::size_t knee_of(std::span<const CostAndError> points, std::span<const std::size_t> front,
                    double min_error);

}  // namespace umbra78::tools::study
