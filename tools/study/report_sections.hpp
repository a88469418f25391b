// A report once for each combination of what the user varies and the study does not.
//
// With `--vary light.azimuth=-100,-60`, a study of the bias answers for each azimuth in a section
// of its own: its rows, plots and answers are not mixed with those of another azimuth.
#pragma once

#include "tools/study/report.hpp"
#include "tools/study/request.hpp"
#include "tools/study/row.hpp"

#include <functional>
#include <span>
#include <string_view>

namespace umbra78::tools::study {

using WriteSection = std::function<void(std::span<const Row>, Report&)>;

// Calls `write` with the rows of each combination of the keys of --vary that have several values
// and are not among `own`, the keys that the study itself distinguishes. Where there is more than
// one combination, each begins with a heading that names it, its plots' files end in its number,
// and its answers are in summary()["combinations"].
void write_sections(const Request&, std::span<const std::string_view> own, std::span<const Row>,
                    Report&, const WriteSection& write);

}  // namespace umbra78::tools::study
