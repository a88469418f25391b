// Images of numbers as other programs write them: depth buffers, masks, matrices.
//
// PGM, 8 or 16 bits; NPY of 8, 16 or 32 unsigned bits or of 32- or 64-bit floats, of one or two
// dimensions and any that are 1; PFM, one channel; and raw numbers without a head, whose size and
// kind are told. Every error is a std::runtime_error of one line: the file, what is wrong, what to
// do.
#pragma once

#include "tools/io/destination.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace umbra78::tools {

enum class NumberKind : std::uint8_t { u8, u16, u32, f32, f64 };
constexpr bool is_real(NumberKind kind) { return kind >= NumberKind::f32; }
std::string_view name_of(NumberKind);

struct NumberImage {
    std::string name;  // for messages
    int width = 0, height = 0;
    NumberKind kind = NumberKind::f32;
    std::uint32_t max = 0;  // of whole numbers: the greatest that the file may hold
    // In the file's order; a PFM's, whose rows are upward by its definition, from the top. A double
    // holds numbers of every kind exactly.
    std::vector<double> values;

    std::size_t pixels() const { return static_cast<std::size_t>(width) * height; }
    double at(int x, int y) const {
        return values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(x)];
    }
};

// Of raw numbers, low byte first.
struct RawNumbers {
    int width = 0, height = 0;
    NumberKind kind = NumberKind::f32;
};

// At most 4096 x 4096 numbers. The format is known by the file's first bytes, but where raw numbers
// are told: then only a file that ends with .pgm, .npy or .pfm is of that format.
NumberImage read_numbers(const Path&, const std::optional<RawNumbers>& raw = std::nullopt);

}  // namespace umbra78::tools
