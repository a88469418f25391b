// Goldens: the buffer that every stage of figures 1 to 6 must produce, and the pictures of figures
// 7 and 8 and of the gallery, as PGM pictures and hashes.
//
// A folder holds `<buffer>.pgm` for each buffer and `hashes.txt` with lines of "buffer hash". The
// pictures show where a buffer differs; the hashes are for programs that do not read pictures.
#pragma once

#include "tools/io/buffer_files.hpp"

#include <map>
#include <span>
#include <string>
#include <vector>

namespace umbra78::tools {

using Hashes = std::map<std::string, std::string>;

Hashes read_hashes(const Path& folder);  // empty if there is no hashes.txt
// Keeps the goldens of buffers that are not there, such as a scene that was left out.
void bless(const Path& folder, std::span<const Buffer>, FileSet&);

struct GoldenCheck {
    std::string buffer;
    std::string problem;  // one line; empty if the buffer equals its golden
    std::vector<std::uint8_t> picture;  // rgb, where pixels differ
};
// Throws std::runtime_error if the folder holds no goldens at all.
void require_goldens(const Path& folder);

// One check for each buffer; require_goldens() among them.
std::vector<GoldenCheck> check(const Path& folder, std::span<const Buffer>);

}  // namespace umbra78::tools
