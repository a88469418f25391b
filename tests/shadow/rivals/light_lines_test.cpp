// The quick sign of three lines against the sign of the determinant itself.
#include "shadow/rivals/light_lines.hpp"

#include "tests/support/effort.hpp"

#include <gtest/gtest.h>

#include <random>

namespace umbra78::shadow::rivals::test {
namespace {

// Lines of every size, and of numbers that differ in size. In a direction's picture the third
// number is the longest.
class RandomLines {
public:
    explicit RandomLines(int longer) : longer_(longer) {}
    LightLine line() {
        std::array<Sum, 3> v;
        const int longest = 1 + below(offset_bits + at_light_bits - 2);
        for (Sum& number : v) number = word(below(3) == 0 ? 1 + below(longest) : longest);
        if (below(2) == 0) v[2] = v[2] << longer_;
        return LightLine(v, longer_);
    }
    // Through the meeting of a and b, but for a part of a unit or of many.
    LightLine nearly_through(const LightLine& a, const LightLine& b) {
        const Sum i = below(5) - 2, j = below(5) - 2;
        std::array<Sum, 3> v;
        for (std::size_t k = 0; k < 3; ++k) v[k] = a.v[k] * i + b.v[k] * j;
        if (below(2) == 0) v[std::size_t(below(3))] = v[0] + word(1 + below(normal_bits));
        return LightLine(v, longer_);
    }

private:
    int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
    Sum word(int bits) {
        Sum sum = 0;
        for (int k = 0; k < bits; k += 31) sum = (sum << 31) + (random_() >> 1);
        sum = sum >> (31 * ((bits + 30) / 31) - bits);
        return below(2) == 0 ? sum : Sum(0) - sum;
    }
    int longer_;
    std::mt19937 random_{1978};
};

// In a word that holds anything.
int sign_of_determinant(const LightLine& a, const LightLine& b, const LightLine& c) {
    using Wide = fixed::WideInt<10>;
    Wide det = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
        det += Wide(c.v[i]) * (Wide(a.v[j]) * Wide(b.v[k]) - Wide(a.v[k]) * Wide(b.v[j]));
    }
    return det.is_negative() ? -1 : det.is_zero() ? 0 : 1;
}

void expect_signs_of_determinants(int longer) {
    RandomLines random(longer);
    int decided = 0, near = 0, ties = 0;
    const int cases = umbra78::test::effort(200000);
    for (int n = 0; n < cases; ++n) {
        const LightLine a = random.line(), b = random.line(), any = random.line();
        const LightLine through = random.nearly_through(a, b);
        for (const LightLine* c : {&any, &through}) {
            const int quick = sign_by_leading(a, b, *c), exact = sign_by_all_bits(a, b, *c);
            ASSERT_EQ(exact, sign_of_determinant(a, b, *c)) << n;
            ASSERT_TRUE(quick == 0 || quick == exact) << n;
            ++(quick != 0 ? decided : exact != 0 ? near : ties);
        }
    }
    EXPECT_GT(decided, cases / 2);
    EXPECT_GT(near, cases / 100);
    EXPECT_GT(ties, cases / 100);
}

TEST(SignOfThreeLines, IsThatOfTheDeterminantWhereItsLeadingBitsDecide) {
    expect_signs_of_determinants(0);
    expect_signs_of_determinants(offset_is_longer);
}

// Three lines of a direction's picture that bound a small triangle far from its centre: the offsets
// have all the bits, and leave those that decide to the other numbers.
TEST(SignOfThreeLines, IsDecidedByLeadingBitsFarFromTheCentre) {
    constexpr std::int64_t place = std::int64_t{1} << (word_bits - 1), small = 1 << 16;
    const auto through = [](std::int64_t a, std::int64_t b, std::int64_t x, std::int64_t y,
                            int longer) {
        return LightLine({Sum(a), Sum(b), Sum(-(a * x + b * y))}, longer);
    };
    for (const int longer : {0, offset_is_longer}) {
        const LightLine a = through(small, 3, place, place, longer),
                        b = through(-5, small, place, place, longer),
                        c = through(small, small, place + small, place, longer);
        EXPECT_EQ(sign_by_all_bits(a, b, c), -1);
        EXPECT_EQ(sign_by_leading(a, b, c), longer == 0 ? 0 : -1);
    }
}

TEST(SignOfThreeLines, OfSmallNumbersIsExact) {
    const LightLine x({Sum(1), Sum(0), Sum(0)}), y({Sum(0), Sum(1), Sum(0)}),
        z({Sum(0), Sum(0), Sum(1)});
    EXPECT_EQ(sign_by_leading(x, y, z), 1);
    EXPECT_EQ(sign_by_leading(y, x, z), -1);
    EXPECT_EQ(sign_by_all_bits(x, y, z), 1);
    EXPECT_EQ(sign_by_all_bits(y, x, z), -1);
}

}  // namespace
}  // namespace umbra78::shadow::rivals::test
