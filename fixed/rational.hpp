// Rational: an exact fraction num / den of 512-bit integers, den > 0.
//
// For scenes and matrices before they become words: every value stays exact until the one
// rounding, round_scaled(). Common powers of two are divided out after each operation; fixed-point
// data seldom has other common factors. The full gcd is computed only when an operand has grown
// beyond 240 bits, so that products still fit. So numerator() and denominator() are not always in
// lowest terms; those of reduced() are.
// A value that needs more than 511 bits even when reduced is a broken precondition; so is x / 0.
#pragma once

#include <compare>
#include <cstdint>

#include "fixed/rounding.hpp"
#include "fixed/trap.hpp"
#include "fixed/wide_int.hpp"

namespace umbra78::fixed {

class Rational {
public:
    using Int = WideInt<8>;

    constexpr Rational() = default;
    constexpr Rational(std::int64_t v) : num_(v) {}  // implicit: every int64 is a Rational
    constexpr Rational(std::int64_t num, std::int64_t den) : Rational(Int(num), Int(den)) {}
    constexpr Rational(const Int& num, const Int& den) : num_(num), den_(den) { normalize(); }

    constexpr const Int& numerator() const { return num_; }
    constexpr const Int& denominator() const { return den_; }
    constexpr bool is_zero() const { return num_.is_zero(); }
    constexpr bool is_negative() const { return num_.is_negative(); }

    constexpr Rational reduced() const {
        const Int common = gcd(num_.abs(), den_);
        Rational result;
        result.num_ = num_ / common;
        result.den_ = den_ / common;
        return result;
    }

    constexpr Rational operator-() const {
        Rational result = *this;
        result.num_ = -num_;
        return result;
    }
    friend constexpr Rational operator+(const Rational& a, const Rational& b) {
        return a.den_ == b.den_ ? Rational(a.num_ + b.num_, a.den_)
                                : Rational(a.num_ * b.den_ + b.num_ * a.den_, a.den_ * b.den_);
    }
    friend constexpr Rational operator-(const Rational& a, const Rational& b) { return a + -b; }
    friend constexpr Rational operator*(const Rational& a, const Rational& b) {
        return Rational(a.num_ * b.num_, a.den_ * b.den_);
    }
    friend constexpr Rational operator/(const Rational& a, const Rational& b) {
        return Rational(a.num_ * b.den_, a.den_ * b.num_);  // normalize() traps on b = 0
    }
    constexpr Rational& operator+=(const Rational& b) { return *this = *this + b; }
    constexpr Rational& operator-=(const Rational& b) { return *this = *this - b; }
    constexpr Rational& operator*=(const Rational& b) { return *this = *this * b; }
    constexpr Rational& operator/=(const Rational& b) { return *this = *this / b; }

    friend constexpr bool operator==(const Rational& a, const Rational& b) {
        return (a <=> b) == 0;
    }
    friend constexpr std::strong_ordering operator<=>(const Rational& a, const Rational& b) {
        return a.den_ == b.den_ ? a.num_ <=> b.num_ : a.num_ * b.den_ <=> b.num_ * a.den_;
    }

    // The largest k with 2^k <= |*this|, which is not 0.
    constexpr int floor_log2() const {
        require(!is_zero(), "Rational: logarithm of 0");
        const Int n = num_.abs();
        const int k = n.bit_length() - den_.bit_length();  // 2^(k-1) < |*this| < 2^(k+1)
        const bool reached = k >= 0 ? n >= (den_ << k) : (n << -k) >= den_;
        return reached ? k : k - 1;
    }

    // out = *this * 2^shift rounded; false, and out untouched, if that does not fit 64 bits.
    constexpr bool round_scaled(int shift, Rounding r, std::int64_t& out) const {
        require(shift >= -(1 << 20) && shift <= 1 << 20, "Rational: absurd scale");
        if (is_zero()) {
            out = 0;
            return true;
        }
        const int log2 = floor_log2() + shift;  // of the scaled value
        if (log2 > 63) {
            return false;
        }
        if (log2 < -1) {  // |value| < 1/2, so only its sign matters: it rounds as +-1/4 does
            out = round_shift(is_negative() ? -1 : 1, 2, r);
            return true;
        }
        // The scaled operands have at most 512 + 64 bits.
        using Wide = WideInt<10>;
        const Wide n = shift > 0 ? Wide(num_) << shift : Wide(num_);
        const Wide d = shift < 0 ? Wide(den_) << -shift : Wide(den_);
        return round_quotient(n, d, r, out);
    }

private:
    static constexpr bool round_quotient(const WideInt<10>& n, const WideInt<10>& d, Rounding r,
                                         std::int64_t& out) {
        auto [floor, remainder] = WideInt<10>::divide(n, d);
        if (remainder.is_negative()) {
            floor -= 1;
            remainder += d;
        }
        // rounds_up() takes words: 0, 1, 2, 3 quarters for nothing, less than a half, a half, more.
        const auto half = (remainder << 1) <=> d;
        const unsigned quarters = remainder.is_zero() ? 0 : half < 0 ? 1 : half == 0 ? 2 : 3;
        if (rounds_up(n.is_negative(), floor.is_odd(), 2 * quarters, 4, r)) {
            floor += 1;
        }
        if (!floor.fits_int64()) {
            return false;
        }
        out = floor.to_int64();
        return true;
    }

    // Stein's binary algorithm; a >= 0, b > 0, not both even, which normalize() ensures.
    static constexpr Int gcd(Int a, Int b) {
        if (a.is_zero()) {
            return b;
        }
        a = a >> a.trailing_zeros();
        b = b >> b.trailing_zeros();
        while (a != b) {
            if (a < b) {
                const Int t = a;
                a = b;
                b = t;
            }
            a -= b;
            a = a >> a.trailing_zeros();
        }
        return a;
    }

    constexpr void normalize() {
        require(!den_.is_zero(), "Rational: division by zero");
        if (num_.is_zero()) {
            den_ = 1;
            return;
        }
        if (den_.is_negative()) {
            num_ = -num_;
            den_ = -den_;
        }
        const int zn = num_.trailing_zeros(), zd = den_.trailing_zeros();
        const int common = zn < zd ? zn : zd;
        if (common > 0) {
            num_ = num_ >> common;
            den_ = den_ >> common;
        }
        constexpr int long_operand = 240;
        if (num_.bit_length() > long_operand || den_.bit_length() > long_operand) {
            *this = reduced();
        }
    }

    Int num_ = 0, den_ = 1;
};

}  // namespace umbra78::fixed
