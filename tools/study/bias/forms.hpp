// The bias study's section on bias that follows the surface.
#pragma once

#include "tools/study/study.hpp"

namespace umbra78::tools::study {

// A table and a plot of the least constant bias beside each form; nothing of no rows.
void report_forms(std::span<const Row>, Report&);

}  // namespace umbra78::tools::study
