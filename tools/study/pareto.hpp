// Pareto fronts: the points that no other point beats in both coordinates, less being better.
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace umbra78::tools::study {

using CostAndError = std::pair<double, double>;

// Indices of the front's points, cheapest first, with strictly falling errors; of equal points the
// first. Points with a NaN or an infinity are never on it.
//
// `cost_noise` is the share of a cost by which two measurements of it differ. Costs that differ by
// no more count as equal: a point is left out if a point of the front has less error and costs at
// most (1 + cost_noise) times as much. So neighbours on the front differ by more than the noise.
std::vector<std::size_t> pareto_front(std::span<const CostAndError>, double cost_noise = 0);

// The index into the front of the point farthest below the straight line between the front's ends,
// both coordinates as logarithms; errors below `min_error` count as `min_error`. 0 if no point is
// below the line.
std::size_t knee_of(std::span<const CostAndError> points, std::span<const std::size_t> front,
                    double min_error);

}  // namespace umbra78::tools::study
