#include "fixed/exact.hpp"

#include <gtest/gtest.h>

#include "tests/fixed/boundary.hpp"

namespace umbra78::fixed {
namespace {

using test::Int128;

bool fits64(Int128 v) { return v >= INT64_MIN && v <= INT64_MAX; }

TEST(Exact, BoundaryPairs) {
    int left_out = 0;
    for (const std::int64_t a : test::boundary_words) {
        for (const std::int64_t b : test::boundary_words) {
            const Int128 x = a, y = b;
            if (fits64(x + y)) {
                EXPECT_EQ(Int128{add_exact(a, b)}, x + y);
            }
            if (fits64(x - y)) {
                EXPECT_EQ(Int128{subtract_exact(a, b)}, x - y);
            }
            if (fits64(x * y)) {
                EXPECT_EQ(Int128{multiply_exact(a, b)}, x * y);
            } else {
                ++left_out;
            }
        }
    }
    EXPECT_GT(left_out, 100);  // the table does reach beyond the edge
}

TEST(Exact, TrapsOneBeyondTheEdge) {
    static_assert(!test::is_constant([] { return add_exact(INT64_MAX, 1); }));
    static_assert(!test::is_constant([] { return subtract_exact(INT64_MIN, 1); }));
    static_assert(!test::is_constant([] { return multiply_exact(INT64_MIN, -1); }));
    EXPECT_DEATH(add_exact(INT64_MAX, 1), "");
    EXPECT_DEATH(add_exact(INT64_MIN, -1), "");
    EXPECT_DEATH(subtract_exact(0, INT64_MIN), "");
    EXPECT_DEATH(multiply_exact(std::int64_t{1} << 32, std::int64_t{1} << 31), "");
    EXPECT_EQ(multiply_exact(std::int64_t{-1} * (std::int64_t{1} << 32), std::int64_t{1} << 31),
              INT64_MIN);
}

}  // namespace
}  // namespace umbra78::fixed
