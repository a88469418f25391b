// Integer square root: the largest r with r^2 <= v, for every 64-bit v.
//
// Zimmermann's recursive root (P. Zimmermann, "Karatsuba Square Root", INRIA RR-3805, 1999) as
// unrolled by M. Dickinson for CPython's math.isqrt: for 2^62 <= v < 2^64 an 8-bit root from a
// table, then two divisions give r with (r - 1)^2 < v < (r + 1)^2, and one comparison decides.
// Smaller v are first shifted left by an even count.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace umbra78::fixed {

namespace detail {

// table[i] approximates sqrt(v) / 2^24 for v / 2^56 in i + 64 .. i + 65: the root of the middle of
// the interval, sqrt((i + 64.5) 2^8), to the nearest integer, at most 255.
constexpr std::array<std::uint8_t, 192> make_root_table() {
    std::array<std::uint8_t, 192> table{};
    std::uint32_t root = 128;
    for (std::uint32_t i = 0; i < 192; ++i) {
        const std::uint32_t middle = ((i + 64) << 8) + 128;
        while (root < 255 && root * root + root < middle) {  // (root + 1/2)^2 < middle
            ++root;
        }
        table[i] = static_cast<std::uint8_t>(root);
    }
    return table;
}
inline constexpr std::array<std::uint8_t, 192> root_table = make_root_table();

}  // namespace detail

constexpr std::uint32_t isqrt(std::uint64_t v) {
    if (v == 0) {
        return 0;
    }
    const int half_shift = std::countl_zero(v) / 2;
    const std::uint64_t n = v << (2 * half_shift);
    std::uint32_t root = detail::root_table[static_cast<std::size_t>(n >> 56) - 64];
    root = (root << 7) + static_cast<std::uint32_t>(n >> 41) / root;
    // The sum may reach 2^32; the root itself never does, and 2^32 - 1 stands for it.
    const std::uint64_t sum = (std::uint64_t{root} << 15) + (n >> 17) / root;
    const std::uint64_t near = (sum < UINT32_MAX ? sum : UINT32_MAX) >> half_shift;
    return static_cast<std::uint32_t>(near - (near * near > v ? 1 : 0));
}

}  // namespace umbra78::fixed
