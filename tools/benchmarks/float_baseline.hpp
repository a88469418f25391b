// The float baseline: the post-process as one would write it in plain floating point in an hour.
//
// It does the same work on the same buffers (transform, nearest lookup, compare), so that the
// integer machine's time has something to stand beside. It is no truth and no part of a figure.
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace umbra78::tools {

// Observer's (column + 1/2, row + 1/2, Z code) to the light's (column, row, Z code); 4 x 4, row by
// row; `affine` leaves out the fourth row and the division.
struct FloatMatrix {
    std::array<std::array<float, 4>, 4> m;
};

// 255 in shadow, 0 lit or background (65535).
void float_post_process(std::span<const std::uint16_t> observer,
                        std::span<const std::uint16_t> light, int size, const FloatMatrix& matrix,
                        bool affine, std::span<std::uint8_t> mask);

}  // namespace umbra78::tools
