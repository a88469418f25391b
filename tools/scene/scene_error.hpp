// What is wrong with a scene or a setting: one line for the user.
#pragma once

#include <stdexcept>

namespace umbra78::tools {

// what() is one line: where, what, and the remedy.
struct SceneError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace umbra78::tools
