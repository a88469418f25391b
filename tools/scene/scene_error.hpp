// The exception for a wrong scene: one line that says where and what is wrong, and the remedy.
// Code that is compiled without exceptions calls read_scene() instead, which reports the same line.
#pragma once

#include <stdexcept>

namespace umbra78::tools {

struct SceneError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace umbra78::tools
