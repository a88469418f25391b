// The tests' hook for broken preconditions (fixed/trap.hpp), which every test program has.
#pragma once

#include "fixed/trap.hpp"

namespace umbra78 {

// While set, a broken precondition throws std::logic_error with its reason.
extern bool throw_when_trapped;

}  // namespace umbra78
