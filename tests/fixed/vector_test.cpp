#include "fixed/vector.hpp"

#include <gtest/gtest.h>

#include "fixed/overflow.hpp"
#include "tests/fixed/boundary.hpp"

namespace umbra78::fixed {
namespace {

using test::Int128;

Vector3 any_vector3(test::Random& random) {
    const auto word = [&] { return wrap(random.word(), 30); };
    return {{word(), word(), word()}};
}

TEST(Vector, Examples) {
    static_assert(Vector3{{1, 2, 3}} + Vector3{{10, 20, 30}} == Vector3{{11, 22, 33}});
    static_assert(Vector3{{1, 2, 3}} - Vector3{{10, 20, 30}} == Vector3{{-9, -18, -27}});
    static_assert(-Vector3{{1, -2, 3}} == Vector3{{-1, 2, -3}});
    static_assert(Vector3{{1, 2, 3}} * -2 == Vector3{{-2, -4, -6}});
    static_assert(dot(Vector4{{1, 2, 3, 4}}, Vector4{{5, 6, 7, 8}}) == 70);
    static_assert(cross(Vector3{{1, 0, 0}}, Vector3{{0, 1, 0}}) == Vector3{{0, 0, 1}});
    static_assert(cross(Vector3{{0, 1, 0}}, Vector3{{0, 0, 1}}) == Vector3{{1, 0, 0}});
    static_assert(cross(Vector3{{0, 0, 1}}, Vector3{{1, 0, 0}}) == Vector3{{0, 1, 0}});
    static_assert(round_shift(Vector3{{5, -5, 6}}, 2, Rounding::half_up) == Vector3{{1, -1, 2}});
}

TEST(Vector, ProductsAgainst128Bits) {
    test::Random random;
    for (int i = 0; i < 50000; ++i) {
        const Vector3 a = any_vector3(random), b = any_vector3(random);
        Int128 exact = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            exact += Int128{a[k]} * b[k];
        }
        ASSERT_EQ(Int128{dot(a, b)}, exact);
        const Vector3 c = cross(a, b);
        ASSERT_EQ(c[0], a[1] * b[2] - a[2] * b[1]);
        ASSERT_EQ(c[1], a[2] * b[0] - a[0] * b[2]);
        ASSERT_EQ(c[2], a[0] * b[1] - a[1] * b[0]);
        ASSERT_EQ(cross(b, a), -c);
    }
}

TEST(Vector, OverflowIsACompileErrorAndATrap) {
    static_assert(!test::is_constant([] { return (Vector3{{INT64_MAX, 0, 0}} * 2)[0]; }));
    constexpr Vector3 max{{INT64_MAX, INT64_MAX, INT64_MAX}};
    constexpr Vector3 ones{{1, 1, 1}};
    EXPECT_DEATH(max + ones, "");
    EXPECT_DEATH(-max - ones - ones, "");
    EXPECT_DEATH(dot(max, ones), "");
    EXPECT_DEATH(cross(max, -ones - ones), "");
}

}  // namespace
}  // namespace umbra78::fixed
