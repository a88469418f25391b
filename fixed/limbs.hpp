// Unsigned arithmetic on spans of 64-bit limbs, least significant first, from which WideInt is
// made: the schoolbook methods of Knuth, "The Art of Computer Programming" 2, section 4.3.1.
//
// A result replaces the first operand. What does not fit is returned: a carry, a borrow, or false.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>

#include "fixed/trap.hpp"
#include "fixed/wide_product.hpp"

namespace umbra78::fixed::limbs {

using Limb = std::uint64_t;

// Number of limbs up to the highest that is not 0.
constexpr std::size_t used(std::span<const Limb> a) {
    std::size_t n = a.size();
    while (n > 0 && a[n - 1] == 0) {
        --n;
    }
    return n;
}

// a against b, of equal size.
constexpr std::strong_ordering compare(std::span<const Limb> a, std::span<const Limb> b) {
    std::size_t i = a.size();
    while (i > 1 && a[i - 1] == b[i - 1]) {
        --i;
    }
    return a[i - 1] <=> b[i - 1];
}

// a += b, a.size() >= b.size(); returns the carry.
constexpr Limb add(std::span<Limb> a, std::span<const Limb> b, Limb carry = 0) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        const Limb addend = i < b.size() ? b[i] : 0;
        const Limb partial = a[i] + carry;
        a[i] = partial + addend;
        carry = (partial < carry ? 1u : 0u) + (a[i] < addend ? 1u : 0u);
    }
    return carry;
}

// a -= b, a.size() >= b.size(); returns the borrow.
constexpr Limb subtract(std::span<Limb> a, std::span<const Limb> b) {
    Limb borrow = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const Limb subtrahend = i < b.size() ? b[i] : 0;
        const Limb partial = a[i] - borrow;
        const Limb next = (a[i] < borrow ? 1u : 0u) + (partial < subtrahend ? 1u : 0u);
        a[i] = partial - subtrahend;
        borrow = next;
    }
    return borrow;
}

// a -= b * factor, a.size() == b.size() + 1; returns the borrow.
constexpr Limb subtract_product(std::span<Limb> a, std::span<const Limb> b, Limb factor) {
    Limb carry = 0;
    for (std::size_t i = 0; i < b.size(); ++i) {
        const Word128 product = multiply_wide(b[i], factor);
        const Limb low = product.low + carry;
        carry = product.high + (low < carry ? 1u : 0u) + (a[i] < low ? 1u : 0u);
        a[i] -= low;
    }
    const Limb borrow = a[b.size()] < carry ? 1 : 0;
    a[b.size()] -= carry;
    return borrow;
}

// a *= factor; returns what does not fit.
constexpr Limb multiply_by(std::span<Limb> a, Limb factor) {
    Limb carry = 0;
    for (Limb& limb : a) {
        const Word128 product = add_wide(multiply_wide(limb, factor), {0, carry});
        limb = product.low;
        carry = product.high;
    }
    return carry;
}

// out = a * b, where out is all 0 before; false if the product does not fit.
constexpr bool multiply(std::span<Limb> out, std::span<const Limb> a, std::span<const Limb> b) {
    const std::size_t na = used(a), nb = used(b);
    for (std::size_t i = 0; i < na; ++i) {
        Limb carry = 0;
        for (std::size_t j = 0; j < nb || carry != 0; ++j) {
            const Word128 product = j < nb ? multiply_wide(a[i], b[j]) : Word128{};
            if (i + j >= out.size()) {
                if (carry != 0 || product != Word128{}) {
                    return false;
                }
                continue;
            }
            const Limb low = product.low + carry;
            const Limb sum = out[i + j] + low;
            carry = product.high + (low < carry ? 1u : 0u) + (sum < low ? 1u : 0u);
            out[i + j] = sum;
        }
    }
    return true;
}

// out = a << count (up) or a >> count (down), count < 64 out.size(). Bits that out has no room for
// are dropped; limbs that a does not have count as 0 (up) or `fill` (down).
constexpr void shift_up(std::span<Limb> out, std::span<const Limb> a, int count) {
    const auto whole = static_cast<std::size_t>(count / 64);
    const int part = count % 64;
    for (std::size_t i = out.size(); i-- > 0;) {
        const Limb high = i >= whole && i - whole < a.size() ? a[i - whole] : 0;
        const Limb low = i > whole && i - whole <= a.size() ? a[i - whole - 1] : 0;
        out[i] = part == 0 ? high : high << part | low >> (64 - part);
    }
}
constexpr void shift_down(std::span<Limb> out, std::span<const Limb> a, int count, Limb fill) {
    const auto whole = static_cast<std::size_t>(count / 64);
    const int part = count % 64;
    for (std::size_t i = 0; i < out.size(); ++i) {
        const Limb low = i + whole < a.size() ? a[i + whole] : fill;
        const Limb high = i + whole + 1 < a.size() ? a[i + whole + 1] : fill;
        out[i] = part == 0 ? low : low >> part | high << (64 - part);
    }
}

// Algorithm D. u becomes the remainder, q the quotient; v is normalized (its top bit is set) and
// q.size() = u.size() - v.size(). The top v.size() limbs of u must be less than v.
constexpr void divide(std::span<Limb> q, std::span<Limb> u, std::span<const Limb> v) {
    const std::size_t n = v.size();
    for (std::size_t j = u.size() - n; j-- > 0;) {
        const std::span<Limb> window = u.subspan(j, n + 1);
        // A quotient of the two leading limbs by the first is at most 2 too large (theorem B).
        Limb digit = window[n] < v[n - 1]
                         ? divide_wide({window[n], window[n - 1]}, v[n - 1]).quotient
                         : ~Limb{0};
        for (Limb borrow = subtract_product(window, v, digit); borrow != 0; --digit) {
            borrow -= add(window, v);
        }
        q[j] = digit;
    }
}

}  // namespace umbra78::fixed::limbs
