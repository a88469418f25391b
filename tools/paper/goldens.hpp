// Goldens: what every stage of figures 1 to 6 must be, as PGM pictures and as hashes.
//
// A folder holds `<buffer>.pgm` for each buffer and `hashes.txt`, lines of "buffer hash". The
// pictures are there so that a difference can be seen, the hashes so that another program can be
// held to them without a picture.
#pragma once

#include "tools/io/buffers.hpp"

#include <map>
#include <span>
#include <string>
#include <vector>

namespace umbra78::tools {

using Hashes = std::map<std::string, std::string>;

Hashes read_hashes(const Path& folder);  // empty where there is no hashes.txt
void bless(const Path& folder, std::span<const Buffer>, FileSet&);

struct GoldenCheck {
    std::string buffer;
    std::string problem;  // one line; empty where the buffer is its golden
    std::vector<std::uint8_t> picture;  // rgb, where pixels differ
};
// One check a buffer. Throws where the folder holds no goldens at all.
std::vector<GoldenCheck> check(const Path& folder, std::span<const Buffer>);

}  // namespace umbra78::tools
