// Vector<N>: N integer words. What the words mean (their binary point) is the owner's business.
//
// Sums, differences, products and dot products are exact in 64 bits, or trap.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "fixed/exact.hpp"
#include "fixed/rounding.hpp"

namespace umbra78::fixed {

template <std::size_t N>
struct Vector {
    std::array<std::int64_t, N> word{};

    constexpr std::int64_t& operator[](std::size_t i) { return word[i]; }
    constexpr std::int64_t operator[](std::size_t i) const { return word[i]; }
    friend constexpr bool operator==(const Vector&, const Vector&) = default;

    friend constexpr Vector operator+(Vector a, const Vector& b) {
        for (std::size_t i = 0; i < N; ++i) {
            a[i] = add_exact(a[i], b[i]);
        }
        return a;
    }
    friend constexpr Vector operator-(Vector a, const Vector& b) {
        for (std::size_t i = 0; i < N; ++i) {
            a[i] = subtract_exact(a[i], b[i]);
        }
        return a;
    }
    friend constexpr Vector operator-(const Vector& a) { return Vector{} - a; }
    friend constexpr Vector operator*(Vector a, std::int64_t factor) {
        for (std::size_t i = 0; i < N; ++i) {
            a[i] = multiply_exact(a[i], factor);
        }
        return a;
    }
};

using Vector3 = Vector<3>;
using Vector4 = Vector<4>;

template <std::size_t N>
constexpr std::int64_t dot(const Vector<N>& a, const Vector<N>& b) {
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < N; ++i) {
        sum = add_exact(sum, multiply_exact(a[i], b[i]));
    }
    return sum;
}

constexpr Vector3 cross(const Vector3& a, const Vector3& b) {
    const auto minor = [&](std::size_t i, std::size_t j) {
        return subtract_exact(multiply_exact(a[i], b[j]), multiply_exact(a[j], b[i]));
    };
    return {{minor(1, 2), minor(2, 0), minor(0, 1)}};
}

// Every word / 2^shift.
template <std::size_t N>
constexpr Vector<N> round_shift(Vector<N> v, int shift, Rounding r) {
    for (std::size_t i = 0; i < N; ++i) {
        v[i] = round_shift(v[i], shift, r);
    }
    return v;
}

}  // namespace umbra78::fixed
