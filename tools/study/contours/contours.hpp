// The study of contours: its limits, and how passes are chosen within them.
#pragma once

#include "tools/study/study.hpp"

#include <array>
#include <optional>

namespace umbra78::tools::study {

// The limits within which passes are chosen; they were set before the study was first run. The
// filters may move a cast shadow's edge by at most a quarter of a pixel (rms over windows, more
// than unfiltered), and take from a bar of shadow of these widths at most these shares of it.
inline constexpr double max_moved_px = 0.25;
struct WidthLimit {
    int width_px;
    double max_lost;
};
inline constexpr std::array<WidthLimit, 3> width_limits{{{2, 0.5}, {4, 0.25}, {8, 0.125}}};

// A setting of the filters, of its row in the study: `error` is the roughness that is chosen by.
struct PassesAndError {
    int dequantize, low_pass;
    double error;
    int passes() const { return dequantize + low_pass; }
};

// For each number of passes the one with the least error; only no pass at all, and settings with a
// pass of either filter, as the paper's figure 5 has.
std::vector<PassesAndError> least_by_passes(std::span<const PassesAndError>);

// The knee of that curve: the point farthest below the straight line from its first point to its
// least error, both axes scaled to 0..1. Points whose distances differ by less than a hundredth are
// equal, and the one with more passes is taken, which is smoother. Nothing for under three points.
std::optional<PassesAndError> knee_of_passes(std::span<const PassesAndError> least);

void report_contours(const Request&, std::span<const Row>, Report&);

}  // namespace umbra78::tools::study
