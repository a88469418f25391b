// Grids: the cases of a study as combinations of the values of several keys.
#pragma once

#include "tools/study/request.hpp"

#include <span>
#include <string_view>
#include <vector>

namespace umbra78::tools::study {

// All combinations of the values, the first key slowest. A key of --vary has the values of --vary
// in place of the defaults; keys that are only in --vary come last.
std::vector<Case> grid(const Request&, std::vector<GridKey> defaults);

// The cases of the first list, then those of `more` that are not among them. The time is linear in
// the number of cases.
std::vector<Case> joined(std::vector<Case> first, const std::vector<Case>& more);

// A study may vary one key at a time, each of its `own` keys in a sweep of its own. This is the
// request for the sweep of `keys`: a key of `own` that --vary gives several values is left out of
// the other keys' sweeps, so that the sweeps are not multiplied with one another.
Request for_sweep(Request, std::span<const std::string_view> own,
                  std::span<const std::string_view> keys);

}  // namespace umbra78::tools::study
