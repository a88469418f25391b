// The parts of the study of error against run time: the figures of a row, and the report.
#pragma once

#include "tools/render/render_job.hpp"
#include "tools/study/study.hpp"
#include "tools/study/truth_cache.hpp"

namespace umbra78::tools::study {

// Hashes, errors, memory, and the cycles by each profile that could run the case. The job has the
// same settings afterwards. Errors are empty cells where `Traced` is null.
Row error_time_row(const LoadedScene&, RenderJob& drawn, const Traced*);

// For each error and cost (this computer's time, the machine's time): the Pareto front, which
// setting to take for speed, for the least error, and between.
void report_error_time(const Request&, std::span<const Row>, Report&);

// "9 bits, bilinear, normal dither, low-passed": the settings in which the row differs from others.
std::string short_name(const Row&, std::span<const Row> all);

}  // namespace umbra78::tools::study
