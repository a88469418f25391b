// The multiply-accumulator: a sum of products of which no bit is dropped before the one rounding.
//
//   sum = a[0] b[0] + ... + a[n-1] b[n-1]     a of a_bits, b of b_bits, both signed
//
// |sum| <= n 2^(a_bits - 1) 2^(b_bits - 1), reached when every factor is the least word, so it
// needs a_bits + b_bits - 1 + bit_length(n) bits. 16 x 16 bits and 4 products: 34. The single-chip
// multiplier-accumulators of the time (TRW TDC1010J) had 35, which suffices for 15 products.
//
// Integer addition is associative, so every order of the products, every grouping, and every
// partial sum agree. The width is checked when the accumulator is made, not at each addition.
// Sum is the type that holds it: int64, or WideInt<2> beyond 64 bits.
#pragma once

#include <bit>
#include <cstdint>
#include <type_traits>

#include "fixed/overflow.hpp"
#include "fixed/rounding.hpp"
#include "fixed/trap.hpp"
#include "fixed/wide_int.hpp"

namespace umbra78::fixed {

struct AccumulatorShape {
    int a_bits = 16, b_bits = 16;  // widths of the signed factors
    int products = 4;              // the most that are summed between two clears
    int sum_bits = 35;             // what the machine provides

    // The least width that no sum overflows.
    constexpr int bits_needed() const {
        require(products >= 1, "accumulator: at least one product");
        return a_bits + b_bits - 1 + 32 - std::countl_zero(static_cast<std::uint32_t>(products));
    }
    constexpr bool closed() const { return sum_bits >= bits_needed(); }
};

template <class Sum = std::int64_t>
class Accumulator {
    static constexpr int capacity = 8 * static_cast<int>(sizeof(Sum));

public:
    constexpr explicit Accumulator(const AccumulatorShape& shape) : shape_(shape) {
        require(shape.a_bits >= 1 && shape.a_bits <= 64 && shape.b_bits >= 1 && shape.b_bits <= 64,
                "accumulator: factors of 1..64 bits");
        require(shape.closed(), "accumulator: too narrow for its products");
        require(shape.bits_needed() <= capacity, "accumulator: wider than its type");
    }

    constexpr void clear() {
        sum_ = 0;
        used_ = 0;
    }

    constexpr void multiply_add(std::int64_t a, std::int64_t b) {
        require(fits(a, shape_.a_bits) && fits(b, shape_.b_bits), "accumulator: factor too wide");
        require(used_ < shape_.products, "accumulator: more products than it was made for");
        ++used_;
        sum_ += Sum(a) * Sum(b);
    }

    constexpr const Sum& sum() const { return sum_; }
    constexpr const AccumulatorShape& shape() const { return shape_; }

    // sum / 2^shift, the one rounding.
    constexpr std::int64_t rounded(int shift, Rounding r) const
        requires std::is_same_v<Sum, std::int64_t>
    {
        return round_shift(sum_, shift, r);
    }

private:
    AccumulatorShape shape_;
    int used_ = 0;
    Sum sum_ = 0;
};

}  // namespace umbra78::fixed
