// Integer square root: the largest r with r^2 <= v, for every 64-bit v.
//
// Zimmermann's recursive root (P. Zimmermann, "Karatsuba Square Root", INRIA RR-3805, 1999) as
// unrolled by M. Dickinson for CPython's math.isqrt. v is shifted left by an even count to n,
// 2^62 <= n < 2^64; a table gives 8 bits of its root, two Newton steps 16 and 32:
//
//   r = floor((x + n/x) / 2)      in integers, with x 2^k for the root before:
//                                 (x << k-1) + (n >> k+1) / x
//
// Why it is exact. (x + n/x)/2 - sqrt n = (x - sqrt n)^2 / (2 x), which lies in 0 .. 1 whenever
// |x - sqrt n| < sqrt(2 x). Then r - 1 < sqrt n < r + 1, so r is the root or one more, and one
// comparison decides. The table is within one of the 8-bit root (a test checks every entry), so the
// 16-bit root is within one, and so is the last; one, scaled by 2^8 or 2^16, is below sqrt(2 x).
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
    // Below 2^32: 2^32 would need n > (2^32 - 1)^2, but there root is 2^16 and the sum 2^32 - 1.
    const std::uint64_t sum = (std::uint64_t{root} << 15) + (n >> 17) / root;
    const std::uint64_t near = sum >> half_shift;
    return static_cast<std::uint32_t>(near - (near * near > v ? 1 : 0));
}

}  // namespace umbra78::fixed
