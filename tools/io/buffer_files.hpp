// Files of a frame's buffers, and the first place where a buffer and a file differ.
#pragma once

#include "tools/io/buffers.hpp"
#include "tools/io/files.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace umbra78::tools {

// PGM of one byte a value up to maxval 255, else of two. Z of more than 16 bits keeps its upper
// 16; NPY keeps everything.
void write_pgm(const Path&, const Buffer&, FileSet* set = nullptr);
void write_npy(const Path&, const Buffer&, FileSet* set = nullptr);

// Where a buffer is not what was expected.
struct Difference {
    int x, y;  // the first in reading order
    std::uint32_t expected, actual;
    std::size_t pixels;  // that differ
};
std::optional<Difference> compare(const Pgm& expected, const Buffer& actual);

// The buffer in gray, the pixels that differ in red; rgb, three bytes a pixel.
std::vector<std::uint8_t> difference_picture(const Pgm& expected, const Buffer& actual);

}  // namespace umbra78::tools
