#include "fixed/matrix.hpp"

#include <gtest/gtest.h>

#include "fixed/overflow.hpp"
#include "tests/fixed/boundary.hpp"

namespace umbra78::fixed {
namespace {

Vector4 any_vector4(test::Random& random) {
    Vector4 v;
    for (std::int64_t& word : v.word) {
        word = wrap(random.word(), 18);
    }
    return v;
}
Matrix4 any_matrix(test::Random& random) {
    Matrix4 m;
    for (Vector4& row : m.row) {
        row = any_vector4(random);
    }
    return m;
}

TEST(Matrix4, Examples) {
    constexpr Matrix4 m{{{{{1, 2, 3, 4}}, {{5, 6, 7, 8}}, {{9, 10, 11, 12}}, {{0, 0, 0, 1}}}}};
    static_assert(m * Vector4{{1, 0, 0, 0}} == Vector4{{1, 5, 9, 0}});  // the first column
    static_assert(m * Vector4{{1, 1, 1, 1}} == Vector4{{10, 26, 42, 1}});
    static_assert(transposed(m)[3] == Vector4{{4, 8, 12, 1}});
    static_assert(Matrix4::identity(1) * m == m && m * Matrix4::identity(1) == m);
    static_assert(round_shift(m * Matrix4::identity(1 << 14), 14, Rounding::floor) == m);
}

// Entry by entry, by the definition.
TEST(Matrix4, ProductByTheDefinition) {
    test::Random random;
    for (int i = 0; i < 2000; ++i) {
        const Matrix4 a = any_matrix(random), b = any_matrix(random);
        const Matrix4 product = a * b;
        for (std::size_t r = 0; r < 4; ++r) {
            for (std::size_t c = 0; c < 4; ++c) {
                std::int64_t sum = 0;
                for (std::size_t k = 0; k < 4; ++k) {
                    sum += a[r][k] * b[k][c];
                }
                ASSERT_EQ(product[r][c], sum) << r << "," << c;
            }
        }
    }
}

TEST(Matrix4, ProductsAssociate) {
    test::Random random;
    for (int i = 0; i < 5000; ++i) {
        const Matrix4 a = any_matrix(random), b = any_matrix(random);
        const Vector4 v = any_vector4(random);
        ASSERT_EQ((a * b) * v, a * (b * v));
        ASSERT_EQ(transposed(a * b), transposed(b) * transposed(a));
    }
}

TEST(Matrix4, OverflowTraps) {
    const Matrix4 large = Matrix4::identity(INT64_MAX);
    EXPECT_DEATH(large * large, "");
    EXPECT_DEATH((large * Vector4{{0, 2, 0, 0}}), "");
}

}  // namespace
}  // namespace umbra78::fixed
