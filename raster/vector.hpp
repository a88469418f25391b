// Vectors of three components, of any number type, and the product of Q2.30 words.
//
// Sums are exact in the component's type; who uses them sees to it that they fit. Right-handed.
#pragma once

#include "fixed/rounding.hpp"

#include <array>
#include <cstdint>

namespace umbra78::raster {

template <class T>
using Vector = std::array<T, 3>;

template <class T>
constexpr T dot(const Vector<T>& a, const Vector<T>& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class T>
constexpr Vector<T> cross(const Vector<T>& a, const Vector<T>& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

using WideVector = Vector<std::int64_t>;  // any scale
using Axis = Vector<std::int32_t>;        // a unit vector, Q2.30

template <class T>
constexpr bool is_zero(const Vector<T>& v) {
    return v == Vector<T>{};
}
template <class T>
constexpr WideVector wide(const Vector<T>& v) {
    return {v[0], v[1], v[2]};
}

inline constexpr int axis_fraction = 30;
inline constexpr std::int32_t axis_one = std::int32_t{1} << axis_fraction;

// mul30 of hw/MACHINE.md, section 3: a Q2.30 word times any word, rounded half even.
constexpr std::int32_t axis_product(std::int32_t a, std::int32_t b) {
    return static_cast<std::int32_t>(fixed::round_shift(std::int64_t{a} * b, axis_fraction,
                                                        fixed::Rounding::half_even));
}

}  // namespace umbra78::raster
