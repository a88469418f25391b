// Renders rows of a study's CSV again, by their settings, and compares every figure but host
// times.
#pragma once

#include "tools/io/files.hpp"
#include "tools/study/study.hpp"

#include <string>
#include <vector>

namespace umbra78::tools::study {

struct Verified {
    std::size_t rows = 0, sampled = 0;
    std::vector<std::string> differences;  // a line each
};

// `sample` rows by a fixed seed, or all of them if there are no more. NAME.json must lie beside
// the CSV: the scene is in it. Throws std::runtime_error.
Verified verify(const Path& csv, std::size_t sample, Studies);

}  // namespace umbra78::tools::study
