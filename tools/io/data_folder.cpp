#include "tools/io/data_folder.hpp"

#include <stdexcept>
#include <string>

namespace umbra78::tools {

Path data_folder() {
    std::error_code none;
    const Path program = std::filesystem::read_symlink("/proc/self/exe", none).parent_path();
    for (const Path& above : {program, program.parent_path()}) {
        const Path folder = above / "share" / "umbra78";
        if (std::filesystem::is_directory(folder / "scenes", none)) return folder;
    }
    throw std::runtime_error("cannot find the scenes that came with umbra78: " +
                             (program.parent_path() / "share" / "umbra78").string() +
                             " is not there; install the whole package");
}

}  // namespace umbra78::tools
