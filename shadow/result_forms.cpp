// The table of the forms of a line's transform: result_body.hpp by instruction sets.
#include "shadow/result_form.hpp"

namespace umbra78::shadow {

#define UMBRA78_LANES_TEXT "shadow/result_body.hpp"
#include "fixed/lane_sets.hpp"

namespace {
#define UMBRA78_RESULT_FORM(set, name) {name, set::supported, set::results_form},
constexpr ResultForm result_table[] = {UMBRA78_LANE_SETS(UMBRA78_RESULT_FORM)};
#undef UMBRA78_RESULT_FORM
}  // namespace

std::span<const ResultForm> result_forms() { return result_table; }

const ResultForm& result_form_for(std::string_view row_form) {
    for (const ResultForm& form : result_table)
        if (form.name == row_form && form.supported()) return form;
    return result_table[0];
}

}  // namespace umbra78::shadow
