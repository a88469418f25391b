// Matrix4: a 4x4 matrix of integer words, for column vectors.
//
//   (M v)[i] = sum over j of M[i][j] v[j]        row i makes output i
//
// Products are exact in 64 bits, or trap: the binary points add up, and the one rounding is the
// caller's, by round_shift(). So (A B) v = A (B v) holds word for word.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "fixed/rounding.hpp"
#include "fixed/vector.hpp"

namespace umbra78::fixed {

struct Matrix4 {
    std::array<Vector4, 4> row{};

    constexpr Vector4& operator[](std::size_t i) { return row[i]; }
    constexpr const Vector4& operator[](std::size_t i) const { return row[i]; }
    friend constexpr bool operator==(const Matrix4&, const Matrix4&) = default;

    // The identity, where `one` is the word of 1.0.
    static constexpr Matrix4 identity(std::int64_t one) {
        Matrix4 m;
        for (std::size_t i = 0; i < 4; ++i) {
            m[i][i] = one;
        }
        return m;
    }
};

constexpr Matrix4 transposed(const Matrix4& m) {
    Matrix4 t;
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = 0; j < 4; ++j) {
            t[j][i] = m[i][j];
        }
    }
    return t;
}

constexpr Vector4 operator*(const Matrix4& m, const Vector4& v) {
    return {{dot(m[0], v), dot(m[1], v), dot(m[2], v), dot(m[3], v)}};
}

constexpr Matrix4 operator*(const Matrix4& a, const Matrix4& b) {
    const Matrix4 columns = transposed(b);
    Matrix4 product;
    for (std::size_t i = 0; i < 4; ++i) {
        product[i] = columns * a[i];  // entry j is column j of b dot row i of a
    }
    return product;
}

// Every word / 2^shift.
constexpr Matrix4 round_shift(Matrix4 m, int shift, Rounding r) {
    for (Vector4& row : m.row) {
        row = round_shift(row, shift, r);
    }
    return m;
}

}  // namespace umbra78::fixed
