// What the models that models.py turns into C++ are written with: words of up to 128 bits.
#pragma once

#include <cstdint>
#include <vector>

namespace umbra78::proofs {

__extension__ using Wide = __int128;
__extension__ using Bits = unsigned __int128;

struct Range {
    Wide low, high;
};

constexpr Bits cut(Bits v, int width) {
    return width >= 128 ? v : v & ((Bits{1} << width) - 1);
}
constexpr Wide as_signed(Bits v, int width) {
    return static_cast<Wide>(v << (128 - width)) >> (128 - width);
}
// Hexadecimal digits, of which the first 16 are `high` if there are more.
constexpr Bits word(std::uint64_t high, std::uint64_t low, int digits) {
    return digits <= 16 ? Bits{high} : Bits{high} << (4 * (digits - 16)) | low;
}
constexpr Bits bvshl(Bits v, Bits n, int width) {
    return n >= static_cast<Bits>(width) ? 0 : cut(v << static_cast<int>(n), width);
}
constexpr Bits bvlshr(Bits v, Bits n, int width) {
    return n >= static_cast<Bits>(width) ? 0 : v >> static_cast<int>(n);
}
constexpr Bits bvashr(Bits v, Bits n, int width) {
    const int by = n >= static_cast<Bits>(width) ? width - 1 : static_cast<int>(n);
    return cut(static_cast<Bits>(as_signed(v, width) >> by), width);
}
constexpr Wide floor_divide(Wide a, Wide b) {
    return a / b - (a % b != 0 && (a < 0) != (b < 0) ? 1 : 0);
}
constexpr Wide floor_modulo(Wide a, Wide b) { return a - floor_divide(a, b) * b; }

}  // namespace umbra78::proofs
