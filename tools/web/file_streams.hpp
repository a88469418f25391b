// Before a source that names file streams, which libc++ leaves out where there are no files:
// toml++'s parse_file() opens one, and nobody here calls it.
#pragma once

#include <__config>
#undef _LIBCPP_HAS_NO_FILESYSTEM
#include <fstream>
