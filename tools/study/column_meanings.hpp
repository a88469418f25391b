// What the columns of a study's CSV mean: the table at the end of its page.
#pragma once

#include "tools/study/study.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace umbra78::tools::study {

// The meaning of a column: the study's own, the framework's (case, name, status, ...), or that it
// is a setting or an override of the scene. Nothing if nobody says what it means.
std::optional<std::string> meaning_of(std::string_view column, const Study&);

// A line for each column of the row that is not a setting; "name" and "meaning" are the head.
TableCells column_table(const Row&, const Study&);

}  // namespace umbra78::tools::study
