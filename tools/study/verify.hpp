// Renders rows of a study's CSV again, by their settings, and compares every figure except host
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

// `sample` rows, drawn with a fixed seed, or all rows if there are fewer. NAME.json must be beside
// the CSV, because it holds the scene. Throws std::runtime_error.
Verified verify(const Path& csv, std::size_t sample, Studies);

}  // namespace umbra78::tools::study
