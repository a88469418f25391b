// The integers of 128 bits that the tests use on 32-bit processors equal the compiler's own.
#include "tests/support/int128.hpp"

#include <gtest/gtest.h>

#include "tests/fixed/boundary.hpp"

namespace umbra78::fixed {
namespace {

using Slow = umbra78::test::Slow128<true>;
using SlowUnsigned = umbra78::test::Slow128<false>;

static_assert(Slow{-7} / 2 == -3 && Slow{-7} % 2 == -1 && (Slow{-7} >> 1) == -4);
static_assert(Slow{-1} < Slow{0} && SlowUnsigned{-1} > SlowUnsigned{0});
static_assert((SlowUnsigned{1} << 127) / 3 * 3 + 2 == (SlowUnsigned{1} << 127));

#ifdef __SIZEOF_INT128__
template <class Native, class Made>
class Int128Pair {
public:
    static Made made(Native v) {
        return {static_cast<std::uint64_t>(v >> 64), static_cast<std::uint64_t>(v)};
    }
    static void expect_same(Native a, Native b, int n) {
        const Made x = made(a), y = made(b);
        ASSERT_EQ(x + y, made(a + b));
        ASSERT_EQ(x - y, made(a - b));
        ASSERT_EQ(x * y, made(a * b));
        ASSERT_EQ(x << n, made(a << n));
        ASSERT_EQ(x >> n, made(a >> n));
        ASSERT_EQ(x & y, made(a & b));
        ASSERT_EQ(x | y, made(a | b));
        ASSERT_EQ(-x, made(-a));
        ASSERT_EQ(x < y, a < b);
        ASSERT_EQ(x == y, a == b);
        ASSERT_EQ(static_cast<int>(x), static_cast<int>(a));
        if (b == 0) return;
        ASSERT_EQ(x / y, made(a / b));
        ASSERT_EQ(x % y, made(a % b));
    }
};

TEST(Int128, SlowEqualsNative) {
    using umbra78::test::UInt128;
    test::Random random;
    const auto wide = [&] {
        const auto v = static_cast<UInt128>(static_cast<std::uint64_t>(random.word())) << 64 |
                       static_cast<std::uint64_t>(random.word());
        return v >> random.between(0, 127);
    };
    for (int k = 0; k < 20000; ++k) {
        const UInt128 a = wide(), b = wide();
        const int n = static_cast<int>(random.between(0, 127));
        Int128Pair<UInt128, SlowUnsigned>::expect_same(a, b, n);
        // Signed ones of 63 bits below the sign, so that their products do not overflow.
        const auto sign = [&](UInt128 v) {
            const auto half = static_cast<test::Int128>(v >> 66);
            return random.bits() % 2 == 0 ? half : -half;
        };
        Int128Pair<test::Int128, Slow>::expect_same(sign(a), sign(b), n % 60);
    }
}
#else
TEST(Int128, SlowEqualsNative) { GTEST_SKIP() << "this processor has no 128-bit integers"; }
#endif

}  // namespace
}  // namespace umbra78::fixed
