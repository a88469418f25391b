// Numbers of binary model files, read as integers: what their bits mean, exactly.
//
//   float   (-1)^s * 1.m * 2^(e - 127), 24 bits of mantissa     IEEE 754; e = 0: 0.m * 2^-126
//   double  (-1)^s * 1.m * 2^(e - 1023), 53 bits of mantissa    e = 0: 0.m * 2^-1022
//
// Each is a whole number times a power of two, so the word of a coordinate is a shift of it, with
// one rounding, half to even. e with all bits set is an infinity or no number.
#pragma once

#include "tools/io/first_error.hpp"
#include "tools/models/model.hpp"

#include <cstdint>
#include <string>
#include <string_view>

namespace umbra78::tools {

enum class ScalarKind : std::uint8_t { natural, whole, floating };  // without sign, with sign

struct Scalar {
    ScalarKind kind = ScalarKind::floating;
    std::uint8_t bytes = 4;  // 1, 2, 4 or 8; of a floating one 4 or 8
};

// The bits that stand in `bytes`, at most 8 of them.
std::uint64_t bits_of(std::string_view bytes, bool big_endian);

// A number of a kind that is not floating; of 8 bytes without sign, its lower 63 bits.
std::int64_t whole_of(std::uint64_t bits, Scalar);

enum class CoordinateStatus : std::uint8_t { ok, no_number, out_of_range };
struct Coordinate {
    std::int64_t word = 0;  // of 32 fraction bits; 0 unless ok
    CoordinateStatus status = CoordinateStatus::ok;
};

// Within max_model.
Coordinate coordinate_of(std::uint64_t bits, Scalar);

// The same, or a report that names the place in the model.
std::int64_t read_coordinate(std::uint64_t bits, Scalar, const ModelData&, int line, FirstError&);

}  // namespace umbra78::tools
