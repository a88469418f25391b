// Wavefront OBJ: vertices, normals and polygons. See model.hpp.
#pragma once

#include "tools/io/first_error.hpp"
#include "tools/models/model.hpp"

namespace umbra78::tools {

// Appends the triangles of a file's faces, and the vertices and normals that they use, to the
// model. A face whose corners do not all name a normal has none. Lines and points are counted, what
// tells of names, materials and textures is skipped, and what is unknown is refused.
void read_obj(std::string_view text, ModelData&, FirstError&);

}  // namespace umbra78::tools
