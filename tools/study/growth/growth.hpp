// The parts of the study of growth: what is measured of a landscape, and the line through it.
#pragma once

#include "tools/study/study.hpp"
#include "tools/stream/hills.hpp"

#include <cstdint>
#include <span>
#include <utility>

namespace umbra78::tools::study {

// The frame of these hills, streamed; its bits and costs. One at a time, so that neither times nor
// memory are those of two.
Row growth_row(const HillsShape&, bool host_times);

// y = fixed + slope x, so that the sum of the squares of the deviations, each as a share of its y,
// is least: a scene of a hundred patches counts as much as one of a million.
struct Line {
    double fixed = 0, slope = 0;
    double worst = 0;  // the greatest deviation as a share of y
};
Line line_through(std::span<const std::pair<double, double>> points);

}  // namespace umbra78::tools::study
