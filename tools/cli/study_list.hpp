// The studies of this program, in the order of the documentation. A new study is a folder of
// tools/study/ and a line here and in study_list.cpp.
#pragma once

#include "tools/study/study.hpp"

namespace umbra78::tools::study {

Studies studies();

// Each is made by its own folder.
std::unique_ptr<Study> make_error_time_study();
std::unique_ptr<Study> make_bias_study();
std::unique_ptr<Study> make_widths_study();
std::unique_ptr<Study> make_moire_study();
std::unique_ptr<Study> make_precision_study();
std::unique_ptr<Study> make_stability_study();

}  // namespace umbra78::tools::study
