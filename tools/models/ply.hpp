// PLY, the Stanford polygon format, as text or binary of either byte order. See model.hpp.
//
// What is read: the element vertex with x, y, z and, if it has all three, the normal nx, ny, nz;
// the element face with a list vertex_indices or vertex_index of the vertices' numbers, from 0 on.
// All other elements and properties are skipped. The header is described in ply_header.hpp.
#pragma once

#include "tools/io/first_error.hpp"
#include "tools/models/model.hpp"

namespace umbra78::tools {

// Appends the triangles of the file's faces, and the vertices and normals that they use, to the
// model. Errors name the line, or in a binary file the element and its number, from 0 on as in the
// file's own lists. What the header counts is not believed before it has been read.
void read_ply(std::string_view text, ModelData&, FirstError&);

}  // namespace umbra78::tools
