// What the filters and the composite cost, in operations (hw/operations.hpp).
//
// The constants are the last five rows of the table in hw/MACHINE.md, section 16; they count the
// additions, products and quotients of the formulas in its sections 13 and 23.
#pragma once

#include "hw/operations.hpp"

#include <cstddef>
#include <cstdint>

namespace umbra78::shadow::cost {

using hw::Operations;

// Dequantizing, for each step of the chain. The step is found by four reads. Each of q passes
// averages X and Y (6 additions). Every second step crosses sixteen sub-rows: so eight crossings
// a step, each a product, a quotient of 16 bits, and two cells that are read and written.
constexpr Operations chain_step(int passes) {
    const auto q = static_cast<std::uint64_t>(passes);
    return {.adds = 6 + 6 * q + 8 * 6,
            .products = 8,
            .passes = 8,
            .quotients = 8,
            .quotient_bits = 8 * 16,
            .accesses = 4 + 8 * 4};
}

// For each pixel of the frame: the sum along the row, scaled to 0..255.
inline constexpr Operations coverage_pixel{
    .adds = 3, .products = 1, .passes = 1, .quotients = 0, .quotient_bits = 0, .accesses = 2};

// For each pixel and pass.
inline constexpr Operations low_pass_pixel{
    .adds = 12, .products = 0, .passes = 0, .quotients = 0, .quotient_bits = 0, .accesses = 10};

// For each pixel of a source of n lights: their masks are read and counted, the share is written.
constexpr Operations join_pixel(std::size_t lights) {
    return {.adds = lights + 1, .products = 1, .passes = 1, .quotients = 1, .quotient_bits = 8,
            .accesses = lights + 1};
}

// For each pixel of a source with a ramp of w pixels: two steps along its column, the least of
// 2 w - 1 squares along its line (their two terms are tables), the ramp's level from a table.
constexpr Operations ramp_pixel(int width) {
    const auto w = static_cast<std::uint64_t>(width);
    return {.adds = 4 + 2 * (2 * w - 1), .products = 0, .passes = 0, .quotients = 0,
            .quotient_bits = 0, .accesses = 4 + 2 * w + 1};
}

// For each pixel, source and channel: picture, direct share and mask read, the picture written.
inline constexpr Operations composite_pixel{
    .adds = 2, .products = 2, .passes = 2, .quotients = 1, .quotient_bits = 10, .accesses = 4};

}  // namespace umbra78::shadow::cost
