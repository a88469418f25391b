// The studies of this program, in the order in which the documentation has them.
//
// To add a study: a folder in tools/study/ with a make_..._study(), a line here, a line in
// study_list.cpp, and an umbra78_room() in CMakeLists.txt.
#pragma once

#include "tools/study/study.hpp"

namespace umbra78::tools::study {

Studies studies();

// Defined in the studies' own folders.
std::unique_ptr<Study> make_error_time_study();
std::unique_ptr<Study> make_bias_study();
std::unique_ptr<Study> make_widths_study();
std::unique_ptr<Study> make_moire_study();
std::unique_ptr<Study> make_contours_study();
std::unique_ptr<Study> make_growth_study();
std::unique_ptr<Study> make_motion_study();
std::unique_ptr<Study> make_lights_study();
std::unique_ptr<Study> make_rivals_study();
std::unique_ptr<Study> make_precision_study();
std::unique_ptr<Study> make_stability_study();

}  // namespace umbra78::tools::study
