// What the study of error against run time makes of its rows.
#pragma once

#include "tools/study/study.hpp"

namespace umbra78::tools::study {

// Fronts of the errors against the host's and the machine's time, what lies on them, and which
// setting to take for speed, for least error, and between.
void report_error_time(const Request&, std::span<const Row>, Report&);

// "9 bits, bilinear, normal dither, filtered": the settings that tell the rows apart.
std::string short_name(const Row&, std::span<const Row> all);

}  // namespace umbra78::tools::study
