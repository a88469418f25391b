// Integers of 128 bits for the tests' models: the compiler's own where it has them, and elsewhere,
// that is on 32-bit processors, a plain and slow class with the same operators, modulo 2^128.
// tests/fixed/int128_test.cpp holds the two equal.
#pragma once

#include <compare>
#include <concepts>
#include <cstdint>
#include <type_traits>

namespace umbra78::test {

template <bool is_signed>
class Slow128 {
public:
    constexpr Slow128() = default;
    template <std::integral Int>
    constexpr Slow128(Int v)
        : low_(static_cast<std::uint64_t>(v)), high_(v < Int{0} ? ~std::uint64_t{0} : 0) {}
    constexpr Slow128(std::uint64_t high, std::uint64_t low) : low_(low), high_(high) {}
    constexpr explicit Slow128(const Slow128<!is_signed>& v) : low_(v.low()), high_(v.high()) {}

    template <std::integral Int>
    constexpr explicit operator Int() const {
        if constexpr (std::is_same_v<Int, bool>) return (low_ | high_) != 0;
        return static_cast<Int>(low_);
    }
    constexpr std::uint64_t low() const { return low_; }
    constexpr std::uint64_t high() const { return high_; }

    friend constexpr bool operator==(const Slow128&, const Slow128&) = default;
    friend constexpr std::strong_ordering operator<=>(const Slow128& a, const Slow128& b) {
        if (a.negative() != b.negative()) return b.negative() <=> a.negative();
        return a.high_ != b.high_ ? a.high_ <=> b.high_ : a.low_ <=> b.low_;
    }
    friend constexpr Slow128 operator+(const Slow128& a, const Slow128& b) {
        const std::uint64_t low = a.low_ + b.low_;
        return {a.high_ + b.high_ + (low < a.low_ ? 1u : 0u), low};
    }
    friend constexpr Slow128 operator-(const Slow128& a, const Slow128& b) { return a + -b; }
    friend constexpr Slow128 operator*(const Slow128& a, const Slow128& b) {
        const std::uint64_t a0 = a.low_ & half, a1 = a.low_ >> 32;
        const std::uint64_t b0 = b.low_ & half, b1 = b.low_ >> 32;
        Slow128 sum{a1 * b1 + a.high_ * b.low_ + a.low_ * b.high_, a0 * b0};
        for (const std::uint64_t cross : {a0 * b1, a1 * b0})
            sum = sum + Slow128{cross >> 32, cross << 32};
        return sum;
    }
    friend constexpr Slow128 operator/(const Slow128& a, const Slow128& b) {
        const Slow128 q = divide(a.magnitude(), b.magnitude()).quotient;
        return a.negative() != b.negative() ? -q : q;
    }
    friend constexpr Slow128 operator%(const Slow128& a, const Slow128& b) {
        const Slow128 r = divide(a.magnitude(), b.magnitude()).rest;
        return a.negative() ? -r : r;
    }
    friend constexpr Slow128 operator<<(const Slow128& v, int n) {
        if (n == 0) return v;
        if (n >= 64) return {v.low_ << (n - 64), 0};
        return {v.high_ << n | v.low_ >> (64 - n), v.low_ << n};
    }
    friend constexpr Slow128 operator>>(const Slow128& v, int n) {
        if (n == 0) return v;
        const std::uint64_t sign = v.negative() ? ~std::uint64_t{0} : 0;
        const auto high = [&](int by) {
            return by == 0 ? v.high_ : v.high_ >> by | sign << (64 - by);
        };
        if (n >= 64) return {sign, high(n - 64)};
        return {high(n), v.high_ << (64 - n) | v.low_ >> n};
    }
    friend constexpr Slow128 operator&(const Slow128& a, const Slow128& b) {
        return {a.high_ & b.high_, a.low_ & b.low_};
    }
    friend constexpr Slow128 operator|(const Slow128& a, const Slow128& b) {
        return {a.high_ | b.high_, a.low_ | b.low_};
    }
    constexpr Slow128 operator~() const { return {~high_, ~low_}; }
    constexpr Slow128 operator-() const { return ~*this + Slow128{0, 1}; }

    constexpr Slow128& operator+=(const Slow128& b) { return *this = *this + b; }
    constexpr Slow128& operator-=(const Slow128& b) { return *this = *this - b; }
    constexpr Slow128& operator*=(const Slow128& b) { return *this = *this * b; }
    constexpr Slow128& operator/=(const Slow128& b) { return *this = *this / b; }
    constexpr Slow128& operator%=(const Slow128& b) { return *this = *this % b; }
    constexpr Slow128& operator<<=(int n) { return *this = *this << n; }
    constexpr Slow128& operator>>=(int n) { return *this = *this >> n; }
    constexpr Slow128& operator++() { return *this += Slow128{0, 1}; }
    constexpr Slow128& operator--() { return *this -= Slow128{0, 1}; }

private:
    static constexpr std::uint64_t half = 0xffffffff;
    struct Division {
        Slow128 quotient, rest;
    };

    constexpr bool negative() const { return is_signed && high_ >> 63 != 0; }
    constexpr Slow128 magnitude() const { return negative() ? -*this : *this; }
    constexpr bool below(const Slow128& b) const {
        return high_ != b.high_ ? high_ < b.high_ : low_ < b.low_;
    }
    // Bit by bit, of values without a sign; b > 0. The rest is shifted out of 128 bits where b is
    // at least 2^127, and then it is more than b in any case.
    static constexpr Division divide(const Slow128& a, const Slow128& b) {
        Division d;
        for (int k = 127; k >= 0; --k) {
            const std::uint64_t bit = (k >= 64 ? a.high_ >> (k - 64) : a.low_ >> k) & 1;
            const bool out = d.rest.high_ >> 63 != 0;
            d.rest = (d.rest << 1) | Slow128{0, bit};
            d.quotient = d.quotient << 1;
            if (!out && d.rest.below(b)) continue;
            d.rest -= b;
            d.quotient.low_ |= 1;
        }
        return d;
    }

    std::uint64_t low_ = 0, high_ = 0;
};

#ifdef __SIZEOF_INT128__
__extension__ using Int128 = __int128;
__extension__ using UInt128 = unsigned __int128;
#else
using Int128 = Slow128<true>;
using UInt128 = Slow128<false>;
#endif

// Whether a sum, difference or product is not that of `out`, which is modulo 2^128.
#ifdef __SIZEOF_INT128__
inline bool sum_overflows(Int128 a, Int128 b, Int128& out) {
    return __builtin_add_overflow(a, b, &out);
}
inline bool difference_overflows(Int128 a, Int128 b, Int128& out) {
    return __builtin_sub_overflow(a, b, &out);
}
inline bool product_overflows(Int128 a, Int128 b, Int128& out) {
    return __builtin_mul_overflow(a, b, &out);
}
#else
inline bool sum_overflows(Int128 a, Int128 b, Int128& out) {
    out = a + b;
    return (a < 0) == (b < 0) && (out < 0) != (a < 0);
}
inline bool difference_overflows(Int128 a, Int128 b, Int128& out) {
    out = a - b;
    return (a < 0) != (b < 0) && (out < 0) != (a < 0);
}
inline bool product_overflows(Int128 a, Int128 b, Int128& out) {
    out = a * b;
    const Int128 least = Int128{1} << 127;
    return a != 0 && ((a == -1 && b == least) || out / a != b);
}
#endif

}  // namespace umbra78::test
