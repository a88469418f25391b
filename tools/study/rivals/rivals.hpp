// The parts of the study of rivals: Crow's classes and the depth map, side by side.
#pragma once

#include "tools/study/measures.hpp"
#include "tools/study/study.hpp"

#include <memory>
#include <span>
#include <string_view>

namespace umbra78::tools::study {

// What is varied: how finely curved surfaces are diced, or the picture's resolution.
inline constexpr std::string_view by_dicing = "dicing", by_resolution = "resolution";

std::unique_ptr<Study> make_rivals_study();

void report_rivals(const Request&, std::span<const Row>, Report&);

// Of log y over log x, by least squares; NaN with fewer than two different x.
struct PowerLaw {
    double exponent, factor;
    double from, to;  // the range of x
};
PowerLaw power_law(std::span<const std::pair<double, double>> points);

}  // namespace umbra78::tools::study
