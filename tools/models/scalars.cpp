#include "tools/models/scalars.hpp"

#include "fixed/rounding.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace umbra78::tools {
namespace {

struct FloatFormat {
    int mantissa_bits, exponent_bits;
};

// mantissa * 2^exponent, mantissa < 2^53.
Coordinate scaled(std::int64_t mantissa, int exponent, bool negative) {
    const int up = exponent + model_fraction;
    constexpr int most_up = 52;  // max_model is 2^52
    if (up > 0 && (up > most_up || mantissa > (max_model >> up)))
        return {0, CoordinateStatus::out_of_range};
    const std::int64_t word =
        up > 0 ? mantissa * (std::int64_t{1} << up)
               : fixed::round_shift(mantissa, std::min(-up, 62), fixed::Rounding::half_even);
    if (word > max_model) return {0, CoordinateStatus::out_of_range};
    return {negative ? -word : word, CoordinateStatus::ok};
}

Coordinate floating(std::uint64_t bits, FloatFormat format) {
    const std::uint64_t one = std::uint64_t{1} << format.mantissa_bits;
    const int last = (1 << format.exponent_bits) - 1;
    const int exponent = static_cast<int>(bits >> format.mantissa_bits) & last;
    const bool negative = (bits >> (format.mantissa_bits + format.exponent_bits)) != 0;
    if (exponent == last) return {0, CoordinateStatus::no_number};
    const std::uint64_t mantissa = (bits & (one - 1)) | (exponent == 0 ? 0 : one);
    const int unit = std::max(exponent, 1) - last / 2 - format.mantissa_bits;
    return scaled(static_cast<std::int64_t>(mantissa), unit, negative);
}

}  // namespace

std::uint64_t bits_of(std::string_view bytes, bool big_endian) {
    std::uint64_t bits = 0;
    for (std::size_t k = 0; k < bytes.size(); ++k) {
        const char byte = bytes[big_endian ? k : bytes.size() - 1 - k];
        bits = bits << 8 | static_cast<unsigned char>(byte);
    }
    return bits;
}

std::int64_t whole_of(std::uint64_t bits, Scalar scalar) {
    const int unused = 64 - 8 * scalar.bytes;
    if (scalar.kind == ScalarKind::natural)
        return static_cast<std::int64_t>(bits & (~std::uint64_t{0} >> std::max(unused, 1)));
    return fixed::round_shift(static_cast<std::int64_t>(bits << unused), unused,
                              fixed::Rounding::floor);
}

Coordinate coordinate_of(std::uint64_t bits, Scalar scalar) {
    if (scalar.kind == ScalarKind::floating)
        return floating(bits, scalar.bytes == 4 ? FloatFormat{23, 8} : FloatFormat{52, 11});
    const std::int64_t whole = whole_of(bits, scalar);
    constexpr std::int64_t reach = max_model >> model_fraction;
    if (whole < -reach || whole > reach) return {0, CoordinateStatus::out_of_range};
    return {whole * (std::int64_t{1} << model_fraction), CoordinateStatus::ok};
}

std::int64_t read_coordinate(std::uint64_t bits, Scalar scalar, const ModelData& model, int line,
                             FirstError& error) {
    const auto [word, status] = coordinate_of(bits, scalar);
    if (status == CoordinateStatus::no_number)
        error.report(place_in(model, line) + ": a coordinate is infinite or no number; write the "
                                             "file again with finite ones");
    if (status == CoordinateStatus::out_of_range)
        error.report(fmt::format("{0}: a coordinate is beyond -{1} .. {1}; scale the file's points",
                                 place_in(model, line), max_model >> model_fraction));
    return word;
}

}  // namespace umbra78::tools
