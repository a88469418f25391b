// The 16 numbers of a matrix: on the command line, in a text file, or in an NPY.
//
// In a text blanks, commas, semicolons, brackets and ends of lines divide numbers, and # begins a
// remark.
#pragma once

#include "tools/captured/conventions.hpp"

#include <string>

namespace umbra78::tools::captured {

// `given` is the numbers, or the path of a file. Throws SceneError.
Matrix16 read_matrix(const std::string& given);

}  // namespace umbra78::tools::captured
