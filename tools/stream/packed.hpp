// Packed files (.u78p): primitives in the machine's words, in a form that is read as it comes.
//
// All numbers are little-endian; an i32 of a place is a world word, Q15.16, within -32767 .. 32767.
//
//   "U78PACK1"               8 bytes
//   u64 primitives           their number, or 2^64 - 1 where the writer does not know it
//   u32 materials            their number, 1 .. 65535
//   i32 x 3                  of each material: diffuse and specular 0 .. 255, shininess 0 .. 8
//   blocks, each:
//     u32 kind               1 patches, 2 triangles, 0 the end; 1 and 2 in any order
//     u32 records            1 .. 1024; 0 at the end
//     the records
//   a patch                  48 i32: control points (i, j) at 4 j + i, x y z; u32 material
//   a triangle               9 i32: three corners, x y z; 9 i16: the normal at each; u16 material
//
// Materials are numbered from 0. A triangle's normals are unit vectors in Q1.14, as long as 16380
// to 16388, or all three are 0 and it is flat. Primitives without area are allowed. Nothing follows
// the end. A file that ends before its end, or holds another number of primitives than it says, is
// an error. A reader needs the memory of one block.
#pragma once

#include "tools/io/files.hpp"
#include "tools/stream/stream.hpp"

#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

namespace umbra78::tools {

inline constexpr std::size_t max_packed_records = 1024;

// Writes primitives as they are added.
class PackedWriter {
public:
    PackedWriter(const Path&, std::span<const raster::Material>, std::uint64_t count);

    void add(const raster::Surfaces&);
    // Writes the end. Throws if another number of primitives was added than was said.
    void commit();
    std::uint64_t written() const { return written_; }

private:
    enum class Kind : std::uint32_t { end, patches, triangles };
    template <class Record>
    void add(Kind, std::size_t count, Record&& record);
    void flush();

    LongFile file_;
    std::uint64_t count_, written_ = 0;
    std::vector<std::byte> block_;
};

// Opens a packed file; "-" is standard input. What cannot be rewound is copied first, if `spool`
// says so, to a temporary file in TMPDIR, which is gone when the stream is.
OpenedStream open_packed(const std::string& path, bool spool);

// A packed file that is open, and closed with the stream. `name` is what errors call it.
OpenedStream open_packed(std::FILE*, const std::string& name, bool can_rewind);

}  // namespace umbra78::tools
