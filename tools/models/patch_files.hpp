// The three formats that hold Bezier patches alone. See model.hpp.
#pragma once

#include "tools/io/first_error.hpp"
#include "tools/models/model.hpp"

namespace umbra78::tools {

// Each appends the patches of a file to the model, whose name is the file's. After an error they
// are not to be used. Degenerate patches are taken as they are.

// The number of patches, and for each its two orders, which must be 3 3, and 16 points.
void read_bpt(std::string_view text, ModelData&, FirstError&);

// Geomview: a header, then the points of any number of patches. BBP, BEZ333 and their forms with
// colours (C...) and texture coordinates (ST..., ..._ST), which are skipped.
void read_bez(std::string_view text, ModelData&, FirstError&);

// Newell's tea set: patches as vertex numbers, then the vertices.
void read_tea(std::string_view text, ModelData&, FirstError&);

}  // namespace umbra78::tools
