// The values of a PLY file in their order, as text or binary.
#pragma once

#include "tools/models/ply_header.hpp"

#include <memory>

namespace umbra78::tools {

// What is wrong is reported; then values are 0, and are not to be used.
class PlyValues {
public:
    virtual ~PlyValues() = default;

    // Before the values of an element: its number, from 0 on. As text an element begins a line.
    virtual void begin(const PlyElement&, std::uint64_t number) = 0;
    // What a point that is read now has as its `line`: that, or the element's number.
    virtual int line() const = 0;

    virtual std::int64_t coordinate(Scalar) = 0;
    virtual std::int64_t whole(Scalar) = 0;  // of a type that is not floating
    virtual void skip(Scalar, std::uint64_t count) = 0;
    // Reports what follows the last element.
    virtual void end() = 0;
    // Reports what is wrong with the element that is read now.
    virtual void report(const std::string& what) = 0;
};

// The model, whose name is the file's, the error and the header outlive it.
std::unique_ptr<PlyValues> ply_values(const PlyHeader&, ModelData&, FirstError&);

}  // namespace umbra78::tools
