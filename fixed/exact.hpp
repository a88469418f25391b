// Exact 64-bit sums, differences and products: the result, or a trap. Never a wrapped value.
#pragma once

#include <cstdint>

#include "fixed/trap.hpp"

namespace umbra78::fixed {

constexpr std::int64_t add_exact(std::int64_t a, std::int64_t b) {
    std::int64_t sum = 0;
    require(!__builtin_add_overflow(a, b, &sum), "sum does not fit 64 bits");
    return sum;
}

constexpr std::int64_t subtract_exact(std::int64_t a, std::int64_t b) {
    std::int64_t difference = 0;
    require(!__builtin_sub_overflow(a, b, &difference), "difference does not fit 64 bits");
    return difference;
}

constexpr std::int64_t multiply_exact(std::int64_t a, std::int64_t b) {
    std::int64_t product = 0;
    require(!__builtin_mul_overflow(a, b, &product), "product does not fit 64 bits");
    return product;
}

}  // namespace umbra78::fixed
