// Where the scenes and goldens lie that came with the program: they are found from where it stands,
// so that it may be built in one place, installed in another and moved to a third.
#pragma once

#include "tools/io/files.hpp"

namespace umbra78::tools {

// "scenes" and "goldens" are in it: share/umbra78 in the build folder or beside bin. Throws
// std::runtime_error if it is not there.
Path data_folder();

}  // namespace umbra78::tools
