#include "tools/study/pareto.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace umbra78::tools::study {

std::vector<std::size_t> pareto_front(std::span<const CostAndError> points,
                                      double cost_noise) {
    std::vector<std::size_t> order;
    for (std::size_t k = 0; k < points.size(); ++k)
        if (std::isfinite(points[k].first) && std::isfinite(points[k].second)) order.push_back(k);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return points[a] < points[b]; });
    std::vector<std::size_t> front;
    double min = std::numeric_limits<double>::infinity();
    for (const std::size_t k : order) {
        if (!(points[k].second < min)) continue;
        min = points[k].second;
        front.push_back(k);
    }
    // From the least error down in cost, so that each point is compared with one that stays.
    std::vector<std::size_t> kept;
    for (auto k = front.rbegin(); k != front.rend(); ++k)
        if (kept.empty() || points[kept.back()].first > points[*k].first * (1 + cost_noise))
            kept.push_back(*k);
    std::reverse(kept.begin(), kept.end());
    return kept;
}

std::size_t knee_of(std::span<const CostAndError> points, std::span<const std::size_t> front,
                    double min_error) {
    if (front.empty()) return 0;
    const auto place = [&](std::size_t k) {
        const auto [cost, error] = points[front[k]];
        return CostAndError{std::log(cost), std::log(std::max(error, min_error))};
    };
    const CostAndError first = place(0), last = place(front.size() - 1);
    std::size_t knee = 0;
    double deepest = 0;
    for (std::size_t k = 1; k + 1 < front.size(); ++k) {
        const CostAndError here = place(k);
        const double below = (last.first - first.first) * (first.second - here.second) -
                             (first.second - last.second) * (here.first - first.first);
        if (below > deepest) deepest = below, knee = k;
    }
    return knee;
}

}  // namespace umbra78::tools::study
