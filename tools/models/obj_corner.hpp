// A corner of an OBJ file's face or surface: v, v/t, v//n or v/t/n.
#pragma once

#include "tools/models/words.hpp"

namespace umbra78::tools {

// Numbers from 0 in the file's order. A file may name what follows, so whether they exist is asked
// when all is read: point_at().
struct ObjCorner {
    static constexpr std::int64_t none = -1;
    std::int64_t vertex = 0, normal = none;
    int line = 0;
};

// Numbers in the file count from 1, or from the last of those known so far down from -1.
ObjCorner read_corner(const ModelWord&, std::size_t vertices, std::size_t normals,
                      const std::string& name, FirstError&);

// Point `number` of `all`, which errors call `what`: "vertex". Reports one that does not exist;
// then it is a point at the origin.
ModelPoint point_at(const std::vector<ModelPoint>& all, std::int64_t number, const char* what,
                    int line, const std::string& name, FirstError&);

}  // namespace umbra78::tools
