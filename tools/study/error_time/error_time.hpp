// The parts of the study of error against run time: a row's figures, and what is made of all.
#pragma once

#include "tools/render/render_job.hpp"
#include "tools/study/study.hpp"
#include "tools/study/truth_cache.hpp"

namespace umbra78::tools::study {

// Hashes, errors, cycles by each profile that applies, memory. The job keeps its settings.
Row error_time_row(const LoadedScene&, RenderJob& drawn, const Traced*);

// Fronts of the errors against the host's and the machine's time, what lies on them, and which
// setting to take for speed, for least error, and between.
void report_error_time(const Request&, std::span<const Row>, Report&);

// "9 bits, bilinear, normal dither, filtered": the settings that tell the rows apart.
std::string short_name(const Row&, std::span<const Row> all);

}  // namespace umbra78::tools::study
