// The curved surfaces of an OBJ file: bicubic Bezier and B-spline surfaces, as patches.
//
//   cstype bezier | bspline      deg 3 3      surf s0 s1 t0 t1 v v v ...
//   parm u p p p ...             parm v p p p ...             end
//
// Points come row by row, u fastest. In each direction a Bezier surface of m patches has m + 1
// parameters and 3 m + 1 points, a B-spline surface of n points n + 4 knots. s0 .. t1 is the whole
// of it. A point of a B-spline's patch is the exact mean of 16 points, rounded once, half to even,
// to its word. Parameters are decimals of up to nine places.
#pragma once

#include "tools/models/obj_corner.hpp"

#include <string_view>
#include <vector>

namespace umbra78::tools {

class ObjSurfaces {
public:
    ObjSurfaces(const std::string& name, FirstError& error) : name_(name), error_(error) {}

    // Whether the keyword belongs to curves and surfaces.
    static bool takes(std::string_view keyword);
    // A statement with such a keyword, when so many vertices and normals stand before it. What is
    // no bicubic surface is refused by name: curves, holes, rational surfaces, other orders.
    void read(const std::vector<ModelWord>&, std::size_t vertices, std::size_t normals);

    bool any() const { return !surfaces_.empty(); }
    // Appends the patches of all surfaces, whose vertices are `points`.
    void append_patches(const std::vector<ModelPoint>& points, std::vector<ModelPatch>& patches);

private:
    enum class Kind { none, bezier, bspline };
    struct Surface {
        Kind kind = Kind::none;
        int line = 0;
        bool ended = false;
        std::array<std::int64_t, 4> range{};  // s0, s1, t0, t1 in units of 10^-9, as what follows
        std::array<std::vector<std::int64_t>, 2> parameters{};  // of u and v
        std::vector<ObjCorner> corners{};
    };

    void report(int line, const std::string& what) { report_at(error_, name_, line, what); }
    void read_type(const std::vector<ModelWord>&);
    void read_degree(const std::vector<ModelWord>&);
    void read_surface(const std::vector<ModelWord>&, std::size_t vertices, std::size_t normals);
    void read_parameters(const std::vector<ModelWord>&);
    std::int64_t read_parameter(const ModelWord&);
    std::size_t points_along(const Surface&, std::size_t direction);
    void append_bezier(const std::vector<ModelPoint>&, std::size_t, std::size_t,
                       std::vector<ModelPatch>&);
    void append_bspline(const Surface&, const std::vector<ModelPoint>&,
                        std::vector<ModelPatch>&);

    const std::string& name_;
    FirstError& error_;
    Kind kind_ = Kind::none;
    bool bicubic_ = false;
    std::vector<Surface> surfaces_;
};

}  // namespace umbra78::tools
