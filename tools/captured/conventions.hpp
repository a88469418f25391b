// What the numbers of a captured depth buffer and of its matrix mean.
//
// A matrix takes a pixel's place in the observer's normalized device coordinates, with the depth
// that is stored there, to the light's clip coordinates:
//
//   (x, y, z, 1) of the observer  --M-->  (x, y, z, w) of the light, whose place is x/w, y/w, z/w
//   M = light's view-projection times the inverse of the observer's
//
// x is -1 at the left edge of the picture and 1 at the right one, and a pixel's place is its
// centre. Interfaces differ in the rest, and a Convention says it.
#pragma once

#include "hw/machine_spec.hpp"
#include "hw/transform_unit.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace umbra78::tools::captured {

struct Convention {
    std::string_view name;
    bool y_up = true;               // y is 1 at the top of the picture, else at its bottom
    bool z_from_minus_one = false;  // z is -1 .. 1 and stored as (z + 1)/2; else it is stored as is
    bool first_row_on_top = true;   // of the files
    bool row_vectors = false;       // the vector stands before the matrix: p' = p M
};
// d3d (Metal's and WebGPU's, too), vulkan, opengl. Null if there is none of that name.
std::span<const Convention> conventions();
const Convention* find_convention(std::string_view name);

// How a depth is stored. `codes` is this machine's own: code / 2^z_bits.
struct DepthFormat {
    std::string_view name;
    int unorm_bits;   // of a normalized integer, code / (2^n - 1); 0: the others
    bool real;        // a float
    bool reversed;    // 1 is near and 0 far
    bool own() const { return unorm_bits == 0 && !real; }
};
std::span<const DepthFormat> depth_formats();
const DepthFormat* find_depth_format(std::string_view name);
std::string names_of_depth_formats();  // "codes, d16, ..."

// A depth buffer's size; it lies in the upper left corner of the machine's square frame.
struct Sides {
    int width = 0, height = 0;
};

// The code that means the far plane's depth: 2^z_bits, or of a normalized integer 2^z_bits - 1.
std::int64_t far_code(const DepthFormat&, const hw::MachineSpec&);

// 16 numbers, row by row as they were given.
using Matrix16 = std::array<double, 16>;

// M between the two screens of the machine, exactly: pixels from the frame's centre, X right, Y
// down, Z away, as raster::observer_to_light() has them. The bias, in quanta with 16 fraction bits,
// is taken from Z.
hw::RationalMatrix screen_to_screen(const Matrix16&, const Convention&, const DepthFormat&,
                                    Sides observer, Sides light, const hw::MachineSpec&,
                                    std::int64_t bias_q16);

// What is wrong with a matrix, and the remedy; "" if nothing is.
std::string wrong_with(const Matrix16&, const Convention&);

}  // namespace umbra78::tools::captured
