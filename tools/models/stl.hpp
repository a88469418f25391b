// STL: triangles, as text or binary. See model.hpp.
//
//   text     solid NAME
//              facet normal X Y Z
//                outer loop  vertex X Y Z  (three times)  endloop
//              endfacet  ...
//            endsolid NAME                     words in any case; one solid or more
//   binary   80 bytes, number of triangles as 32 bits, then 50 bytes each: normal and three
//            corners of three floats, and 2 bytes of attributes; little endian
//
// A file whose length is that of its binary form is binary, even if it begins with "solid". An STL
// file has no vertices of its own: corners of the same words become one vertex. The normals that
// it stores are those of facets, which the machine computes itself; they and the attributes are not
// looked at.
#pragma once

#include "tools/io/first_error.hpp"
#include "tools/models/model.hpp"

namespace umbra78::tools {

// Appends the file's triangles to the model. Errors name the line, or in a binary file the
// triangle, counted from 1.
void read_stl(std::string_view text, ModelData&, FirstError&);

}  // namespace umbra78::tools
