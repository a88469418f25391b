#include "tools/study/contours/roughness.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace umbra78::tools::study {
namespace {

// Weighted sums over the places of a window, of s (along the edge) and d (away from it).
struct Window {
    double weight = 0, s = 0, d = 0, ss = 0, sd = 0, dd = 0;

    void add(double w, double along, double away) {
        weight += w;
        s += w * along;
        d += w * away;
        ss += w * along * along;
        sd += w * along * away;
        dd += w * away * away;
    }
    double mean() const { return d / weight; }
    // The weighted sum of the squared distances from the line of least squares.
    double residual() const {
        const double var_s = ss - s * s / weight, cov = sd - s * d / weight;
        const double var_d = dd - d * d / weight;
        return std::max(var_d - (var_s > 0 ? cov * cov / var_s : 0), 0.0);
    }
};

}  // namespace

Roughness roughness(std::span<const ShadowEdge> exact, std::span<const Contour> drawn, int size) {
    Roughness result;
    std::vector<std::vector<Window>> windows;
    std::vector<double> window_length;
    for (const ShadowEdge& edge : exact) {
        const double px = length(edge.line);
        const auto count = std::max<std::size_t>(1, std::lround(px / window_px));
        windows.emplace_back(count);
        window_length.push_back(px / static_cast<double>(count));
        result.of[static_cast<std::size_t>(edge.kind)].exact_px += px;
    }
    const NearestEdge nearest(exact, size, reach_px);
    for (const Contour& line : drawn) {
        for (std::size_t k = 1; k < line.size(); ++k) {
            const double px = pixels_between(line[k - 1], line[k]);
            const auto at = nearest(between(line[k - 1], line[k], 0.5));
            if (!at) {
                result.stray_px += px;
                continue;
            }
            EdgeRoughness& kind = result.of[static_cast<std::size_t>(exact[at->edge].kind)];
            kind.drawn_px += px;
            kind.max_px = std::max(kind.max_px, std::abs(at->distance));
            auto& of_edge = windows[at->edge];
            const double number = window_length[at->edge] > 0
                                      ? at->along / window_length[at->edge] : 0;
            of_edge[std::min(static_cast<std::size_t>(number), of_edge.size() - 1)].add(
                px, at->along, at->distance);
        }
    }
    std::array<Window, 2> residuals, means;  // of each kind, over its windows
    for (std::size_t edge = 0; edge < exact.size(); ++edge) {
        for (const Window& w : windows[edge]) {
            if (w.weight <= 0) continue;
            const auto kind = static_cast<std::size_t>(exact[edge].kind);
            residuals[kind].weight += w.weight;
            residuals[kind].dd += w.residual();
            means[kind].add(window_length[edge], 0, w.mean());
        }
    }
    for (std::size_t kind = 0; kind < 2; ++kind) {
        EdgeRoughness& r = result.of[kind];
        r.length_ratio = r.drawn_px / r.exact_px;
        r.rms_px = std::sqrt(residuals[kind].dd / residuals[kind].weight);
        r.displacement_px = means[kind].mean();
        r.displacement_rms_px = std::sqrt(means[kind].dd / means[kind].weight);
    }
    return result;
}

}  // namespace umbra78::tools::study
