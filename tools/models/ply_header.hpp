// The header of a PLY file: lines of text, whatever form the data have.
//
//   ply
//   format ascii 1.0                         or binary_little_endian, binary_big_endian
//   comment ...  obj_info ...                skipped
//   element NAME COUNT
//   property TYPE NAME                       of the element above it
//   property list TYPE TYPE NAME             a count of the first type, as many of the second
//   end_header
//
// Types: char uchar short ushort int uint float double, or int8 uint8 int16 uint16 int32 uint32
// float32 float64.
#pragma once

#include "tools/io/first_error.hpp"
#include "tools/models/scalars.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace umbra78::tools {

enum class PlyFormat : std::uint8_t { ascii, little_endian, big_endian };

struct PlyProperty {
    std::string_view name;  // in the file
    Scalar type;
    bool is_list = false;
    Scalar count_type{};  // of a list
};

struct PlyElement {
    std::string_view name{};
    std::uint64_t count = 0;
    int line = 0;
    std::vector<PlyProperty> properties{};
};

struct PlyHeader {
    PlyFormat format = PlyFormat::ascii;
    std::vector<PlyElement> elements;
    std::string_view data;  // what follows the header
    int data_line = 1;

    const PlyElement* find(std::string_view name) const;  // null if there is none
};

// After an error not to be used. `name` is the file's.
PlyHeader read_ply_header(std::string_view text, const std::string& name, FirstError&);

}  // namespace umbra78::tools
