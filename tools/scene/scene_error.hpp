// A FirstError as an exception: one line that says where and what is wrong, and the remedy. The
// program throws it; reading without exceptions is read_scene().
#pragma once

#include <stdexcept>

namespace umbra78::tools {

struct SceneError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace umbra78::tools
