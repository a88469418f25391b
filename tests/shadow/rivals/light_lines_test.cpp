// The quick sign of three lines against the sign of the determinant itself.
#include "shadow/rivals/light_lines.hpp"

#include "tests/support/effort.hpp"

#include <gtest/gtest.h>

#include <random>

namespace umbra78::shadow::rivals::test {
namespace {

// Lines of every size, and of numbers that differ in size.
class RandomLines {
public:
    LightLine line() {
        LightLine l;
        const int longest = 1 + below(normal_bits);
        for (Sum& number : l.v) number = word(below(3) == 0 ? 1 + below(longest) : longest);
        return with_leading(l);
    }
    // Through the meeting of a and b, but for a part of a unit or of many.
    LightLine nearly_through(const LightLine& a, const LightLine& b) {
        const Sum i = below(5) - 2, j = below(5) - 2;
        LightLine l;
        for (std::size_t k = 0; k < 3; ++k) l.v[k] = a.v[k] * i + b.v[k] * j;
        if (below(2) == 0) l.v[std::size_t(below(3))] = l.v[0] + word(1 + below(normal_bits));
        return with_leading(l);
    }

private:
    static LightLine with_leading(LightLine l) {
        l.leading = leading_of(l.v);
        return l;
    }
    int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
    Sum word(int bits) {
        Sum sum = 0;
        for (int k = 0; k < bits; k += 31) sum = (sum << 31) + (random_() >> 1);
        sum = sum >> (31 * ((bits + 30) / 31) - bits);
        return below(2) == 0 ? sum : Sum(0) - sum;
    }
    std::mt19937 random_{1978};
};

TEST(SignOfThreeLines, IsThatOfTheDeterminantWhereItsLeadingBitsDecide) {
    RandomLines random;
    int decided = 0, near = 0, ties = 0;
    const int cases = umbra78::test::effort(200000);
    for (int n = 0; n < cases; ++n) {
        const LightLine a = random.line(), b = random.line(), any = random.line();
        const LightLine through = random.nearly_through(a, b);
        for (const LightLine* c : {&any, &through}) {
            const int quick = sign_by_leading(a, b, *c), exact = sign_by_all_bits(a, b, *c);
            ASSERT_TRUE(quick == 0 || quick == exact) << n;
            ++(quick != 0 ? decided : exact != 0 ? near : ties);
        }
    }
    EXPECT_GT(decided, cases / 2);
    EXPECT_GT(near, cases / 100);
    EXPECT_GT(ties, cases / 100);
}

TEST(SignOfThreeLines, IsLeftOpenWithoutLeadingBits) {
    const LightLine x{{Sum(1), Sum(0), Sum(0)}, {}}, y{{Sum(0), Sum(1), Sum(0)}, {}},
        z{{Sum(0), Sum(0), Sum(1)}, {}};
    EXPECT_EQ(sign_by_leading(x, y, z), 0);
    EXPECT_EQ(sign_by_all_bits(x, y, z), 1);
    EXPECT_EQ(sign_by_all_bits(y, x, z), -1);
}

}  // namespace
}  // namespace umbra78::shadow::rivals::test
