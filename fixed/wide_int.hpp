// WideInt<Limbs>: a signed two's complement integer of 64 * Limbs bits.
//
// For what must be exact and is not computed for each pixel: certificates, rationals, decimals,
// tables. Every operation gives the exact result; one that does not fit is a broken precondition,
// and nothing wraps. Division truncates towards zero and the remainder has the dividend's sign, as
// for the built-in types; >> rounds down (the floor).
#pragma once

#include <array>
#include <bit>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>

#include "fixed/limbs.hpp"
#include "fixed/trap.hpp"

namespace umbra78::fixed {

template <int Limbs>
class WideInt {
    static_assert(Limbs >= 1, "WideInt needs at least one limb");

public:
    using Limb = limbs::Limb;
    static constexpr int bits = 64 * Limbs;

    struct Division;  // quotient and remainder

    constexpr WideInt() = default;
    constexpr WideInt(std::int64_t v) {  // implicit: every int64 is a WideInt
        limb_.fill(v < 0 ? ~Limb{0} : 0);
        limb_[0] = static_cast<Limb>(v);
    }
    // From another size: exact or a trap.
    template <int Other>
    constexpr explicit WideInt(const WideInt<Other>& v) {
        for (int i = 0; i < (Limbs > Other ? Limbs : Other); ++i) {
            if (i < Limbs) {
                limb_[static_cast<std::size_t>(i)] = v.limb(i);
            } else {
                require(v.limb(i) == limb(Limbs), "WideInt: value does not fit");
            }
        }
        require(is_negative() == v.is_negative(), "WideInt: value does not fit");
    }

    // Limb i of the infinite two's complement expansion.
    constexpr Limb limb(int i) const {
        return i < Limbs ? limb_[static_cast<std::size_t>(i)] : sign_fill();
    }
    constexpr bool is_negative() const { return limb_.back() >> 63 != 0; }
    constexpr bool is_zero() const { return limbs::used(limb_) == 0; }
    constexpr bool is_odd() const { return (limb_[0] & 1) != 0; }
    constexpr bool fits_int64() const {
        for (int i = 1; i < Limbs; ++i) {
            if (limb(i) != sign_fill()) {
                return false;
            }
        }
        return (limb_[0] >> 63 != 0) == is_negative();
    }
    constexpr std::int64_t to_int64() const {
        require(fits_int64(), "WideInt: value does not fit 64 bits");
        return static_cast<std::int64_t>(limb_[0]);
    }

    // Bits of |*this|: 0 for 0, n + 1 for +-2^n.
    constexpr int bit_length() const {
        const WideInt m = magnitude_bits();
        const auto n = static_cast<int>(limbs::used(m.limb_));
        return n == 0 ? 0 : 64 * n - std::countl_zero(m.limb(n - 1));
    }
    // How many times 2 divides *this, which is not 0.
    constexpr int trailing_zeros() const {
        require(!is_zero(), "WideInt: trailing zeros of 0");
        int i = 0;
        while (limb(i) == 0) {
            ++i;
        }
        return 64 * i + std::countr_zero(limb(i));
    }

    constexpr WideInt abs() const { return is_negative() ? -*this : *this; }
    constexpr WideInt operator-() const {
        const WideInt result = negated_bits();
        require(is_zero() || result.is_negative() != is_negative(), "WideInt: negation overflow");
        return result;
    }

    constexpr WideInt& operator+=(const WideInt& b) {
        const bool same_sign = is_negative() == b.is_negative();
        const bool was_negative = is_negative();
        limbs::add(limb_, b.limb_);
        require(!same_sign || is_negative() == was_negative, "WideInt: sum overflow");
        return *this;
    }
    constexpr WideInt& operator-=(const WideInt& b) {
        const bool same_sign = is_negative() == b.is_negative();
        const bool was_negative = is_negative();
        limbs::subtract(limb_, b.limb_);
        require(same_sign || is_negative() == was_negative, "WideInt: difference overflow");
        return *this;
    }
    friend constexpr WideInt operator+(WideInt a, const WideInt& b) { return a += b; }
    friend constexpr WideInt operator-(WideInt a, const WideInt& b) { return a -= b; }

    friend constexpr WideInt operator*(const WideInt& a, const WideInt& b) {
        if constexpr (Limbs <= 4) {
            return WideInt(full_product(a, b));
        } else {  // which leaves out the limbs that are 0
            WideInt product;
            const bool fits =
                limbs::multiply(product.limb_, a.magnitude_bits().limb_, b.magnitude_bits().limb_);
            require(fits, "WideInt: product overflow");
            return product.with_sign(a.is_negative() != b.is_negative());
        }
    }

    // By one limb, from the lowest limb up: a times |b|, negated where b is negative by inverting
    // it and adding 1.
    friend constexpr WideInt operator*(const WideInt& a, std::int64_t b) {
        const Limb sign = b < 0 ? ~Limb{0} : 0, factor = (static_cast<Limb>(b) ^ sign) - sign;
        Limb carry = 0, one = sign & 1;
        WideInt product;
        for (std::size_t i = 0; i < Limbs; ++i) {
            const Word128 part = add_wide(multiply_wide(a.limb_[i], factor), {0, carry});
            product.limb_[i] = (part.low ^ sign) + one;
            one = product.limb_[i] < one ? 1 : 0;
            carry = part.high;
        }
        // As an unsigned number a negative a is 2^bits too large.
        const Limb beyond = ((carry - (a.is_negative() ? factor : 0)) ^ sign) + one;
        require(beyond == product.sign_fill(), "WideInt: product overflow");
        return product;
    }
    friend constexpr WideInt operator*(std::int64_t a, const WideInt& b) { return b * a; }

    friend constexpr WideInt operator<<(const WideInt& a, int count) {
        require(count >= 0 && count < bits, "WideInt: shift count outside the word");
        WideInt result;
        limbs::shift_up(result.limb_, a.limb_, count);
        require((result >> count) == a, "WideInt: left shift overflow");
        return result;
    }
    friend constexpr WideInt operator>>(const WideInt& a, int count) {
        require(count >= 0 && count < bits, "WideInt: shift count outside the word");
        WideInt result;
        limbs::shift_down(result.limb_, a.limb_, count, a.sign_fill());
        return result;
    }

    static constexpr Division divide(const WideInt& num, const WideInt& den) {
        require(!den.is_zero(), "WideInt: division by zero");
        const WideInt divisor = den.magnitude_bits(), dividend = num.magnitude_bits();
        const std::size_t n = limbs::used(divisor.limb_);
        const int shift = std::countl_zero(divisor.limb_[n - 1]);  // normalizes the divisor
        std::array<Limb, Limbs> v{};
        std::array<Limb, Limbs + 1> u{};
        limbs::shift_up(v, divisor.limb_, shift);
        limbs::shift_up(u, dividend.limb_, shift);
        WideInt quotient, remainder;
        limbs::divide(std::span(quotient.limb_).first(Limbs + 1 - n), u, std::span(v).first(n));
        limbs::shift_down(remainder.limb_, u, shift, 0);
        return {quotient.with_sign(num.is_negative() != den.is_negative()),
                remainder.with_sign(num.is_negative())};
    }
    friend constexpr WideInt operator/(const WideInt& a, const WideInt& b) {
        return divide(a, b).quotient;
    }
    friend constexpr WideInt operator%(const WideInt& a, const WideInt& b) {
        return divide(a, b).remainder;
    }

    friend constexpr bool operator==(const WideInt&, const WideInt&) = default;
    friend constexpr std::strong_ordering operator<=>(const WideInt& a, const WideInt& b) {
        if (a.is_negative() != b.is_negative()) {
            return b.is_negative() <=> a.is_negative();
        }
        return limbs::compare(a.limb_, b.limb_);  // in two's complement, for equal signs
    }

private:
    constexpr Limb sign_fill() const { return is_negative() ? ~Limb{0} : 0; }

    // 0 - *this modulo 2^bits.
    constexpr WideInt negated_bits() const {
        WideInt result;
        limbs::subtract(result.limb_, limb_);
        return result;
    }
    // |*this| read as an unsigned word; 2^(bits-1) for the smallest value.
    constexpr WideInt magnitude_bits() const {
        return is_negative() ? negated_bits() : *this;
    }
    // The unsigned word *this with a sign, or a trap.
    constexpr WideInt with_sign(bool negative) const {
        const WideInt result = negative ? negated_bits() : *this;
        require(is_zero() || result.is_negative() == negative, "WideInt: result overflow");
        return result;
    }

    template <int A, int B>
    friend constexpr WideInt<A + B> full_product(const WideInt<A>&, const WideInt<B>&);
    template <int>
    friend class WideInt;

    std::array<Limb, Limbs> limb_{};
};

// The product of any two numbers, which always fits.
template <int A, int B>
constexpr WideInt<A + B> full_product(const WideInt<A>& a, const WideInt<B>& b) {
    WideInt<A + B> product;
    auto& out = product.limb_;
    for (std::size_t i = 0; i < A; ++i) {
        limbs::Limb carry = 0;
        for (std::size_t j = 0; j < B; ++j) {  // at most (2^64 - 1)^2 + 2 (2^64 - 1) = 2^128 - 1
            Word128 part = add_wide(multiply_wide(a.limb_[i], b.limb_[j]), {0, carry});
            part = add_wide(part, {0, out[i + j]});
            out[i + j] = part.low;
            carry = part.high;
        }
        out[i + B] = carry;
    }
    // As unsigned numbers a negative a is 2^(64 A) too large, and a negative b 2^(64 B).
    if (a.is_negative()) limbs::subtract(std::span(out).subspan(A), b.limb_);
    if (b.is_negative()) limbs::subtract(std::span(out).subspan(B), a.limb_);
    return product;
}

template <int Limbs>
struct WideInt<Limbs>::Division {
    WideInt quotient, remainder;
};

}  // namespace umbra78::fixed
