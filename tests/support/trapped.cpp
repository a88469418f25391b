// What a test program does at a broken precondition: it prints the reason before the trap
// instruction stops it, so that a death test can look for it; or it throws, as a binding would,
// while throw_when_trapped is set.
#include "tests/support/trapped.hpp"

#include <cstdio>
#include <stdexcept>

namespace umbra78 {
bool throw_when_trapped = false;
}

extern "C" void umbra78_trapped(const char* why) {
    if (umbra78::throw_when_trapped) throw std::logic_error(why);
    std::fprintf(stderr, "umbra78: internal error: %s\n", why);
}
