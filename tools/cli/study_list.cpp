#include "tools/cli/study_list.hpp"

namespace umbra78::tools::study {

Studies studies() {
    static const auto all = [] {
        std::vector<std::unique_ptr<Study>> made;
        made.push_back(make_error_time_study());
        made.push_back(make_bias_study());
        made.push_back(make_widths_study());
        made.push_back(make_moire_study());
        made.push_back(make_contours_study());
        made.push_back(make_growth_study());
        made.push_back(make_motion_study());
        made.push_back(make_lights_study());
        made.push_back(make_rivals_study());
        made.push_back(make_precision_study());
        made.push_back(make_stability_study());
        return made;
    }();
    return all;
}

}  // namespace umbra78::tools::study
